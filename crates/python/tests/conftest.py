"""Small cases that the tests share: a column under a pulse, and a lined cavern in stages."""

from __future__ import annotations

import copy
import os
import shlex
import signal
import subprocess
import sys
import warnings
from pathlib import Path

import numpy as np
import pytest

import tremolite as tr

# Where a shell starts the tests in the background it has them ignore Ctrl-C.
signal.signal(signal.SIGINT, signal.default_int_handler)

COLUMN = {
    "title": "a column under a pulse",
    "mesh": {
        "box": {
            "group": "rock",
            "x": {"from": 0, "to": "2 m", "elements": 1},
            "y": {"from": 0, "to": "2 m", "elements": 1},
            "z": {"from": "-20 m", "to": 0, "elements": 10},
        }
    },
    "material": {"rock": {"law": "elastic", "young": "2 GPa", "poisson": 0.25, "density": "2500 kg/m3"}},
    "region": [{"groups": ["rock"], "material": "rock", "element": "reduced-integration"}],
    "motion": {"kind": "incident", "file": "pulse"},
    "dynamic": {"base": "viscous", "sides": "periodic"},
    "monitor": [{"name": "top", "at": ["1 m", "1 m", "-1 m"]}],
    "output": {"snapshots": "0.1 s"},
}

#: Files of a run that hold nothing of the clock, the machine or the caller.
EQUAL = ["monitors.csv", "energy.csv", "motion.csv", "spectra.csv", "free_field.csv", "depth.csv", "fields.pvd"]


def pulse(samples: int = 100) -> tr.Motion:
    """A pulse towards east that leaves no drift behind: one wave of acceleration, ending at rest."""
    t = 0.01 * np.arange(samples)
    shape = np.exp(-((12.0 * (t - 0.4)) ** 2))
    return tr.Motion.from_components(0.01, east=np.gradient(np.gradient(np.gradient(shape, t), t), t) * 1e-3, name="pulse")


@pytest.fixture(autouse=True)
def quiet():
    """The pulse ends as it may: what cases are warned of is not what most tests are about."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", tr.CaseWarning)
        yield


@pytest.fixture
def column() -> dict:
    return copy.deepcopy(COLUMN)


@pytest.fixture
def job() -> tr.Job:
    return tr.Job(tr.Case.from_dict(COLUMN), motion=pulse())


@pytest.fixture(scope="session")
def command() -> list[str]:
    """The command: the Rust program where TREMOLITE_COMMAND names it, else the package's script."""
    given = os.environ.get("TREMOLITE_COMMAND")
    return shlex.split(given) if given else [sys.executable, "-m", "tremolite"]


@pytest.fixture(scope="session")
def cavern(tmp_path_factory, command) -> Path:
    """The case of `tremolite new`, shaken for 0.2 s."""
    folder = tmp_path_factory.mktemp("cavern") / "first"
    subprocess.run([*command, "new", str(folder)], check=True, capture_output=True)
    return folder / "case.toml"


def same_files(a: Path, b: Path, names=None) -> list[str]:
    """Names of the result files of `a` that `b` does not hold with the same bytes."""
    names = names or [str(p.relative_to(a)) for p in sorted(a.rglob("*")) if p.suffix in (".csv", ".vtu", ".pvd", ".bin")]
    assert names
    return [name for name in names if (a / name).read_bytes() != (b / name).read_bytes()]
