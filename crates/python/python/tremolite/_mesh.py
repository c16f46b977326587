"""Meshes in memory."""

from __future__ import annotations

import os
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ._tremolite import Error, mesh_quality, read_mesh, sound_mesh, write_mesh

#: Element by meshio's name of a block, with the number of its corner nodes.
_OF_MESHIO = {
    "hexahedron": ("hex8", 8),
    "hexahedron20": ("hex8", 8),
    "hexahedron24": ("hex8", 8),
    "hexahedron27": ("hex8", 8),
    "wedge": ("wedge6", 6),
    "wedge15": ("wedge6", 6),
    "wedge18": ("wedge6", 6),
    "pyramid": ("pyramid5", 5),
    "pyramid13": ("pyramid5", 5),
    "pyramid14": ("pyramid5", 5),
    "tetra": ("tet4", 4),
    "tetra10": ("tet4", 4),
}
#: Beginnings of meshio's names of blocks that are no solids.
_FLAT = ("vertex", "line", "triangle", "quad", "polygon")
_TO_MESHIO = {"hex8": "hexahedron", "wedge6": "wedge", "pyramid5": "pyramid", "tet4": "tetra"}


@dataclass(frozen=True)
class Mesh:
    """A mesh of solid elements.

    points: (nodes, 3) [m], z up.
    cells: blocks of (kind, (elements, nodes of the kind)): indices of nodes from 0, in VTK's order of nodes. Kinds are "hex8", "wedge6",
        "pyramid5" and "tet4". Elements are numbered from 0 through all blocks.
    groups: name -> (n,) indices of elements. An element may be in several.
    faces: name -> (n, 2) element and side, sides from 0 in the order of VTK's faces.
    named_points: name -> x, y, z [m].

    A dict of blocks is taken as well. Raises `Error` where an array has another shape.
    """

    points: np.ndarray
    cells: Sequence[tuple[str, np.ndarray]]
    groups: Mapping[str, np.ndarray] = field(default_factory=dict)
    faces: Mapping[str, np.ndarray] = field(default_factory=dict)
    named_points: Mapping[str, Sequence[float]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        blocks = self.cells.items() if isinstance(self.cells, Mapping) else self.cells
        made: dict[str, Any] = {
            "points": _array(self.points, "points", float, 3),
            "cells": [(str(kind), _array(block, f"the block {kind}", np.int64, None)) for kind, block in blocks],
            "groups": {str(name): _indices(group, f"the group {name}") for name, group in self.groups.items()},
            "faces": {str(name): _array(sides, f"the faces {name}", np.int64, 2) for name, sides in self.faces.items()},
            "named_points": {str(name): tuple(map(float, point)) for name, point in self.named_points.items()},
        }
        count = sum(len(block) for _, block in made["cells"])
        for name, group in self.groups.items():
            given = np.asarray(group)
            if given.dtype == bool and given.shape != (count,):
                raise Error(f"the group {name} has a truth for each of {given.size}, where the mesh has {count} elements")
        for name, value in made.items():
            object.__setattr__(self, name, value)

    def __len__(self) -> int:
        return sum(len(block) for _, block in self.cells)

    def __repr__(self) -> str:
        names = ", ".join(self.groups)
        return f"<Mesh of {len(self)} elements, {len(self.points)} nodes; groups: {names}>"

    @classmethod
    def read(cls, path: str | os.PathLike[str]) -> Mesh:
        """Reads a file of Gmsh, Abaqus, FLAC3D, ANSYS or VTK, told by its content. What had to be mended is warned of."""
        mesh, notes = read_mesh(path)
        for note in notes:
            warnings.warn(f"{os.fspath(path)}: {note}", stacklevel=2)
        return mesh

    def write(self, path: str | os.PathLike[str]) -> None:
        """Writes a file in the format of its ending, as `tremolite mesh convert` does."""
        for note in write_mesh(self, path):
            warnings.warn(f"{os.fspath(path)}: {note}", stacklevel=2)

    def sound(self) -> tuple[Mesh, list[str]]:
        """The mesh as a run takes it (mirrored elements renumbered, unused nodes left out), and what was done, a sentence each."""
        return sound_mesh(self)

    @classmethod
    def from_meshio(cls, mesh: Any) -> Mesh:
        """A mesh of meshio's: all blocks of solids, by their corners; groups by physical names, cell sets, or else by number.

        Quadrilaterals and triangles in a cell set or with a physical name become named faces of the solids beside them. Raises `Error`
        where there are no solids, or solids of a kind that no run knows. Groups without elements, and surface cells that lie on no
        solid, are left out.
        """
        blocks: list[tuple[str, np.ndarray]] = []
        first: list[int | None] = []
        count = 0
        for block in mesh.cells:
            kind = _OF_MESHIO.get(block.type)
            if kind is None and not block.type.startswith(_FLAT):
                some = len(block.data)
                raise Error(f"the mesh has {some} cells of the kind {block.type}, which no run knows; take them out or divide them")
            first.append(None if kind is None else count)
            if kind is not None:
                blocks.append((kind[0], np.asarray(block.data)[:, : kind[1]]))
                count += len(block.data)
        if not blocks:
            there = ", ".join(sorted({block.type for block in mesh.cells})) or "no cells"
            raise Error(f"the mesh has no solid elements, only {there}; give hexahedra, wedges, pyramids or tetrahedra")
        groups: dict[str, list[np.ndarray]] = {}
        surfaces: dict[str, list[np.ndarray]] = {}
        for name, members in _sets(mesh):
            for place, inside in enumerate(members):
                if inside is None or len(inside) == 0:
                    continue
                start, block = first[place], mesh.cells[place]
                if start is not None:
                    groups.setdefault(name, []).append(start + np.asarray(inside, dtype=np.int64))
                elif block.type.startswith(("quad", "triangle")):
                    corners = 4 if block.type.startswith("quad") else 3
                    surfaces.setdefault(name, []).append(np.asarray(block.data)[inside, :corners])
        made = {name: np.unique(np.concatenate(parts)) for name, parts in groups.items()}
        if not made:
            made = {"all": np.arange(count)}
        points = np.asarray(mesh.points, dtype=float)
        faces = _faces(blocks, surfaces) if surfaces else {}
        return cls(points, blocks, made, faces)

    def to_meshio(self) -> Any:
        """The mesh as meshio's, with its groups as cell sets. Needs meshio."""
        import meshio

        cells = [(_TO_MESHIO[kind], block) for kind, block in self.cells]
        starts = np.cumsum([0, *(len(block) for _, block in self.cells)])
        sets = {
            name: [group[(group >= a) & (group < b)] - a for a, b in zip(starts[:-1], starts[1:], strict=True)]
            for name, group in self.groups.items()
        }
        return meshio.Mesh(self.points, cells, cell_sets=sets)

    def nodes_of(self, group: str) -> np.ndarray:
        """The nodes (n,) of a group's elements, ascending."""
        inside = self._group(group)
        start, found = 0, []
        for _, block in self.cells:
            own = inside[(inside >= start) & (inside < start + len(block))] - start
            found.append(block[own].ravel())
            start += len(block)
        return np.unique(np.concatenate(found))

    def nodes_near(self, point: Sequence[float], within: float) -> np.ndarray:
        """The nodes (n,) at most `within` [m] from a point [m], ascending."""
        return np.flatnonzero(np.linalg.norm(self.points - np.asarray(point, dtype=float), axis=1) <= within)

    @property
    def centroids(self) -> np.ndarray:
        """The mean of each element's nodes: (elements, 3) [m]."""
        return np.concatenate([self.points[block].mean(axis=1) for _, block in self.cells])

    @property
    def volumes(self) -> np.ndarray:
        """The volume (elements,) [m³] of each element."""
        return mesh_quality(self)[:, 0]

    @property
    def quality(self) -> np.ndarray:
        """The scaled Jacobian (elements,) of each element: 1 of a brick, 0 of a flat one."""
        return mesh_quality(self)[:, 1]

    def _group(self, name: str) -> np.ndarray:
        if name not in self.groups:
            raise Error(f"no group is called {name!r}; there are {', '.join(self.groups)}")
        return self.groups[name]


def _array(given: Any, what: str, kind: Any, columns: int | None) -> np.ndarray:
    made = np.ascontiguousarray(given)
    if np.dtype(kind) == np.int64 and made.size and not np.issubdtype(made.dtype, np.integer):
        raise Error(f"{what} holds {made.dtype}, not whole numbers")
    made = made.astype(kind, copy=False)
    if made.ndim != 2 or (columns is not None and made.shape[1] != columns):
        raise Error(f"{what} has the shape {made.shape}; it should be (n, {columns or 'nodes of an element'})")
    return made


def _indices(given: Any, what: str) -> np.ndarray:
    made = np.asarray(given)
    if made.dtype == bool:
        made = np.flatnonzero(made)
    if made.ndim != 1 or (made.size and not np.issubdtype(made.dtype, np.integer)):
        raise Error(f"{what} should be a list of indices of elements, or a truth for each")
    return np.ascontiguousarray(made, dtype=np.int64)


def _sets(mesh: Any) -> list[tuple[str, list[Any]]]:
    """Named sets of a meshio mesh: an array of indices, or None, for each block."""
    sets = [(name, list(members)) for name, members in mesh.cell_sets.items() if not name.startswith("gmsh:")]
    if sets:
        return sets
    physical = mesh.cell_data.get("gmsh:physical")
    named = {}
    if physical is not None:
        named = {(int(tag), int(dimension)): name for name, (tag, dimension) in mesh.field_data.items()}
    if physical is None:
        for key in ("MaterialIds", "medit:ref", "cell_tags"):
            physical = mesh.cell_data.get(key)
            if physical is not None:
                break
        else:
            return []
    found: dict[str, list[Any]] = {}
    for place, tags in enumerate(physical):
        dimension = 3 if mesh.cells[place].type in _OF_MESHIO else 2
        for tag in np.unique(tags):
            name = named.get((int(tag), dimension))
            if name is None and dimension == 2:
                continue
            members = found.setdefault(name or f"group{int(tag)}", [None] * len(mesh.cells))
            members[place] = np.flatnonzero(np.asarray(tags) == tag)
    return list(found.items())


#: Nodes of each side, by kind, in the order of sides.
_SIDES = {
    "hex8": [[0, 4, 7, 3], [1, 2, 6, 5], [0, 1, 5, 4], [3, 7, 6, 2], [0, 3, 2, 1], [4, 5, 6, 7]],
    "wedge6": [[0, 2, 1], [3, 4, 5], [0, 1, 4, 3], [1, 2, 5, 4], [0, 3, 5, 2]],
    "pyramid5": [[0, 3, 2, 1], [0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]],
    "tet4": [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]],
}


def _faces(blocks: list[tuple[str, np.ndarray]], surfaces: dict[str, list[np.ndarray]]) -> dict[str, np.ndarray]:
    """Surface cells as sides of the solids that have them; cells that belong to none are left out."""
    sides: dict[tuple[int, ...], tuple[int, int]] = {}
    start = 0
    for kind, block in blocks:
        for side, local in enumerate(_SIDES[kind]):
            for e, nodes in enumerate(np.sort(block[:, local], axis=1).tolist()):
                sides.setdefault(tuple(nodes), (start + e, side))
        start += len(block)
    made = {}
    for name, parts in surfaces.items():
        cells = [tuple(nodes) for part in parts for nodes in np.sort(part, axis=1).tolist()]
        found = [sides[nodes] for nodes in cells if nodes in sides]
        if found:
            made[name] = np.array(found, dtype=np.int64)
    return made
