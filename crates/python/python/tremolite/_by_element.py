"""Parameters of a material that differ from element to element: random fields, weathering, what a survey found."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from ._mesh import Mesh
from ._tremolite import Case, Error

_NUMBER = re.compile(r"\s*([-+]?[0-9.]+(?:[eE][-+]?[0-9]+)?)(.*)", re.DOTALL)


def by_element(case: Case, material: str, factors: Mapping[str, Any], *, mesh: Mesh | None = None, classes: int = 16) -> tuple[Case, Mesh]:
    """A case whose material differs by element, and its mesh: `Job(case, mesh=mesh)`.

    factors: parameter -> (elements,) by which the case's value is multiplied, for all elements of the mesh; those of other materials are
        passed over.
    mesh: what the case is to be run with, where it is in memory; else the one that `case.mesh()` makes.
    classes: into so many steps, equal in the logarithm, the factors of each parameter are sorted; a class has the mean of its elements,
        so the spread of the field within a class is lost: with 16 classes between 0.5 and 2 at most 9 % of a value.

    Each class is a material `rock-00`, `rock-01` ... of the case with a group of the same name, so summary, stages and checks know them.
    Other groups stay. Elements that a stage excavates keep what they are made of.

    Raises `Error` where the material or a parameter is not there, a factor is not above 0, or the shape is not that of the mesh.
    """
    if not factors:
        raise Error('no parameter is given; write {"young": factors}')
    keys = case.to_dict()
    materials = keys["material"]
    if material not in materials:
        raise Error(f"no material is called {material!r}; there are {', '.join(materials)}")
    made = case.mesh() if mesh is None else mesh
    regions = [region for region in keys["region"] if region.get("material") == material]
    inside = np.zeros(len(made), dtype=bool)
    for region in regions:
        inside |= _inside(made, region)
    if not inside.any():
        raise Error(f"no region is made of {material!r}")
    steps = np.stack([_classes(name, given, inside, classes) for name, given in factors.items()])
    combinations, of = np.unique(steps[:, inside], axis=1, return_inverse=True)
    class_of = np.full(len(made), -1)
    class_of[inside] = of.ravel()

    names = [f"{material}-{number:02d}" for number in range(combinations.shape[1])]
    taken = [name for name in names if name in materials or name in made.groups]
    if taken:
        raise Error(f"{taken[0]!r} is the name of a material or group already; rename that")
    for number, name in enumerate(names):
        values = {
            key: _scaled(materials[material], key, float(np.asarray(given)[class_of == number].mean())) for key, given in factors.items()
        }
        materials[name] = {**materials[material], **values}
    groups, split = dict(made.groups), []
    for place, region in enumerate(keys["region"]):
        if region.get("material") != material:
            split.append(region)
            continue
        own = _inside(made, region)
        for number, name in enumerate(names):
            elements = np.flatnonzero(own & (class_of == number))
            if len(elements):
                group = name if len(regions) == 1 else f"{name}-{place}"
                groups[group] = elements
                split.append({**region, "groups": [group], "material": name})
    keys["region"] = split
    if "file" not in keys["mesh"]:
        keys["mesh"] = {"file": {"path": "memory"}}
    if not _is_named(keys, material):
        del materials[material]
    return Case.from_dict(keys, case.directory), replace(made, groups=groups)


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
