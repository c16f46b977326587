"""Result folders: tables, fields, verdict and trust. Everything is read from files, also while the run goes on."""

from __future__ import annotations

import csv
import json
import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from ._fields import Fields
from ._record import Checks, Record
from ._rows import heads, rows
from ._tables import Monitors, OwnTables, Table
from ._tremolite import Error, check_folder, differences, write_comparison, write_page


class Result:
    """The results in a folder, of a run that has ended, was stopped or goes on. Nothing is kept: every access reads the file."""

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self.path = Path(path)
        check_folder(self.path)

    @property
    def summary(self) -> Record:
        """summary.json. Raises `Error` while the run has none yet."""
        try:
            return Record(json.loads((self.path / "summary.json").read_text(encoding="utf-8")))
        except FileNotFoundError:
            raise Error(f"{self.path} has no summary yet: the run goes on, or was broken off before it could write one") from None

    @property
    def title(self) -> str:
        """The case's title."""
        return str(self.summary["title"])

    @property
    def status(self) -> str:
        """How it ended, "done", "failed" or "stopped"; "running" while there is no summary."""
        return str(self.summary["status"]) if (self.path / "summary.json").exists() else "running"

    @property
    def verdict(self) -> str:
        """What came of the run and of each structure, in a few sentences."""
        # The summary speaks of the command's option, whoever ran it.
        return str(self.summary["verdict"]).replace("go on with --resume", "go on with resume=True")

    @property
    def state(self) -> Record:
        """Whether the lining withstands: `class_` is "withstands", "not_judged", "damaged" or "fails", `reasons` say why."""
        return self._judgement("state")

    @property
    def reliance(self) -> Record:
        """How far to use the results: `class_` is "sound", "with_reservations" or "not_to_be_used", `reasons` say why."""
        return self._judgement("reliance")

    def _judgement(self, name: str) -> Record:
        summary = self.summary.to_dict()
        if name not in summary:
            raise Error(f"{self.path} is of an older version, without {name}")
        return Record(summary[name])

    @property
    def findings(self) -> list[Record]:
        """What became of each structure: id, group, severity, headline, text and numbers."""
        return list(self.summary["findings"])

    @property
    def checks(self) -> Checks:
        """The checks of the run: each compares a number with its limit."""
        return Checks(self.summary.to_dict()["checks"])

    @property
    def case(self) -> Any:
        """The case as it was run."""
        from ._tremolite import Case

        return Case(self.path / "case.toml")

    def table(self, name: str) -> Table:
        """A table of numbers by its name: "monitors", "energy", "damage", "interfaces", "motion", "spectra", "depth", "free_field" ..."""
        path = self.path / f"{name}.csv"
        if not path.exists():
            raise Error(f"{self.path} has no {name}.csv; there are {self._tables()}")
        return Table.read(path)

    def _tables(self) -> str:
        return ", ".join(sorted(one.stem for one in self.path.glob("*.csv"))) or "none"

    @property
    def monitors(self) -> Monitors:
        """Histories of the monitors."""
        return Monitors(self.table("monitors"))

    @property
    def energy(self) -> Table:
        """The energy balance [J]."""
        return self.table("energy")

    @property
    def damage(self) -> Table:
        """Damage over time."""
        return self.table("damage")

    @property
    def spectra(self) -> Table:
        """Response spectra of the motion and the monitors."""
        return self.table("spectra")

    def rows(self, name: str) -> list[dict[str, Any]]:
        """A table with words in it, a dict a row: "stages", "sections", "bolts". Numbers are float; units stand in `units_of(name)`."""
        return rows(self._lines(name), _WORDS.get(name, ("name",)))

    def units_of(self, name: str) -> dict[str, str]:
        """Units of the columns of a table, by name."""
        return heads(self._lines(name)[0])

    def _lines(self, name: str) -> list[list[str]]:
        path = self.path / f"{name}.csv"
        if not path.exists():
            raise Error(f"{self.path} has no {name}.csv; there are {self._tables()}")
        text = path.read_text(encoding="utf-8")
        # A line that is being written may lack digits.
        return list(csv.reader(text[: text.rfind("\n") + 1].splitlines(keepends=True)))

    @property
    def own(self) -> OwnTables:
        """The tables that the script's callbacks and observers recorded, by their names: `result.own["roof"].u`."""
        return OwnTables(self.path / "own")

    @property
    def fields(self) -> Fields:
        """Field files of the earthquake."""
        return Fields.of(self.path / "fields.pvd")

    @property
    def stage_fields(self) -> Fields:
        """What stands at the end of each stage."""
        return Fields.of(self.path / "stages.pvd")

    @property
    def interface_fields(self) -> Fields:
        """Interfaces with what their pairs did."""
        return Fields.of(self.path / "interfaces.pvd")

    def differences(self, other: Result | str | os.PathLike[str]) -> list[str]:
        """Files, and facts of summary.json, whose bytes another result does not have. What may differ between runs of
        the same bits is left out: the clock, the machine, threads and ranks, checkpoints, the page."""
        return differences(self.path, other.path if isinstance(other, Result) else Path(other))

    def page(self, language: str | None = None) -> Path:
        """Writes figures and report.html again, in "en" or "zh", and returns the page's path."""
        return Path(write_page(self.path, language))

    def __repr__(self) -> str:
        return f"Result({str(self.path)!r}, {self.status})"

    def _repr_html_(self) -> str:
        from . import _notebook

        return _notebook.result(self) if self.status != "running" else f"<b>{self.path}</b> (running)"


def compare(results: Sequence[Result | str | os.PathLike[str]], page: str | os.PathLike[str], language: str | None = None) -> Path:
    """Sets two runs or more beside one another on a page; the first is that which the others are compared with. Returns its path."""
    if len(results) < 2:
        raise Error("a comparison has two results and more")
    folders = [one.path if isinstance(one, Result) else Path(one) for one in results]
    for folder in folders:
        check_folder(folder)
    write_comparison(folders, Path(page), language)
    return Path(page)



#: Columns that hold words, whatever they look like, by table.
_WORDS = {"bolts": ("name", "state", "stage"), "sections": ("lining", "when"), "utilisation": ("lining", "when")}
