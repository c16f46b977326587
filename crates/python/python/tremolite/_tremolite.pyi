"""The compiled half of the package: what computes and what reads files."""

import os
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from types import TracebackType
from typing import Any, final

import numpy as np
from numpy.typing import ArrayLike, NDArray
from typing_extensions import Self

from ._by_element import Field
from ._mesh import Mesh
from ._motion import Motion
from ._own import NodalForce, Observer
from ._results import Result

__version__: str

_Path = str | os.PathLike[str]
_Array = NDArray[np.float64]
_Indices = NDArray[np.int64]

class Error(Exception):
    """What this package refuses, or could not do."""

class CaseError(Error):
    """A case that cannot be run, with all that is wrong."""

    problems: list[Problem]

class RunError(Error):
    """A run that could not go on. What was computed before is kept."""

class Stopped(KeyboardInterrupt):
    """Ctrl-C stopped a run in good order: a checkpoint is in its folder `out`."""

    out: Path

class CaseWarning(UserWarning):
    """What is unusual of a case that can be run all the same."""

class RunWarning(UserWarning):
    """A run that ended for a physical or numerical reason; its results until then are kept."""

@final
class Problem:
    """One thing that is wrong or unusual, at its place in the case."""

    key: str
    line: int | None
    column: int | None
    message: str
    remedy: str

@final
class Case:
    """A case file, checked. It is never changed: `with_` gives another."""

    title: str
    text: str
    path: Path
    directory: Path
    warnings: list[Problem]
    defaults: dict[str, str]
    files: list[Path]
    def __new__(cls, path: _Path) -> Self: ...
    @staticmethod
    def from_text(text: str, directory: _Path = ...) -> Case: ...
    @staticmethod
    def from_dict(case: Mapping[str, Any], directory: _Path = ..., *, units: str | None = None) -> Case: ...
    def with_(self, changes: Mapping[str, Any]) -> Case: ...
    def to_dict(self) -> dict[str, Any]: ...
    def mesh(self) -> Mesh: ...
    def _placed(self) -> str: ...
    def _number(self, material: str, key: str) -> float | None: ...
    @staticmethod
    def schema() -> dict[str, Any]: ...

@final
class Job:
    """A case with its mesh, its records and its model, ready to be checked and run."""

    name: str
    case: Case
    warnings: list[Problem]
    remarks: list[str]
    mesh: Mesh
    dt: float
    steps: int
    initial_stress: _Array
    def __new__(
        cls,
        case: Case | _Path,
        *,
        mesh: Mesh | None = None,
        motion: Motion | None = None,
        meshes: Mapping[str, Mesh] | None = None,
        records: Mapping[str, Motion] | None = None,
        bolts: Mapping[str, ArrayLike] | None = None,
        set: Mapping[str, Any] | None = None,
        threads: int | None = None,
    ) -> Self: ...
    def check(self, *, threads: int | None = None) -> dict[str, Any]: ...
    def with_fields(
        self,
        *,
        initial_stress: ArrayLike | None = None,
        loads: Sequence[tuple[ArrayLike, ArrayLike, ArrayLike, ArrayLike]] | None = None,
        forces: Sequence[NodalForce] | None = None,
        threads: int | None = None,
    ) -> Job: ...
    def field(self, name: str, *, classes: int = 16) -> Field: ...
    def _field(self, name: str) -> tuple[Case, Mesh, _Array | None]: ...
    def _set_field(self, name: str, values: Sequence[float], classes: int) -> None: ...
    def run(
        self,
        out: _Path | None = None,
        *,
        resume: bool = False,
        overwrite: bool = False,
        from_: _Path | None = None,
        threads: int | None = None,
        set: Mapping[str, Any] | None = None,
        callback: Callable[[Look], bool | None] | None = None,
        every: int | str | None = None,
        observers: Sequence[Observer] = ...,
        progress: Callable[[dict[str, Any]], None] | None = None,
    ) -> Result: ...
    def start(
        self,
        out: _Path | None = None,
        *,
        resume: bool = False,
        overwrite: bool = False,
        from_: _Path | None = None,
        threads: int | None = None,
        callback: Callable[[Look], bool | None] | None = None,
        every: int | str | None = None,
        observers: Sequence[Observer] = ...,
    ) -> Simulation: ...

@final
class StageEnd:
    """A stage that has come to rest."""

    number: int
    name: str
    cycles: int
    ratio: float

@final
class Stages:
    """The stages that are left: each comes to rest as it is asked for."""

    def __iter__(self) -> Stages: ...
    def __next__(self) -> StageEnd: ...

@final
class Simulation:
    """A run that a script drives, in its folder, on threads of its own."""

    out: Path
    time: float
    taken: int
    stage: str | None
    dt: float
    def stages(self) -> Stages: ...
    def add_stage(self, stage: Mapping[str, Any]) -> None: ...
    def step(self, steps: int = 1) -> bool: ...
    def look(self) -> Look: ...
    def checkpoint(self) -> None: ...
    def restore(self) -> None: ...
    def finish(self) -> Result: ...
    def __enter__(self) -> Simulation: ...
    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> bool: ...

@final
class Look:
    """What is seen of a run at one time: a copy, with read-only arrays."""

    time: float
    step: int
    stage: str | None
    displacement: _Array
    velocity: _Array
    acceleration: _Array
    energy: dict[str, float]
    memory: dict[str, _Array] | None
    def elements(self, groups: str | Sequence[str] = "*") -> _Indices: ...
    def points_of(self, groups: str | Sequence[str] = "*") -> _Indices: ...
    def stress(self, groups: str | Sequence[str] = "*") -> _Array: ...
    def mean_stress(self, groups: str | Sequence[str] = "*") -> _Array: ...
    def columns(self, groups: str | Sequence[str] = "*") -> dict[str, str]: ...
    def history(self, groups: str | Sequence[str], name: str) -> _Array: ...
    def record(self, name: str, values: Mapping[str, ArrayLike]) -> None: ...

@final
class Beginning:
    """Where an observer begins: the folder of the results, the stage or None, the time [s], and what it remembers."""

    out: Path
    stage: str | None
    time: float
    memory: dict[str, _Array]

@final
class Target:
    """A response spectrum that motions are to fit."""

    name: str
    damping: float
    range: tuple[float, float]
    def __new__(cls, words: _Path) -> Self: ...
    @staticmethod
    def of_table(periods: ArrayLike, sa: ArrayLike, *, damping: float = 0.05, name: str = "target") -> Target: ...
    def at(self, periods: ArrayLike) -> _Array: ...

@final
class LawCore:
    interface: bool
    parameters: dict[str, Any]
    warnings: list[str]
    def __new__(cls, text: str) -> Self: ...
    def follow(self, time: _Array, values: _Array, by_stress: Sequence[bool]) -> dict[str, Any]: ...
    def follow_interface(self, values: _Array, by_pressure: bool) -> dict[str, Any]: ...

def command(arguments: Sequence[str], again: Sequence[str]) -> int: ...
def read_mesh(path: _Path) -> tuple[Mesh, list[str]]: ...
def write_mesh(mesh: Mesh, path: _Path) -> list[str]: ...
def sound_mesh(mesh: Mesh) -> tuple[Mesh, list[str]]: ...
def mesh_quality(mesh: Mesh) -> _Array: ...
def read_vtu(path: _Path) -> dict[str, Any]: ...
def read_record(
    path: _Path,
    units: str | None = None,
    dt: float | None = None,
    sensitivity: str | None = None,
    columns: Sequence[str] | None = None,
    encoding: str | None = None,
) -> tuple[Motion, list[str]]: ...
def write_record(motion: Motion, paths: Sequence[_Path]) -> None: ...
def process_record(motion: Motion, steps: Sequence[str]) -> Motion: ...
def match_record(
    motion: Motion, target: Target, band: tuple[float, float] | None, tolerance: float
) -> tuple[Motion, float, list[dict[str, float]]]: ...
def misfit_of(motion: Motion, target: Target, band: tuple[float, float] | None) -> tuple[dict[str, float], float]: ...
def artificial_record(
    target: Target,
    band: tuple[float, float] | None,
    envelope: tuple[float, float | None, float | None],
    dt: float,
    seeds: tuple[int, int],
    tolerance: float,
) -> tuple[Motion, float]: ...
def select_records(
    motion: Motion, target: Target, band: tuple[float, float] | None, factors: tuple[float, float]
) -> tuple[list[tuple[int, float, float, float, float]], int]: ...
def geographic(motion: Motion) -> tuple[float, float, list[_Array]]: ...
def spectrum(acceleration: _Array, dt: float, periods: Sequence[float], damping: float) -> _Array: ...
def intensity(acceleration: _Array, dt: float) -> dict[str, float]: ...
def orientation(label: str) -> tuple[float | None, bool]: ...
def equivalent_linear(
    layers: Sequence[tuple[float, float, float, str, Any]],
    rock: tuple[float, float],
    acceleration: Sequence[float],
    dt: float,
    at_surface: bool,
    share: float,
) -> tuple[list[list[float]], int]: ...
def study_plan(path: _Path, text: str) -> str: ...
def write_study_page(folder: _Path, language: str | None = None) -> Path: ...
def differences(one: _Path, other: _Path) -> list[str]: ...
def write_page(folder: _Path, language: str | None = None) -> Path: ...
def write_comparison(folders: Sequence[_Path], page: _Path, language: str | None = None) -> None: ...
def read_table(path: _Path) -> tuple[list[tuple[str, str, str, str]], list[_Array], bool]: ...
def check_folder(path: _Path) -> None: ...
