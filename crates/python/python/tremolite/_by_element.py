"""Parameters of a material that differ from element to element: random fields, weathering, what a survey found."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from ._mesh import Mesh
from ._tremolite import Case, Error, Job

_NUMBER = re.compile(r"\s*([-+]?[0-9.]+(?:[eE][-+]?[0-9]+)?)(.*)", re.DOTALL)


def by_element(case: Case, material: str, factors: Mapping[str, Any], *, mesh: Mesh | None = None, classes: int = 16) -> tuple[Case, Mesh]:
    """A case whose material differs by element, and its mesh: `Job(case, mesh=mesh)`. `Job.field` does the same for a job that is there.

    factors: parameter -> (elements,) by which the case's value is multiplied, for all elements of the mesh; those of other materials are
        passed over.
    mesh: what the case is to be run with, where it is in memory; else the one that `case.mesh()` makes.
    classes: into so many steps, equal in the logarithm, the factors of each parameter are sorted; a class has the mean of its elements,
        so the spread of the field within a class is lost: with 16 classes between 0.5 and 2 at most 9 % of a value. A field with no more
        values than classes is exact.

    Each class is a material `rock-00`, `rock-01` ... of the case with a group of the same name, so summary, stages and checks know them.
    Other groups stay. Elements that a stage excavates keep what they are made of.

    Raises `Error` where the material or a parameter is not there, a factor is not above 0, or the shape is not that of the mesh.
    """
    made = case.mesh() if mesh is None else mesh
    keys = case.to_dict()
    groups = _divide(keys, made, material, factors, dict.fromkeys(factors, classes))
    if mesh is None:
        # It has been scaled, turned, cut and grouped as the case says.
        keys["mesh"] = {"file": {"path": "memory"}}
    return Case.from_dict(keys, case.directory), replace(made, groups={**made.groups, **groups})


class Field:
    """A parameter of a material by element: `job.field("rock.young")`.

    `field[:]` gives its values (n,) in SI in the order of `elements`, indices into `job.mesh`; `centroids` are their places (n, 3) [m].
    `field[:] = values`, or of a part of them, sets them, and builds the job again, so that what is wrong is said there.

    Values are sorted into classes, each of which has the mean of its elements; `field.of_classes` are those that the job computes with.
    """

    def __init__(self, job: Job, name: str, classes: int = 16) -> None:
        self.job, self.name, self.classes = job, name, classes
        self._material, _, self._key = name.rpartition(".")
        case, mesh, _ = job._field(name)
        keys = case.to_dict()
        if self._material not in keys["material"]:
            there = ", ".join(keys["material"])
            raise Error(f'no material is called {self._material!r}; there are {there}; write job.field("rock.young")')
        value = case._number(self._material, self._key)
        if value is None or self._key not in keys["material"][self._material]:
            raise Error(f"the material has no number {self._key!r}; it has {', '.join(keys['material'][self._material])}")
        self._value: float = value
        self.elements = np.flatnonzero(_of_material(keys, mesh, self._material))
        self.centroids = mesh.centroids[self.elements]
        self._count = len(mesh)

    def _all(self) -> np.ndarray:
        given = self.job._field(self.name)[2]
        return np.full(len(self.elements), self._value) if given is None else np.array(given[self.elements])

    @property
    def of_classes(self) -> np.ndarray:
        """The values (n,) in SI that the job computes with."""
        given = self._all()
        classes = _classes(self.name, given, np.ones(len(given), bool), self.classes)
        means: np.ndarray = np.bincount(classes, given) / np.maximum(np.bincount(classes), 1)
        return np.asarray(means[classes])

    def __getitem__(self, at: Any) -> Any:
        return self._all()[at]

    def __setitem__(self, at: Any, values: Any) -> None:
        own = self._all()
        own[at] = values
        if not (np.isfinite(own) & (own > 0)).all():
            raise Error(f"a value of {self.name} is not above 0; mend it")
        whole = np.full(self._count, np.nan)
        whole[self.elements] = own
        self.job._set_field(self.name, whole.tolist(), self.classes)

    def __len__(self) -> int:
        return len(self.elements)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> np.ndarray:
        return self._all().astype(dtype or float)

    def __repr__(self) -> str:
        own = self._all()
        return f"<{self.name} of {len(own)} elements, {own.min():g} to {own.max():g}>"


def _divided(case: Case, mesh: Mesh, given: Mapping[str, tuple[np.ndarray, int]]) -> tuple[Case, list[tuple[str, list[int]]]]:
    """A case divided by values (elements,) of parameters `rock.young`, each with its number of classes; and the groups of the pieces."""
    keys = case.to_dict()
    of: dict[str, dict[str, tuple[np.ndarray, int]]] = {}
    for name, (values, classes) in given.items():
        material, _, key = name.rpartition(".")
        if len(values) != len(mesh):
            raise Error(f"{name} was set for {len(values)} elements, where the mesh now has {len(mesh)}; set it again")
        value = case._number(material, key)
        if value is None:
            raise Error(f"the case has no {name} any more, which was set by element")
        of.setdefault(material, {})[key] = (np.where(np.isnan(values), 1.0, values / value), classes)
    groups: list[tuple[str, list[int]]] = []
    for material, parameters in of.items():
        factors = {key: factor for key, (factor, _) in parameters.items()}
        pieces = _divide(keys, mesh, material, factors, {key: classes for key, (_, classes) in parameters.items()})
        groups += [(name, elements.tolist()) for name, elements in pieces.items()]
    return Case.from_dict(keys, case.directory), groups


def _of_material(keys: Mapping[str, Any], mesh: Mesh, material: str) -> np.ndarray:
    """Whether each element is made of a material."""
    inside = np.zeros(len(mesh), dtype=bool)
    for region in keys["region"]:
        if region.get("material") == material:
            inside |= _inside(mesh, region)
    return inside


def _divide(
    keys: dict[str, Any], mesh: Mesh, material: str, factors: Mapping[str, Any], classes: Mapping[str, int]
) -> dict[str, np.ndarray]:
    """Divides a material of a case's keys by factors (elements,) of its parameters; the groups of the pieces."""
    if not factors:
        raise Error('no parameter is given; write {"young": factors}')
    materials = keys["material"]
    if material not in materials:
        raise Error(f"no material is called {material!r}; there are {', '.join(materials)}")
    regions = [region for region in keys["region"] if region.get("material") == material]
    inside = _of_material(keys, mesh, material)
    if not inside.any():
        raise Error(f"no region is made of {material!r}")
    steps = np.stack([_classes(name, given, inside, classes[name]) for name, given in factors.items()])
    combinations, of = np.unique(steps[:, inside], axis=1, return_inverse=True)
    class_of = np.full(len(mesh), -1)
    class_of[inside] = of.ravel()

    names = [f"{material}-{number:02d}" for number in range(combinations.shape[1])]
    taken = [name for name in names if name in materials or name in mesh.groups]
    if taken:
        raise Error(f"{taken[0]!r} is the name of a material or group already; rename that")
    for number, name in enumerate(names):
        values = {
            key: _scaled(materials[material], key, float(np.asarray(given)[class_of == number].mean())) for key, given in factors.items()
        }
        materials[name] = {**materials[material], **values}
    groups: dict[str, np.ndarray] = {}
    split = []
    for place, region in enumerate(keys["region"]):
        if region.get("material") != material:
            split.append(region)
            continue
        own = _inside(mesh, region)
        for number, name in enumerate(names):
            elements = np.flatnonzero(own & (class_of == number))
            if len(elements):
                group = name if len(regions) == 1 else f"{name}-{place}"
                groups[group] = elements
                split.append({**region, "groups": [group], "material": name})
    keys["region"] = split
    if not _is_named(keys, material):
        del materials[material]
    return groups


def _inside(mesh: Mesh, region: Mapping[str, Any]) -> np.ndarray:
    """Whether each element is in a region: patterns in which a star stands for any text."""
    inside = np.zeros(len(mesh), dtype=bool)
    patterns = ["".join(".*" if part == "*" else re.escape(part) for part in re.split(r"(\*)", one)) for one in region["groups"]]
    for name, elements in mesh.groups.items():
        if any(re.fullmatch(pattern, name) for pattern in patterns):
            inside[elements] = True
    return inside


def _classes(name: str, given: Any, inside: np.ndarray, classes: int) -> np.ndarray:
    """The class of each element by one parameter."""
    factors = np.asarray(given, dtype=float)
    if factors.shape != inside.shape:
        raise Error(f"the factors of {name} have the shape {factors.shape}; the mesh has {len(inside)} elements")
    own = factors[inside]
    if not (np.isfinite(own) & (own > 0)).all():
        raise Error(f"a factor of {name} is not above 0; mend it")
    if classes < 1:
        raise Error("classes is 1 or more")
    low, high = np.log(own.min()), np.log(own.max())
    steps = np.zeros(len(inside), dtype=int)
    distinct, of = np.unique(own, return_inverse=True)
    if len(distinct) <= classes:
        steps[inside] = of.ravel()
        return steps
    if high > low:
        steps[inside] = np.minimum(((np.log(own) - low) / (high - low) * classes).astype(int), classes - 1)
    return steps


def _scaled(material: Mapping[str, Any], key: str, factor: float) -> Any:
    """A value of a case times a factor, with its unit."""
    if key not in material:
        raise Error(f"the material has no {key!r}; it has {', '.join(material)}")
    value = material[key]
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        return float(value * factor)
    number = _NUMBER.fullmatch(value) if isinstance(value, str) else None
    if number is None:
        raise Error(f"{key} = {value!r} is no number that could be multiplied")
    return f"{float(number.group(1)) * factor!r}{number.group(2)}"


def _is_named(keys: Mapping[str, Any], material: str) -> bool:
    """Whether a case still names a material: in a region, or as what a stage changes to."""
    regions = any(material in (region.get("material"), region.get("before")) for region in keys["region"])
    return regions or any(material in stage.get("material", {}).values() for stage in keys.get("stage", []))
