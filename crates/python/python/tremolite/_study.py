"""Studies: runs beside one another that differ in keys, records and levels. What runs them is the command, in processes of its own."""

from __future__ import annotations

import os
import re
import shutil
import signal
import subprocess
import sys
import warnings
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from ._mesh import Mesh
from ._motion import Motion
from ._study_result import StudyResult, StudyTable
from ._toml import document
from ._tremolite import Case, Error, RunError, RunWarning, Stopped, study_plan, write_record

#: Words of lists of tables in a study file.
_LISTS = ("record", "row", "correlation", "fragility")


class Study:
    """A case that is run many times, with other values at some of its keys, other records and other levels of shaking.

    study: the path of a study file; or a dict with its tables; or a `Case` with the tables as keywords, in the file's own words:

        study = tr.Study(
            case,
            out="results/study",
            vary={"initial.lateral": {"uniform": [0.5, 1.2]}},
            sample={"kind": "latin-hypercube", "count": 30, "seed": 7},
            record={"te-mara": "te-mara.V2A", "own": motion},
            scale={"measure": "PGV", "levels": ["0.1 m/s", "0.2 m/s"]},
            measure={"cracked": {"summary": 'damage."hall.lining".volume'}},
        )

    out: the folder of all that comes out, `results/<file's name>` by default, or `results/study`.
    mesh: a `Mesh` for a case that has [mesh.file], in place of that file.

    All of it is checked here, and so is the case of every run: `CaseError` tells everything that is wrong. A study of a dict or
    keywords is written as `study.toml` into its folder, with a case (`case.toml`), a mesh (`mesh.vtu`) and records (`records/`) that are
    in memory alone; the command and other machines then take the same file. It is that file that runs, so plan and tables have the bytes
    of the command's. Paths start from the folder that the script runs in.

    It can be sent to other processes (`pickle`): `executor.map(lambda k: study.run(shard=(k, 8)), range(1, 9))`, then `study.gather()`.
    """

    def __init__(
        self, study: Case | Mapping[str, Any] | str | os.PathLike[str], *, out: str | os.PathLike[str] | None = None, **tables: Any
    ) -> None:
        if isinstance(study, (str, os.PathLike)):
            if tables:
                raise Error(f"a study file has its tables in it; write {', '.join(tables)} there, or give a Case in place of the file")
            self.path = Path(study).absolute()
            self.out = Path(out if out is not None else Path("results", self.path.stem)).absolute()
            self._plan = study_plan(self.path, _read(self.path))
            return
        given = dict(study) if isinstance(study, Mapping) else {"case": study}
        twice = sorted(set(given) & set(tables))
        if twice:
            raise Error(f"{', '.join(twice)} is given twice")
        given |= {name: table for name, table in tables.items() if table is not None}
        self.out = Path(out if out is not None else Path("results", "study")).absolute()
        self.path = self.out / "study.toml"
        # What the study names is there before it is checked; the study itself only once it is.
        text = document(self._tables(given))
        self._plan = study_plan(self.path, text)
        _write(self.path, text)

    def _tables(self, given: Mapping[str, Any]) -> dict[str, Any]:
        """The tables of the file, where what is in memory has become files."""
        if "case" not in given:
            raise Error("a study has a case: a Case, a dict or the path of one under the key `case`")
        case = given["case"]
        made = {"title": "a study", **given, "case": self._case(case, given.get("mesh"))}
        made.pop("mesh", None)
        for name in _LISTS:
            if name in made:
                made[name] = [self._named(name, *entry) for entry in _entries(made[name])]
        sample, scale = made.get("sample"), made.get("scale")
        if isinstance(sample, Mapping) and "file" in sample:
            made["sample"] = {**sample, "file": _absolute(sample["file"])}
        if isinstance(scale, Mapping) and isinstance(scale.get("target"), (str, os.PathLike)) and Path(scale["target"]).is_file():
            made["scale"] = {**scale, "target": _absolute(scale["target"])}
        return made

    def _case(self, case: Any, mesh: Any) -> str:
        if isinstance(case, Mapping):
            case = Case.from_dict(case)
        if mesh is not None:
            if not isinstance(mesh, Mesh):
                raise Error("mesh is a Mesh; the path of a file stands in the case: [mesh.file] path")
            file = self.out / "mesh.vtu"
            file.parent.mkdir(parents=True, exist_ok=True)
            mesh.write(file)
            case = (case if isinstance(case, Case) else Case(case)).with_({"mesh.file.path": str(file)})
        if not isinstance(case, Case):
            return _absolute(case)
        if case.path.is_file() and case.path.read_text(encoding="utf-8") == case.text:
            return _absolute(case.path)
        _write(self.out / "case.toml", case._placed())
        return "case.toml"

    def _named(self, table: str, name: str | None, entry: Any) -> dict[str, Any]:
        """An entry of a list of tables, under its name."""
        if table == "record":
            entry = self._record(name or "record", entry)
        if not isinstance(entry, Mapping):
            raise Error(f"{table}: {entry!r} is no table of keys")
        return dict(entry) if name is None else {"name": name, **entry}

    def _record(self, name: str, entry: Any) -> Any:
        if isinstance(entry, Motion):
            parts = entry.geographic()
            here = {label: parts[label] for label in ("east", "north", "up")}
            made = Motion.from_components(parts["dt"], **here, name=name)
            # Names are checked with all else later: here one may still be a path.
            word = re.sub(r"[^\w-]", lambda odd: f"%{ord(odd[0]):x}", name)
            files = {label: self.out / "records" / f"{word}-{label}.txt" for label in here}
            files["east"].parent.mkdir(parents=True, exist_ok=True)
            write_record(made, list(files.values()))
            return {label: {"file": f"records/{file.name}"} for label, file in files.items()}
        if isinstance(entry, (str, os.PathLike)):
            return {"file": _absolute(entry)}
        if isinstance(entry, Mapping):
            return {key: self._record(name, one) if isinstance(one, Mapping) else _placed(key, one) for key, one in entry.items()}
        return entry

    @property
    def plan(self) -> StudyTable:
        """A row a run, before anything is run: name, record, level, factor, values, intensities, as `tremolite study --list` prints it."""
        return StudyTable(self._plan)

    @property
    def result(self) -> StudyResult:
        """What is there so far, of this or an earlier start."""
        return StudyResult(self.out)

    def run(
        self,
        *,
        jobs: int | None = None,
        threads: int | None = None,
        only: str | None = None,
        shard: tuple[int, int] | None = None,
        retry: str | None = None,
        progress: Callable[[str], Any] | None = None,
    ) -> StudyResult:
        """Runs what is not yet done, `jobs` runs at a time with `threads` each, and returns the `StudyResult`.

        What is done stays and what has a checkpoint goes on, so a study that was stopped is started again in the same words. `only` is a
        word in names of runs; `shard=(3, 8)` the third of eight shares, for other machines or other processes; `retry` "failed",
        "not-converged", "error" or "all" runs those again. `progress(line)` is told what the command says.

        Ctrl-C stops all runs with their checkpoints and raises `Stopped`. Runs that did not come to their earthquake are warned of by
        `RunWarning`.
        """
        options: list[Any] = []
        for option, value in (("--jobs", jobs), ("--threads", threads), ("--only", only), ("--retry", retry)):
            options += [] if value is None else [option, value]
        if shard is not None:
            k, of = shard
            options += ["--shard", f"{k}/{of}"]
        self._command(options, progress)
        return self.result

    def gather(self) -> StudyResult:
        """Makes tables and page of what lies in the folder, and runs nothing."""
        self._command(["--gather"], None)
        return self.result

    def slurm(
        self, folder: str | os.PathLike[str], *, tasks: int | None = None, jobs: int | None = None, threads: int | None = None
    ) -> Path:
        """Writes a script of array tasks for Slurm into a folder, runs nothing, and returns the script's path."""
        options: list[Any] = ["--slurm", os.fspath(folder)]
        for option, value in (("--tasks", tasks), ("--jobs", jobs), ("--threads", threads)):
            options += [] if value is None else [option, value]
        self._command(options, None)
        return Path(folder, "study.sbatch")

    def _command(self, options: Sequence[Any], progress: Callable[[str], Any] | None) -> None:
        """Runs the command, which tells by its status how it ended."""
        words = [*_program(), "study", str(self.path), "--out", str(self.out), *map(str, options)]
        said: list[str] = []
        with subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, encoding="utf-8", errors="replace") as child:
            assert child.stderr is not None
            try:
                for line in child.stderr:
                    said.append(line.rstrip("\n"))
                    if progress is not None:
                        progress(said[-1])
            except BaseException as raised:
                # Ctrl-C, or what `progress` raised: the runs write their checkpoints.
                child.send_signal(signal.SIGINT)
                child.communicate()
                if isinstance(raised, KeyboardInterrupt):
                    stopped = Stopped(f"stopped; what is done is in {self.out}: run it again to go on")
                    stopped.out = self.out
                    raise stopped from None
                raise
        words_of_end = "\n".join(said[-40:])
        error = words_of_end.find("error")
        if child.returncode == 0:
            return
        if child.returncode == 1 and error < 0:
            warnings.warn(RunWarning(words_of_end), stacklevel=3)
        elif child.returncode == 3:
            stopped = Stopped(f"stopped from outside; what is done is in {self.out}: run it again to go on")
            stopped.out = self.out
            raise stopped
        else:
            raise (Error if child.returncode == 2 else RunError)(words_of_end[max(error, 0) :])

    def __repr__(self) -> str:
        return f"Study({str(self.path)!r}, {len(self.plan)} runs)"


def _program() -> list[str]:
    """What starts the command: this package's own."""
    python = sys.executable or shutil.which("python3")
    if not python:
        raise Error("nothing says how Python is started (sys.executable is empty), which runs a study's runs")
    return [python, "-m", "tremolite"]


def _entries(given: Any) -> list[tuple[str | None, Any]]:
    """Entries of a list of tables, of a list or of a dict by their names."""
    if isinstance(given, Mapping):
        return list(given.items())
    if isinstance(given, (list, tuple)):
        return [(None, entry) for entry in given]
    raise Error(f"{given!r} is no list of tables")


def _absolute(path: Any) -> str:
    return str(Path(path).absolute())


def _placed(key: str, value: Any) -> Any:
    return _absolute(value) if key == "file" else value


def _read(path: Path) -> str:
    try:
        return path.read_text(encoding="utf-8")
    except OSError as error:
        raise Error(f"{path}: {error.strerror}") from None
    except UnicodeDecodeError:
        raise Error(f"{path} is no text in UTF-8") from None


def _write(path: Path, text: str) -> None:
    """Writes a file, whole or not at all, where it is not there already."""
    if path.is_file() and path.read_bytes() == text.encode():
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    beside = path.with_name(f".{path.name}.{os.getpid()}")
    beside.write_bytes(text.encode())
    beside.replace(path)
