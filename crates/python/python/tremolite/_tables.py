"""Tables of histories."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from ._tremolite import Error, read_table


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


class OwnTables(Mapping[str, Table]):
    """Tables that a script recorded, by their names."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder

    def __getitem__(self, name: str) -> Table:
        path = self._folder / f"{name}.csv"
        if not path.is_file():
            raise KeyError(f"no table is called {name!r}; there are {', '.join(self) or 'none'}")
        return Table.read(path)

    def __iter__(self) -> Iterator[str]:
        return iter(sorted(path.stem for path in self._folder.glob("*.csv")))

    def __len__(self) -> int:
        return len(list(iter(self)))

    def __repr__(self) -> str:
        return f"<own tables {', '.join(self) or 'none'}>"
