"""Studies from a script: the plan and the tables of the command, whoever starts it."""

import os
import pickle
import signal
import subprocess
import sys
import threading

import numpy as np
import pytest

import tremolite as tr
from conftest import pulse

TABLES = {
    "title": "a column under pulses",
    "vary": {"material.rock.young": {"values": ["1 GPa", "2 GPa"]}},
    "sample": {"kind": "grid"},
    "scale": {"measure": "PGV", "levels": ["0.1 m/s", "0.2 m/s"]},
    "measure": {"top": {"table": "monitors.csv", "column": "top.vx", "take": "max-abs"}},
    "fragility": [{"measure": "top", "above": 0.25, "failed": "exceeds", "bootstrap": 20}],
}


def made(column, out, **changes):
    return tr.Study(tr.Case.from_dict(column), out=out, record={"pulse": pulse()}, **{**TABLES, **changes})


def same(a, b):
    for name in ("plan.csv", "study.csv"):
        assert (a / name).read_bytes() == (b / name).read_bytes(), name


def test_a_study_of_a_script_is_the_commands(column, command, tmp_path):
    study = made(column, tmp_path / "script")
    assert [row["factor"] for row in study.plan] == pytest.approx([1.0 * study.plan[0]["factor"], 2.0 * study.plan[0]["factor"]] * 2)
    told = []
    result = study.run(jobs=2, threads=1, progress=told.append)
    assert any("4 runs" in line for line in told)
    assert study.plan.text == (tmp_path / "script" / "plan.csv").read_text()
    # The same file by the command, and by shards of a script that was sent elsewhere.
    file = str(tmp_path / "script" / "study.toml")
    subprocess.run([*command, "study", file, "--out", str(tmp_path / "command")], check=True, capture_output=True)
    same(tmp_path / "script", tmp_path / "command")
    shared = pickle.loads(pickle.dumps(tr.Study(file, out=tmp_path / "shards")))
    for k in (1, 2):
        shared.run(shard=(k, 2))
    shared.gather()
    same(tmp_path / "script", tmp_path / "shards")

    table = result.table
    assert table.units["top"] == "m/s" and len(table) == 4 and table["status"] == ["done"] * 4
    top = table["top"].reshape(2, 2)
    # Twice the motion is twice the answer, as all is elastic; a softer column sways more.
    assert top[:, 1] == pytest.approx(2.0 * top[:, 0], rel=1e-6)
    run = result.run(table[1]["run"])
    assert np.abs(run.monitors["top"].vx).max() == table["top"][1]
    assert "易损性" in result.page("zh").read_text(encoding="utf-8")
    curve = result.fragility("top", 0.25)
    if curve.fit is None:
        with pytest.raises(tr.Error, match="no curve"):
            curve.probability(0.1)
    # What is done stays done.
    before = (run.path / "summary.json").stat().st_mtime_ns
    study.run()
    assert (run.path / "summary.json").stat().st_mtime_ns == before


def test_a_curve_is_the_lognormal_of_its_numbers():
    curve = tr.Curve({"measure": "m", "above": 1.0, "by": "PGV", "unit": "m/s", "fit": {"theta": 0.2, "beta": 0.4}, "no_curve": ""})
    # The median, and one and two standard deviations above it.
    at = 0.2 * np.exp(0.4 * np.array([0.0, 1.0, 2.0]))
    assert curve.probability(at) == pytest.approx([0.5, 0.8413447460685429, 0.9772498680518208], rel=1e-12)
    assert curve.probability(0.0) == 0.0 and "median 0.2" in repr(curve)


def test_what_is_wrong_with_a_study_is_told_before_anything_runs(column, tmp_path):
    with pytest.raises(tr.CaseError) as caught:
        made(column, tmp_path / "a", vary={"material.rock.yuong": {"values": ["1 GPa"]}})
    (problem,) = caught.value.problems
    assert "yuong" in problem.message and "young" in problem.remedy and problem.line
    assert not (tmp_path / "a" / "study.toml").exists() and not (tmp_path / "a" / "runs").exists()
    with pytest.raises(tr.CaseError, match="sampel"):
        made(column, tmp_path / "a", sampel={"kind": "grid"})
    with pytest.raises(tr.Error, match="given twice"):
        tr.Study({"case": "a.toml", "title": "a"}, title="b")
    with pytest.raises(tr.Error, match="has a case"):
        tr.Study({"title": "a"}, out=tmp_path / "a")
    with pytest.raises(tr.Error, match="No such file"):
        tr.Study(tmp_path / "none.toml")
    study = made(column, tmp_path / "b")
    with pytest.raises(tr.Error, match="no study.csv yet"):
        study.result.table  # noqa: B018
    with pytest.raises(tr.Error, match="shard"):
        study.run(shard=(3, 2))
    assert study.slurm(tmp_path / "slurm", tasks=2).read_text().count("--shard") == 1


def test_a_mesh_of_a_script_is_as_one_of_the_case(column, tmp_path):
    one = {"vary": {}, "sample": None, "scale": {"measure": "PGV", "levels": ["0.1 m/s"]}, "fragility": None}
    plain = made(column, tmp_path / "plain", **one).run(threads=1)
    mesh = tr.Case.from_dict(column).mesh()
    case = tr.Case.from_dict({**column, "mesh": {"file": {"path": "memory"}}})
    study = made({**column, "mesh": {"file": {"path": "memory"}}}, tmp_path / "memory", mesh=mesh, **one)
    files = [result.run(result.table[0]["run"]).path / "monitors.csv" for result in (plain, study.run(threads=1))]
    assert files[0].read_bytes() == files[1].read_bytes()
    with pytest.raises(tr.Error, match="mesh is a Mesh"):
        tr.Study(case, out=tmp_path / "c", mesh="box.vtu")


def test_the_name_of_a_record_is_no_path(column, tmp_path):
    # Its samples went beside the study's folder, before the name was refused.
    out = tmp_path / "in" / "out"
    with pytest.raises(tr.Error, match="cannot be used as a name"):
        tr.Study(tr.Case.from_dict(column), out=out, record={"../../x": pulse()}, **TABLES)
    assert len(tr.Study(tr.Case.from_dict(column), out=out, record={"a/b": pulse()}, **TABLES).plan) == 4
    assert [path.name for path in tmp_path.iterdir()] == ["in"] and [path.name for path in (tmp_path / "in").iterdir()] == ["out"]


def test_intensities_of_a_curve_are_in_the_unit_of_the_levels():
    fit = {"theta": 20.0, "beta": 0.4}
    curve = tr.Curve({"measure": "m", "above": 1.0, "by": "PGV", "unit": "cm/s", "unit_value": 0.01, "fit": fit, "no_curve": ""})
    assert curve.probability(0.2, units="SI") == pytest.approx(0.5, rel=1e-12) and curve.probability(20.0) == pytest.approx(0.5, rel=1e-12)
    with pytest.raises(tr.Error, match="cm/s"):
        curve.probability(20.0, units="cm/s")


def test_a_failed_run_is_warned_of_and_stays_in_the_table(column, tmp_path):
    # Nothing rests within a cycle: the runs do not come to their earthquake.
    column = {**column, "initial": {"stress": {"zz": "-1 MPa"}, "release_cycles": 1, "max_cycles": 2}}
    study = made(column, tmp_path / "a", scale={"measure": "PGV", "levels": ["0.1 m/s"]}, vary={}, sample=None)
    with pytest.warns(tr.RunWarning, match="not at rest"):
        result = study.run()
    assert result.table["status"] == ["not_converged"] and np.isnan(result.table["top"]).all()


def test_ctrl_c_stops_a_study_in_good_order_and_it_goes_on(column, tmp_path):
    slow = {**column, "dynamic": {**column["dynamic"], "safety": 0.002}}
    whole = made(slow, tmp_path / "whole", vary={}, sample=None).run()
    study = made(slow, tmp_path / "a", vary={}, sample=None)

    pressed = []

    def press(line):
        # Once: each row is told of, and a second Ctrl-C would stop the test.
        if line.endswith("…") and not pressed:
            pressed.append(line)
            threading.Timer(0.4, os.kill, (os.getpid(), signal.SIGINT)).start()

    with pytest.raises(tr.Stopped) as caught:
        study.run(jobs=1, progress=press)
    assert caught.value.out == study.out
    result = study.run()
    assert (whole.path / "study.csv").read_bytes() == (result.path / "study.csv").read_bytes()


def test_tables_are_data_frames_where_pandas_is_there(column, tmp_path):
    pandas = pytest.importorskip("pandas")
    frame = made(column, tmp_path / "a").plan.to_pandas()
    assert isinstance(frame, pandas.DataFrame) and frame.index.name == "run" and frame.attrs["units"]["PGV"] == "m/s"


def test_a_study_without_a_program_to_start_says_so(column, tmp_path, monkeypatch):
    study = made(column, tmp_path / "a")
    monkeypatch.setattr(sys, "executable", "")
    monkeypatch.setenv("PATH", "")
    with pytest.raises(tr.Error, match="how Python is started"):
        study.run()
