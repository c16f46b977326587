"""Laws at a point: for calibration."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ._toml import value
from ._tremolite import Error, LawCore

_COMPONENTS = ("xx", "yy", "zz", "xy", "yz", "zx")


@dataclass(frozen=True)
class MaterialPath:
    """What came of a path, row by row.

    time: (n,) [s]. strain: (n, 6), shear as the engineering angle. stress: (n, 6) [Pa], tension positive.
    history: name -> (n,), what the law remembers, with its units.
    jumps: rows before which the law's stress dropped at once, so that damage came first and the sides followed.
    """

    time: np.ndarray
    strain: np.ndarray
    stress: np.ndarray
    history: Mapping[str, np.ndarray]
    units: Mapping[str, str]
    jumps: np.ndarray


@dataclass(frozen=True)
class InterfacePath:
    """What came of a path of an interface, row by row: gap (n,) [m], slip (n, 2) [m], pressure (n,) [Pa], shear (n, 2) [Pa], history."""

    gap: np.ndarray
    slip: np.ndarray
    pressure: np.ndarray
    shear: np.ndarray
    history: Mapping[str, np.ndarray]
    units: Mapping[str, str]


class Law:
    """A law with its parameters. Made by `law`."""

    def __init__(self, text: str) -> None:
        self._core = LawCore(text)
        self.text = text

    @property
    def parameters(self) -> dict[str, Any]:
        """Its parameters in SI, defaults filled in."""
        return self._core.parameters

    @property
    def warnings(self) -> list[str]:
        """What is unusual about them."""
        return self._core.warnings

    def drive(
        self,
        strain: Any = None,
        *,
        stress: Mapping[str, Any] | None = None,
        free: Sequence[str] = (),
        time: Any = None,
    ) -> MaterialPath:
        """Drives a material from virgin state along a path of n rows.

        strain: (n, 6), shear as the engineering angle, or a dict from component ("xx" ... "zx") to (n,) or a number; what a dict leaves
            out is held at 0.
        stress: component -> (n,) or a number [Pa], prescribed in the place of the strain of that component.
        free: components with no stress. Uniaxial stress along x: strain={"xx": e}, free=["yy", "zz", "xy", "yz", "zx"].
        time: (n,) [s], not falling; left out, time stands still and nothing has a rate.

        Raises `Error` with the row where no strain gives the stress that is prescribed.
        """
        if self._core.interface:
            raise Error("this is the law of an interface; drive it by gap or pressure, with drive_interface")
        prescribed = {**{name: 0.0 for name in free}, **(stress or {})}
        given = {} if strain is None else strain
        rows = _rows(given, prescribed, time)
        values = np.zeros((rows, 6))
        if isinstance(given, Mapping):
            for name, column in given.items():
                values[:, _component(name)] = _column(column, rows, f"strain {name}")
        else:
            whole = np.asarray(given, dtype=float)
            if whole.ndim != 2 or whole.shape[1] != 6:
                raise Error(f"strain has the shape {whole.shape}; give (n, 6), or a dict by component")
            values[:] = whole
        by_stress = [False] * 6
        for name, column in prescribed.items():
            if isinstance(given, Mapping) and name in given:
                raise Error(f"both strain and stress are prescribed for {name}; keep one")
            by_stress[_component(name)] = True
            values[:, _component(name)] = _column(column, rows, f"stress {name}")
        times = np.zeros(rows) if time is None else _column(time, rows, "time")
        made = self._core.follow(np.ascontiguousarray(times), values, by_stress)
        return MaterialPath(times, **made)

    def drive_interface(self, *, gap: Any = None, pressure: Any = None, slip: Any = 0.0) -> InterfacePath:
        """Drives an interface, just made, along a path of n rows: gap (n,) [m], positive when open, or pressure (n,) [Pa], and slip
        (n,) or (n, 2) [m] along its tangents."""
        if not self._core.interface:
            raise Error("this is the law of a material; drive it by strain and stress, with drive")
        if (gap is None) == (pressure is None):
            raise Error("give gap or pressure, one of the two")
        across = gap if gap is not None else pressure
        slips = np.asarray(slip, dtype=float)
        rows = max(np.size(across), slips.shape[0] if slips.ndim else 1)
        values = np.zeros((rows, 3))
        values[:, 0] = _column(across, rows, "gap or pressure")
        if slips.ndim == 2:
            values[:, 1:] = slips
        else:
            values[:, 1] = _column(slips, rows, "slip")
        return InterfacePath(**self._core.follow_interface(values, gap is None))

    def __repr__(self) -> str:
        return f"<Law {self.text.splitlines()[-1] if not self.text else self.text.splitlines()[1]}>"


def law(name: str, *, size: Any = None, interface: bool = False, units: str | None = None, **parameters: Any) -> Law:
    """A law by its name (`tremolite list materials`), with its parameters as in a case: young="25 GPa".

    size: extent of the element, "0.5 m", for laws with a fracture energy. interface: whether it is the law of an interface.
    units: "SI": bare numbers are in SI, angles excepted: young=25e9.
    Parameters are checked as in a case; raises `CaseError` with all that is wrong.
    """
    lines = [f"[{'interface' if interface else 'material'}]", f"law = {value(name, 'law')}"]
    if size is not None:
        lines.insert(0, f"size = {value(size, 'size')}")
    if units is not None:
        lines.insert(0, f"units = {value(units, 'units')}")
    lines += [f"{key} = {value(one, key)}" for key, one in parameters.items()]
    return Law("\n".join(lines) + "\n")


def _component(name: str) -> int:
    if name not in _COMPONENTS:
        raise Error(f"{name!r} is no component; there are {', '.join(_COMPONENTS)}")
    return _COMPONENTS.index(name)


def _rows(strain: Any, stress: Mapping[str, Any], time: Any) -> int:
    """The rows of a path: those of whatever has several."""
    if not isinstance(strain, Mapping):
        return len(np.atleast_1d(np.asarray(strain)))
    given = [*strain.values(), *stress.values(), *([] if time is None else [time])]
    return max((np.size(column) for column in given), default=1)


def _column(given: Any, rows: int, what: str) -> np.ndarray:
    made = np.asarray(given, dtype=float)
    if made.ndim > 1 or (made.ndim == 1 and len(made) not in (1, rows)):
        raise Error(f"{what} has the shape {made.shape}, where the path has {rows} rows")
    return np.array(np.broadcast_to(made, (rows,)))
