"""Tables of a script's own: rows behind a checkpoint go, none comes twice, none is missing."""

import os
import signal

import numpy as np
import pytest

import tremolite as tr


def roof(now):
    """A row of each kind: a number, and an array."""
    now.record("roof", {"u [m]": np.abs(now.displacement).max(), "v [m/s]": now.velocity[0], "seen": len(now.displacement)})


def text(result, name="roof"):
    return (result.path / "own" / f"{name}.csv").read_text()


def test_rows_stand_beside_the_time_with_their_units(job, tmp_path):
    plain = job.run(tmp_path / "plain")
    times = []
    result = job.run(tmp_path / "a", callback=lambda now: times.append(now.time) or roof(now), every="0.05 s")
    table = result.own["roof"]
    assert text(result).splitlines()[0] == "time [s],u [m],v0 [m/s],v1 [m/s],v2 [m/s],seen"
    assert (table.time == times).all() and table.u.max() > 0.0 and table.units["v1"] == "m/s" and (table.seen == 44).all()
    assert list(result.own) == ["roof"] and "roof" in repr(result.own)
    # What is recorded changes nothing else.
    for name in ("monitors.csv", "energy.csv"):
        assert (plain.path / name).read_bytes() == (result.path / name).read_bytes()
    assert len(plain.own) == 0
    with pytest.raises(KeyError, match="roof"):
        result.own["floor"]


@pytest.mark.parametrize("how", ["false", "raises", "ctrl-c"])
def test_a_resumed_run_has_each_row_once(job, tmp_path, how):
    whole = job.run(tmp_path / "whole", callback=roof, every=7)
    pressed = []

    def leaves(now):
        roof(now)
        if now.time > 0.4:
            now.record("late", {"n": 1.0})
            if how == "ctrl-c" and not pressed:
                pressed.append(now.time)
                os.kill(os.getpid(), signal.SIGINT)
                for _ in range(1000):
                    pass
            if how == "raises" and now.time > 0.5:
                raise ValueError("enough")
        return how != "false" or now.time < 0.5

    if how == "false":
        job.run(tmp_path / "a", callback=leaves, every=7)
    else:
        with pytest.raises(ValueError if how == "raises" else tr.Stopped):
            job.run(tmp_path / "a", callback=leaves, every=7)
    result = job.run(tmp_path / "a", callback=roof, every=7, resume=True)
    rows, all_rows = text(result).splitlines(), text(whole).splitlines()
    # A look in which the script raised is behind the checkpoint, and what it recorded is left out: as what it remembers is.
    missing = [row for row in all_rows if row not in rows]
    assert len(missing) == (1 if how == "raises" else 0)
    assert rows == [row for row in all_rows if row not in missing]


def test_rows_behind_a_checkpoint_are_dropped(job, tmp_path):
    whole = job.run(tmp_path / "whole", callback=roof, every=5)
    with job.start(tmp_path / "a", callback=roof, every=5) as simulation:
        simulation.step(100)
        simulation.checkpoint()
        at = (tmp_path / "a/own/roof.csv").read_text().count("\n")
        simulation.step(60)
        assert (tmp_path / "a/own/roof.csv").read_text().count("\n") > at
        simulation.restore()
        while simulation.step(50):
            pass
    assert (tmp_path / "a/own/roof.csv").read_text() == text(whole)


def test_stages_and_observers_record_too(cavern, tmp_path):
    class Inward(tr.Observer):
        every = "0.005 s"

        def see(self, now):
            now.record("walls", {"inward [m]": np.nanmax(np.abs(now.displacement))})
            return now.time < 0.012

    job = tr.Job(tr.Case(cavern).with_({"dynamic.duration": "0.02 s"}))
    result = job.run(tmp_path / "a", observers=[Inward()], callback=lambda now: now.record("walls", {"inward [m]": 0.0}))
    walls = result.own["walls"]
    # Two stages and the equilibrium, then the earthquake; two write to one table.
    assert result.status == "stopped" and (walls.time[:6] == 0.0).all() and walls.inward[0] == 0.0 and walls.inward[5] > 0.0
    # Another run that begins with these stages has tables of its own.
    other = job.run(tmp_path / "b", from_=result.path, observers=[Inward()])
    assert other.own["walls"].time[0] == 0.0 and len(other.own["walls"].time) < len(walls.time)
    job.run(tmp_path / "b", overwrite=True)
    assert len(tr.Result(tmp_path / "b").own) == 0


def test_what_is_no_row_is_refused_in_words(job, tmp_path):
    for name, values, words in [
        ("a/b", {"u": 1.0}, "name of a table"),
        ("a", {}, "no number is given"),
        ("a", {"u m": 1.0}, "heads no column"),
        ("a", {"u [m]": "x"}, "no number and no array"),
        ("a", {"u [m]": np.zeros((2, 2))}, "no number and no array"),
        ("a", {"time [s]": 1.0}, "two columns"),
        ("a", {"u0": 1.0, "u": [1.0]}, "two columns"),
    ]:
        with pytest.raises(tr.Error, match=words):
            job.run(tmp_path / "a", callback=lambda now, name=name, values=values: now.record(name, values), overwrite=True)
    with pytest.raises(tr.RunError, match="record the same each time"):
        job.run(tmp_path / "a", callback=lambda now: now.record("a", {f"u{now.step}": 1.0}), every=5, overwrite=True)
    with job.start(tmp_path / "b") as simulation, pytest.raises(tr.Error, match="callback"):
        simulation.look().record("a", {"u": 1.0})
