"""Field files."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np

from ._tremolite import Error, read_vtu


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
        """Reads a VTU file, or all pieces of a `.pvtu` file as one grid."""
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
