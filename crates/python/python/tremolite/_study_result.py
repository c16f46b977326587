"""What came out of a study, read from its folder."""

from __future__ import annotations

import csv
import json
import math
import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from ._record import Record
from ._results import Result
from ._rows import heads, rows
from ._tremolite import Error, write_study_page

#: Columns that hold words, whatever they look like.
_WORDS = frozenset(["run", "sample", "record", "level", "status", "why", "program"])


class StudyTable(Sequence[dict[str, Any]]):
    """A table with a row a run, each a dict: words are text, numbers float in the unit of `units`, and NaN where there is none.

    `table["drift"]` is a column, an array of numbers or a list of words; `table[0]` a row; `text` the CSV file; `to_pandas()` a DataFrame
    by run.
    """

    def __init__(self, text: str) -> None:
        self.text = text
        lines = list(csv.reader(text.splitlines(keepends=True)))
        self.units = heads(lines[0]) if lines else {}
        self._rows = rows(lines, _WORDS)

    def __getitem__(self, at: Any) -> Any:
        if not isinstance(at, str):
            return self._rows[at]
        if at not in self.units:
            raise KeyError(f"no column is called {at!r}; there are {', '.join(self.units)}")
        column = [row[at] for row in self._rows]
        return column if any(isinstance(cell, str) for cell in column) else np.array(column, dtype=float)

    def __len__(self) -> int:
        return len(self._rows)

    def to_pandas(self) -> Any:
        """The table as a DataFrame by run, with the units in `attrs["units"]`. Needs pandas."""
        import pandas

        frame = pandas.DataFrame(self._rows, columns=list(self.units)).set_index("run")
        frame.attrs["units"] = dict(self.units)
        return frame

    def __repr__(self) -> str:
        return f"<StudyTable of {len(self)} runs: {', '.join(self.units)}>"


class Curve(Record):
    """A fragility curve: `fit.theta`, `fit.beta`, `fit.covariance`, `bounds`, `shares`; all of study.json. Intensities, theta
    among them, are in `unit`, that of the levels; times `unit_value` they are in SI."""

    def probability(self, intensity: Any, *, units: str | None = None) -> Any:
        """The probability at intensities, a number or an array in `unit`, as theta is; in SI with `units="SI"`, as the table's columns are.
        Raises `Error` where there is no curve, and says why."""
        if units not in (None, "SI"):
            raise Error(f"units is \"SI\", or left out for intensities in {self['unit']}")
        if self["fit"] is None:
            raise Error(f"{self['measure']} above {self['above']:g} has no curve: {self['no_curve']}")
        theta, beta = self["fit"]["theta"], self["fit"]["beta"]
        at = np.asarray(intensity, dtype=float) / (1.0 if units is None else self["unit_value"])
        normal = np.vectorize(lambda x: 0.5 * math.erfc(-math.log(x / theta) / beta / math.sqrt(2.0)) if x > 0.0 else 0.0, otypes=[float])
        found = normal(at)
        return found if at.ndim else float(found)

    def __repr__(self) -> str:
        head = f"P({self['measure']} > {self['above']:g}) by {self['by']}"
        fit = self["fit"]
        return f"<{head}: median {fit['theta']:.4g} {self['unit']}, beta {fit['beta']:.3f}>" if fit else f"<{head}: no curve>"


class StudyResult:
    """The results in a study's folder. Nothing is kept: every access reads the files, also while the study goes on."""

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self.path = Path(path)

    def _text(self, name: str) -> str:
        try:
            return (self.path / name).read_text(encoding="utf-8")
        except FileNotFoundError:
            raise Error(f"{self.path} has no {name} yet: run the study, or gather() what its shares have done") from None

    @property
    def table(self) -> StudyTable:
        """A row a run: values, factor, intensities, measures in SI, how it ended and why (`study.csv`)."""
        return StudyTable(self._text("study.csv"))

    def to_pandas(self) -> Any:
        """The table as a DataFrame by run. Needs pandas."""
        return self.table.to_pandas()

    @property
    def summary(self) -> Record:
        """study.json: runs, results over records, tornados, ranks, fragilities."""
        return Record(json.loads(self._text("study.json")))

    @property
    def fragilities(self) -> list[Curve]:
        """Fragility curves, one for each limit."""
        return [Curve(one) for one in self.summary.to_dict()["fragilities"]]

    def fragility(self, measure: str, above: float | None = None) -> Curve:
        """The fragility curve of a measure, and of one limit where it has several."""
        all_of = self.fragilities
        found = [one for one in all_of if one["measure"] == measure and above in (None, one["above"])]
        if len(found) != 1:
            there = ", ".join(f"{one['measure']} above {one['above']:g}" for one in all_of) or "none"
            raise Error(f"{len(found) or 'no'} curves are of {measure!r}{'' if above is None else f' above {above:g}'}; there are {there}")
        return found[0]

    def run(self, name: str) -> Result:
        """The results of one run, by its name in the table."""
        return Result(self.path / "runs" / name / "results")

    def page(self, language: str | None = None) -> Path:
        """Writes figures and study.html again, in "en" or "zh", and returns the page's path."""
        return Path(write_study_page(self.path, language))

    def __repr__(self) -> str:
        return f"StudyResult({str(self.path)!r})"
