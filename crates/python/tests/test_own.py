"""Observers and forces of a script's own."""

import os
import signal

import numpy as np
import pytest

import tremolite as tr
from conftest import EQUAL, same_files

TOP = [40, 41, 42, 43]
SHEAR = np.sqrt(0.8e9 / 2500.0)


class Damper(tr.NodalForce):
    """Takes up a shear wave that comes from below: the column's impedance, 4 m2 over four nodes."""

    nodes = TOP
    damping = 2500.0 * SHEAR

    def forces(self, t, u, v):
        return -self.damping * v * [1.0, 1.0, 0.0]


class Push(tr.NodalForce):
    """Goes by time alone."""

    nodes, stiffness = TOP, 0.0

    def forces(self, t, u, v):
        return (1e4 * np.sin(20.0 * t), 0.0, -2e4 * np.sin(9.0 * t))


class Slider(tr.NodalForce):
    """A spring that slides: it remembers where it is held."""

    nodes, stiffness, remembers = TOP[:2], 1e8, 2

    def forces(self, t, u, v, held):
        force = self.stiffness * (held - u[:, 0])
        slides = np.abs(force) > 500.0
        held[slides] = (u[:, 0] + np.sign(force) * 500.0 / self.stiffness)[slides]
        self.slid = getattr(self, "slid", 0) + slides.sum()
        return np.stack([self.stiffness * (held - u[:, 0]), np.zeros(2), np.zeros(2)], axis=1)


def test_dashpots_of_a_script_absorb_the_wave_that_a_free_top_reflects(job, tmp_path):
    free = job.run(tmp_path / "free")
    damped = job.with_fields(forces=[Damper()]).run(tmp_path / "damped")
    most = [np.abs(result.monitors["top"].vx).max() for result in (free, damped)]
    # At the middle of the top element, whose motion the reflected wave meets 3.5 ms later: 1 m of 30 of the pulse's length.
    assert most[1] / most[0] == pytest.approx(0.5, abs=0.01)
    energy = damped.energy
    # It takes what comes in past the base's own dashpots: nothing comes back.
    assert -energy["own_forces"][-1] == pytest.approx(energy["input"][-1] - energy["base_dashpots"][-1], rel=0.01)
    assert np.abs(energy["error"]).max() < 2e-3 * np.abs(energy["own_forces"]).max()
    assert "own_forces" not in free.energy
    assert "force Damper" in [entry["name"] for entry in damped.summary["inputs"]]


def test_a_force_by_time_is_the_load_of_the_same_history(job, tmp_path):
    t = np.linspace(0.0, 1.5, 150001)
    loads = [(TOP, (1e4, 0.0, 0.0), t, np.sin(20.0 * t)), (TOP, (0.0, 0.0, -2e4), t, np.sin(9.0 * t))]
    a = job.with_fields(loads=loads).run(tmp_path / "a")
    b = job.with_fields(forces=[Push()]).run(tmp_path / "b")
    for name in ("ux", "uz"):
        values = a.monitors["top"][name]
        # The history is linear between its times: 2e-5 of its curvature.
        assert np.abs(b.monitors["top"][name] - values).max() < 1e-8 * np.abs(values).max() > 0.0
    assert np.abs(b.energy["own_forces"] + b.energy["input"] - a.energy["input"]).max() < 1e-8 * np.abs(a.energy["input"]).max()


def test_the_step_goes_by_declared_rates_and_names_who_sets_it(job):
    class Stiff(Damper):
        damping = 1e3 * Damper.damping

    damped = job.with_fields(forces=[Stiff()])
    assert damped.dt < 0.1 * job.dt and "Stiff" in str(damped.check())
    assert job.with_fields(forces=[Push()]).dt == job.dt


def test_what_a_force_remembers_is_in_the_checkpoint(job, tmp_path):
    slider = Slider()
    sliding = job.with_fields(forces=[slider])
    whole = sliding.run(tmp_path / "whole", threads=1)
    assert slider.slid > 10
    sliding.run(tmp_path / "a", callback=lambda now: now.time < 0.45, every=3)
    assert tr.Result(tmp_path / "a").status == "stopped"
    resumed = sliding.run(tmp_path / "a", resume=True)
    assert same_files(whole.path, resumed.path, EQUAL[:3]) == []
    # Looks ask it on a copy of what it remembers.
    looked = sliding.run(tmp_path / "b", callback=lambda now: True, every=1)
    assert same_files(whole.path, looked.path, EQUAL[:3]) == []


def test_forces_act_from_where_the_ground_rests_after_its_stages(cavern, tmp_path):
    job = tr.Job(tr.Case(cavern).with_({"dynamic.duration": "0.05 s"}))
    floor = job.mesh.points[job.mesh.nodes_of("hall.lining")]
    nodes = job.mesh.nodes_of("hall.lining")[np.argsort(floor[:, 2])[:3]]

    class Probe(tr.NodalForce):
        stiffness = 0.0
        seen = []

        def forces(self, t, u, v):
            self.seen.append((t, np.abs(u).max(), np.abs(v).max()))
            return np.zeros(3)

    probe = Probe()
    probe.nodes = nodes
    plain = job.run(tmp_path / "plain")
    probed = job.with_fields(forces=[probe]).run(tmp_path / "probed")
    assert probe.seen[0] == (0.0, 0.0, 0.0) and probe.seen[-1][1] > 0.0 and min(t for t, *_ in probe.seen) == 0.0
    assert np.array_equal(plain.monitors.table["time"], probed.monitors.table["time"])
    assert np.abs(probed.energy["own_forces"]).max() == 0.0
    name = next(iter(plain.monitors))
    # Zeros are added: the bits stay.
    assert same_files(plain.path, probed.path, ["monitors.csv"]) == [], name


def test_ctrl_c_within_a_force_stops_in_good_order(job, tmp_path):
    whole = job.with_fields(forces=[Damper()]).run(tmp_path / "whole")

    class Pressed(Damper):
        name, pressed = "Damper", False

        def forces(self, t, u, v):
            if t > 0.3 and not self.pressed:
                self.pressed = True
                os.kill(os.getpid(), signal.SIGINT)
            return super().forces(t, u, v)

    pressed = job.with_fields(forces=[Pressed()])
    with pytest.raises(tr.Stopped):
        pressed.run(tmp_path / "a")
    assert same_files(whole.path, pressed.run(tmp_path / "a", resume=True).path, EQUAL[:3]) == []


def test_an_exception_of_a_force_comes_through_and_spoils_no_checkpoint(job, tmp_path):
    whole = job.with_fields(forces=[Damper()]).run(tmp_path / "whole")

    class Broken(Damper):
        name, broken = "Damper", True

        def forces(self, t, u, v):
            if t > 0.5 and self.broken:
                raise ValueError("no force")
            return super().forces(t, u, v)

    broken = Broken()
    job = job.with_fields(forces=[broken])
    # Its results say what a step without forces leaves.
    with pytest.raises(ValueError, match="no force"), pytest.warns(tr.RunWarning), job.start(tmp_path / "a") as simulation:
        simulation.step(300)
        simulation.checkpoint()
        simulation.step(10**6)
    broken.broken = False
    assert same_files(whole.path, job.run(tmp_path / "a", resume=True).path, EQUAL[:3]) == []


def test_simulations_of_one_job_with_forces_go_in_turn(job, tmp_path):
    job = job.with_fields(forces=[Slider()])
    whole = job.run(tmp_path / "whole")
    with job.start(tmp_path / "a") as first, job.start(tmp_path / "b", threads=1) as second:
        going = [True, True]
        while any(going):
            going = [first.step(11), second.step(5)]
    for name in "ab":
        assert same_files(whole.path, tmp_path / name, EQUAL[:3]) == []


def test_forces_that_cannot_be_are_refused_in_words(job, tmp_path):
    def made(**attributes):
        return type("Odd", (tr.NodalForce,), {"nodes": TOP, "stiffness": 0.0, "forces": lambda self, t, u, v: u, **attributes})()

    for force, words in [
        (made(stiffness=None), "declares no rate"),
        (made(stiffness=-1.0), "0 or more"),
        (made(nodes=[44]), "no node 44"),
        (made(nodes=[1, 1]), "each once"),
        (made(nodes=None), "nodes"),
        (Damper, "objects"),
        (print, "no method forces"),
    ]:
        with pytest.raises(tr.Error, match=words):
            job.with_fields(forces=[force])
    with pytest.raises(tr.Error, match="two forces"):
        job.with_fields(forces=[made(), made()])
    for said, words in [(np.zeros((3, 3)), "give \\(4, 3\\)"), (np.full((4, 3), np.nan), "not finite"), ("x", "could not convert")]:
        with pytest.raises((tr.Error, ValueError), match=words):
            job.with_fields(forces=[made(forces=lambda self, t, u, v, said=said: said)]).run(tmp_path / "a", overwrite=True)


class Drift(tr.Observer):
    """The largest displacement, and how often it looked."""

    every = 3

    def begin(self, at):
        self.at = at
        self.most = at.memory.setdefault("most", np.zeros(1))
        self.looks = at.memory.setdefault("looks", np.zeros(1))

    def see(self, now):
        np.maximum(self.most, np.abs(now.displacement).max(), out=self.most)
        self.looks += 1
        assert now.memory["most"] is self.most

    def end(self):
        self.ended = True


def test_observers_remember_and_a_resumed_run_goes_on_with_it(job, tmp_path):
    whole, plain = Drift(), job.run(tmp_path / "plain")
    result = job.run(tmp_path / "whole", observers=[whole])
    assert whole.ended and whole.at.out == tmp_path / "whole" and whole.at.stage is None
    assert same_files(plain.path, result.path, EQUAL[:3]) == []
    other = Drift()
    other.name = "other"
    first = job.run(tmp_path / "a", observers=[Drift(), other], callback=lambda now: now.time < 0.5, every=7)
    assert first.status == "stopped"
    again, other_again = Drift(), Drift()
    other_again.name = "other"
    job.run(tmp_path / "a", observers=[again, other_again], callback=lambda now: True, every=7, resume=True)
    for one in (again, other_again):
        assert one.most[0] == whole.most[0] > 0.0 and one.looks[0] == whole.looks[0]


def test_an_observer_goes_back_with_its_simulation(job, tmp_path):
    drift = Drift()
    with job.start(tmp_path / "a", observers=[drift]) as simulation:
        simulation.step(100)
        simulation.checkpoint()
        there = drift.looks.copy()
        simulation.step(50)
        assert drift.looks > there
        simulation.restore()
        simulation.step(1)
        assert drift.looks <= there + 1


def test_ctrl_c_within_an_observer_loses_no_look(job, tmp_path):
    whole = Drift()
    job.run(tmp_path / "whole", observers=[whole])

    class Pressed(Drift):
        name, pressed = "Drift", False

        def see(self, now):
            super().see(now)
            if now.time > 0.3 and not self.pressed:
                self.pressed = True
                os.kill(os.getpid(), signal.SIGINT)
                for _ in range(1000):
                    pass

    pressed = Pressed()
    with pytest.raises(tr.Stopped):
        job.run(tmp_path / "a", observers=[pressed])
    job.run(tmp_path / "a", observers=[pressed], resume=True)
    assert pressed.looks[0] == whole.looks[0] and pressed.most[0] == whole.most[0]


def test_observers_see_stages_and_stop_them(cavern, tmp_path):
    class Names(tr.Observer):
        def __init__(self):
            self.begun, self.seen = [], []

        def begin(self, at):
            self.begun.append(at.stage)

        def see(self, now):
            self.seen.append(now.stage)
            return now.stage != "excavation"

    names = Names()
    result = tr.Job(tr.Case(cavern).with_({"dynamic.duration": "0.01 s"})).run(tmp_path / "a", observers=[names])
    assert names.seen == ["initial equilibrium", "excavation"] and names.begun[:2] == names.seen and result.status == "stopped"


def test_observers_that_cannot_be_are_refused_in_words(job, tmp_path):
    class Every(Drift):
        every = "0.1 m"

    for observers, words in [([Drift(), Drift()], "another `name`"), ([Drift], "objects"), ([1], "no method see"), ([Every()], "every")]:
        with pytest.raises(tr.Error, match=words):
            job.run(tmp_path / "a", observers=observers)

    class Wide(tr.Observer):
        def see(self, now):
            now.memory["u"] = now.displacement

    with pytest.raises(tr.Error, match=r"keep array.ravel\(\)"):
        job.run(tmp_path / "a", observers=[Wide()])
    with pytest.raises(NotImplementedError):
        job.run(tmp_path / "b", observers=[tr.Observer()])
