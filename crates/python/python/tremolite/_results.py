"""Result folders: tables, fields, verdict and trust. Everything is read from files, also while the run goes on."""

from __future__ import annotations

import csv
import json
import os
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np

from ._tremolite import Error, check_folder, read_table, read_vtu, write_comparison, write_page


class Record(Mapping[str, Any]):
    """A JSON object whose fields are attributes as well: `summary.model.elements`, `summary["model"]["elements"]`."""

    def __init__(self, fields: Mapping[str, Any]) -> None:
        self._fields = dict(fields)

    def __getitem__(self, name: str) -> Any:
        return _object(self._fields[name])

    def __getattr__(self, name: str) -> Any:
        try:
            return self[name]
        except KeyError:
            raise AttributeError(f"there is no {name!r}; there are {', '.join(self._fields)}") from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._fields)

    def __len__(self) -> int:
        return len(self._fields)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._fields]

    def __repr__(self) -> str:
        return f"Record({self._fields!r})"

    def to_dict(self) -> dict[str, Any]:
        """The object as plain dicts and lists."""
        return self._fields


def _object(value: Any) -> Any:
    if isinstance(value, dict):
        return Record(value)
    if isinstance(value, list):
        return [_object(one) for one in value]
    return value


class Trust(Sequence[Record]):
    """The checks of a run: each has id, name, value, limit, unit, pass_ and note."""

    def __init__(self, lines: Iterable[Mapping[str, Any]]) -> None:
        # `pass` is a word of Python's.
        self._lines = [Record({**line, "pass_": line.get("pass")}) for line in lines]

    def __getitem__(self, at: Any) -> Any:
        if isinstance(at, str):
            for line in self._lines:
                if line["id"] == at:
                    return line
            raise KeyError(f"no check is called {at!r}; there are {', '.join(line['id'] for line in self._lines)}")
        return self._lines[at]

    def __len__(self) -> int:
        return len(self._lines)

    @property
    def failed(self) -> list[Record]:
        """Those that failed."""
        return [line for line in self._lines if not line["pass_"] and not line.get("not_applicable", False)]

    def __repr__(self) -> str:
        apply = [line for line in self._lines if not line.get("not_applicable", False)]
        return "\n".join([*map(_in_words, apply), f"{len(self._lines) - len(apply)} more do not apply"])


def _in_words(line: Record) -> str:
    passed = "ok  " if line["pass_"] else "FAIL"
    return f"{passed} {line['name']}: {line['value']:.3g} {line.get('unit', '')} (limit {line['limit']:g})"


class Table(Mapping[str, np.ndarray]):
    """A table of histories: name of a column -> array (rows,). `units` and `of` (whose a column is) go by the same names.

    `table.of_monitor("A")` holds the columns of one subject under the names of their quantities; `to_pandas()` makes a DataFrame.
    """

    def __init__(
        self, columns: Mapping[str, np.ndarray], units: Mapping[str, str], of: Mapping[str, str], quantities: Mapping[str, str]
    ) -> None:
        self._columns, self.units, self.of, self._quantities = dict(columns), dict(units), dict(of), dict(quantities)

    @classmethod
    def read(cls, path: str | os.PathLike[str]) -> Table:
        """Reads a table that a run wrote or is writing."""
        headers, arrays, _ = read_table(path)
        names = [name for name, *_ in headers]
        return cls(
            dict(zip(names, arrays, strict=True)),
            {name: unit for name, _, unit, _ in headers},
            {name: whose for name, _, _, whose in headers},
            {name: quantity for name, quantity, _, _ in headers},
        )

    def __getitem__(self, name: str) -> np.ndarray:
        if name not in self._columns:
            raise KeyError(f"no column is called {name!r}; there are {', '.join(self._columns)}")
        return self._columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    def __getattr__(self, name: str) -> np.ndarray:
        columns: dict[str, np.ndarray] = self.__dict__.get("_columns", {})
        if name in columns:
            return columns[name]
        raise AttributeError(f"there is no column {name!r}; there are {', '.join(columns)}")

    def subjects(self) -> list[str]:
        """Whose columns there are: names of monitors, pairs of them, groups, interfaces."""
        return list(dict.fromkeys(whose for whose in self.of.values() if whose))

    def of_subject(self, name: str) -> Table:
        """The columns of one, under the names of their quantities, behind those of nobody (the time)."""
        wanted = [column for column in self._columns if self.of[column] in ("", name)]
        if not any(self.of[column] == name for column in wanted):
            raise KeyError(f"there is no {name!r}; there are {', '.join(self.subjects())}")
        called = {column: self._quantities[column] for column in wanted}
        return Table(
            {called[column]: self._columns[column] for column in wanted},
            {called[column]: self.units[column] for column in wanted},
            {called[column]: self.of[column] for column in wanted},
            {called[column]: self._quantities[column] for column in wanted},
        )

    def to_pandas(self, index: str | None = "time") -> Any:
        """The table as a DataFrame, by its time if it has one, with the units in `attrs["units"]`. Needs pandas."""
        import pandas

        frame = pandas.DataFrame(self._columns)
        if index is not None and index in frame:
            frame = frame.set_index(index)
        frame.attrs["units"] = dict(self.units)
        return frame

    def to_stream(self, *columns: str, station: str = "TREM") -> Any:
        """Columns as an ObsPy stream, from time 0. Needs ObsPy, and equal steps of time."""
        from obspy import Stream, Trace

        time = self["time"]
        steps = np.diff(time)
        if len(time) < 2 or np.ptp(steps) > 1e-6 * steps.mean():
            raise Error("the rows are not equally spaced in time, as ObsPy wants them; leave out the last row, or interpolate")
        traces = []
        for name in columns or [c for c in self if c != "time"]:
            trace = Trace(np.array(self[name]))
            trace.stats.station, trace.stats.channel, trace.stats.delta = station, name, float(steps.mean())
            traces.append(trace)
        return Stream(traces)

    def __repr__(self) -> str:
        rows = len(next(iter(self._columns.values()), ()))
        return f"<Table of {rows} rows: {', '.join(self._columns)}>"


class Monitors(Mapping[str, Table]):
    """monitors.csv by monitor: `monitors["A"].ux`; pairs of monitors as `monitors["A-B"]`. All of it is `monitors.table`."""

    def __init__(self, table: Table) -> None:
        self.table = table

    def __getitem__(self, name: str) -> Table:
        return self.table.of_subject(name)

    def __iter__(self) -> Iterator[str]:
        return iter(self.table.subjects())

    def __len__(self) -> int:
        return len(self.table.subjects())

    def __repr__(self) -> str:
        return f"<monitors {', '.join(self)}>"


@dataclass(frozen=True)
class Grid:
    """A field file. `points` (n, 3) [m]; `cells`, `offsets` and `types` as VTK has them; arrays of points and cells by name, with
    `units`. Tensors have VTK's order xx, yy, zz, xy, yz, xz."""

    points: np.ndarray
    cells: np.ndarray
    offsets: np.ndarray
    types: np.ndarray
    point_data: Mapping[str, np.ndarray]
    cell_data: Mapping[str, np.ndarray]
    field_data: Mapping[str, np.ndarray]
    units: Mapping[str, str]
    time: float | None

    @classmethod
    def read(cls, path: str | os.PathLike[str]) -> Grid:
        """Reads a VTU file."""
        made = read_vtu(path)
        return cls(cells=made.pop("connectivity"), **made)

    def in_group(self, name: str) -> np.ndarray:
        """Whether each cell (n,) is in a group."""
        array = self.cell_data.get(f"group:{name}")
        if array is None:
            names = [key.removeprefix("group:") for key in self.cell_data if key.startswith("group:")]
            raise KeyError(f"no group is called {name!r}; there are {', '.join(names)}")
        return array.astype(bool)

    def to_pyvista(self) -> Any:
        """The grid as a `pyvista.UnstructuredGrid`. Needs PyVista."""
        import pyvista

        starts = np.concatenate([[0], self.offsets[:-1]])
        cells = np.insert(self.cells, starts, np.diff(self.offsets, prepend=0))
        grid = pyvista.UnstructuredGrid(cells, self.types, np.array(self.points))
        for name, array in self.point_data.items():
            grid.point_data[name] = np.array(array)
        for name, array in self.cell_data.items():
            grid.cell_data[name] = np.array(array)
        return grid

    def to_meshio(self) -> Any:
        """The grid as meshio's. Needs meshio."""
        import meshio

        names = {3: "line", 5: "triangle", 9: "quad", 10: "tetra", 12: "hexahedron", 13: "wedge", 14: "pyramid", 1: "vertex"}
        starts = np.concatenate([[0], self.offsets[:-1]]).astype(int)
        # Runs of one type, so that cells keep their order.
        edges = np.flatnonzero(np.diff(self.types.astype(int))) + 1
        blocks, picks = [], []
        for run in np.split(np.arange(len(self.types)), edges):
            if len(run):
                size = int(self.offsets[run[0]] - starts[run[0]])
                blocks.append((names[int(self.types[run[0]])], self.cells[starts[run[0]] :][: size * len(run)].reshape(-1, size)))
                picks.append(run)
        cell_data = {name: [array[run] for run in picks] for name, array in self.cell_data.items()}
        return meshio.Mesh(self.points, blocks, point_data=dict(self.point_data), cell_data=cell_data)


@dataclass(frozen=True)
class FieldFile:
    """A field file that was written, and its time [s]."""

    time: float
    path: Path

    def read(self) -> Grid:
        """Its content."""
        return Grid.read(self.path)

    def to_pyvista(self) -> Any:
        """Its content for PyVista."""
        return self.read().to_pyvista()

    def to_meshio(self) -> Any:
        """Its content for meshio."""
        return self.read().to_meshio()


class Fields(Sequence[FieldFile]):
    """The field files of a run in the order of time; `at(time)` is the nearest."""

    def __init__(self, files: Iterable[FieldFile]) -> None:
        self._files = list(files)

    @classmethod
    def of(cls, pvd: Path) -> Fields:
        """Those that a PVD file lists; none where there is no such file."""
        if not pvd.exists():
            return cls([])
        sets = ElementTree.parse(pvd).getroot().iter("DataSet")
        return cls(FieldFile(float(one.attrib["timestep"]), pvd.parent / one.attrib["file"]) for one in sets)

    def __getitem__(self, at: Any) -> Any:
        return self._files[at]

    def __len__(self) -> int:
        return len(self._files)

    @property
    def times(self) -> np.ndarray:
        """Their times (n,) [s]."""
        return np.array([one.time for one in self._files])

    def at(self, time: float) -> FieldFile:
        """The file nearest to a time [s]."""
        if not self._files:
            raise Error("the run wrote no such files; [output] of the case says which and when")
        return self._files[int(np.argmin(np.abs(self.times - time)))]


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
        return str(self.summary["verdict"])

    @property
    def findings(self) -> list[Record]:
        """What became of each structure: id, group, severity, headline, text and numbers."""
        return list(self.summary["findings"])

    @property
    def trust(self) -> Trust:
        """The checks that say how far to trust it."""
        return Trust(self.summary.to_dict()["trust"])

    @property
    def case(self) -> Any:
        """The case as it was run."""
        from ._tremolite import Case

        return Case(self.path / "case.toml")

    def table(self, name: str) -> Table:
        """A table of numbers by its name: "monitors", "energy", "damage", "interfaces", "motion", "spectra", "depth", "free_field" ..."""
        path = self.path / f"{name}.csv"
        if not path.exists():
            there = ", ".join(sorted(one.stem for one in self.path.glob("*.csv"))) or "none"
            raise Error(f"{self.path} has no {name}.csv; there are {there}")
        return Table.read(path)

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
        with open(self.path / f"{name}.csv", newline="", encoding="utf-8") as file:
            lines = csv.reader(file)
            heads = [_HEAD.fullmatch(head.strip()) for head in next(lines)]
            names = [head.group(1) if head else "" for head in heads]
            return [dict(zip(names, map(_number, line), strict=False)) for line in lines]

    def units_of(self, name: str) -> dict[str, str]:
        """Units of the columns of a table, by name."""
        with open(self.path / f"{name}.csv", newline="", encoding="utf-8") as file:
            heads = [_HEAD.fullmatch(head.strip()) for head in next(csv.reader(file))]
        return {head.group(1): head.group(2) or "" for head in heads if head}

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


_HEAD = re.compile(r"([^\[]*?)\s*(?:\[(.*)\])?")


def _number(text: str) -> Any:
    try:
        return float(text)
    except ValueError:
        return text
