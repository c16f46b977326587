"""Simulations that a script drives."""

import threading

import numpy as np
import pytest

import tremolite as tr
from conftest import EQUAL, pulse, same_files


def test_a_run_in_pieces_has_the_bytes_of_one_at_once(job, tmp_path):
    whole = job.run(tmp_path / "whole")
    with job.start(tmp_path / "pieces") as simulation:
        while simulation.step(7):
            # Without the reference column beside the model.
            assert simulation.look().displacement.shape == job.mesh.points.shape == (44, 3)
        assert simulation.time == pytest.approx(0.99) and simulation.taken == job.steps
    assert tr.Result(tmp_path / "pieces").status == "done"
    assert same_files(whole.path, tmp_path / "pieces") == []


def test_stages_come_one_by_one_and_before_steps(cavern, tmp_path):
    job = tr.Job(tr.Case(cavern).with_({"dynamic.duration": "0.05 s"}))
    whole = job.run(tmp_path / "whole")
    with job.start(tmp_path / "a") as simulation:
        with pytest.raises(tr.RunError, match=r"stages\(\)"):
            simulation.step()
        seen = {}
        for stage in simulation.stages():
            look = simulation.look()
            assert look.stage == stage.name and stage.ratio < 1e-4 and stage.cycles > 0
            seen[stage.name] = (len(look.elements("hall.lining")), np.abs(look.displacement).max(), look.velocity.any())
        assert list(seen) == ["initial equilibrium", "excavation", "lining"]
        assert seen["excavation"][0] == 0 and seen["lining"][0] > 0
        assert seen["excavation"][1] > 100 * seen["initial equilibrium"][1]
        assert not any(moves for *_, moves in seen.values())
        assert simulation.stage is None and simulation.look().time == 0.0
        simulation.step(10**6)
    assert same_files(whole.path, tmp_path / "a") == []


def test_a_script_decides_between_stages_what_comes_next(cavern, tmp_path):
    case = tr.Case(cavern).with_({"dynamic.duration": "0.02 s"})
    keys = case.to_dict()
    first = tr.Case.from_dict({**keys, "stage": keys["stage"][:1]}, case.directory)
    job = tr.Job(first)
    with job.start(tmp_path / "a") as simulation:
        names = []
        for stage in simulation.stages():
            names.append(stage.name)
            if stage.name == "excavation" and np.abs(simulation.look().displacement).max() > 1e-4:
                with pytest.raises(tr.CaseError, match="did you mean `install`"):
                    simulation.add_stage({"name": "lining", "instal": ["hall.lining"]})
                simulation.add_stage(keys["stage"][1])
        assert names == ["initial equilibrium", "excavation", "lining"]
        simulation.step(10)
        with pytest.raises(tr.Error, match="shakes already"):
            simulation.add_stage({"name": "more"})
        simulation.step(10**6)
    whole = tr.Job(case).run(tmp_path / "whole")
    assert same_files(whole.path, tmp_path / "a") == []
    with job.start(tmp_path / "b", callback=print) as simulation, pytest.raises(tr.Error, match="callback"):
        simulation.add_stage(keys["stage"][1])


def test_it_can_be_left_gone_back_to_and_gone_on_with(job, tmp_path):
    whole = job.run(tmp_path / "whole")
    simulation = job.start(tmp_path / "a")
    simulation.step(100)
    there = simulation.look().displacement
    simulation.checkpoint()
    simulation.step(50)
    assert (simulation.look().displacement != there).any()
    simulation.restore()
    assert simulation.taken == 100 and (simulation.look().displacement == there).all()
    assert simulation.finish().status == "stopped"
    with pytest.raises(tr.Error, match="finished"):
        simulation.step()
    with job.start(tmp_path / "a", resume=True) as simulation:
        assert simulation.taken == 100
        simulation.step(10**6)
    assert same_files(whole.path, tmp_path / "a", EQUAL[:3]) == []


def test_two_simulations_go_in_turn_without_touching_each_other(job, tmp_path):
    other = tr.Job(job.case.with_({"material.rock.young": "4 GPa"}), motion=pulse())
    alone = [job.run(tmp_path / "a"), other.run(tmp_path / "b")]
    with job.start(tmp_path / "c") as first, other.start(tmp_path / "d", threads=1) as second:
        going = [True, True]
        while any(going):
            going = [first.step(11), second.step(5)]
    for whole, name in zip(alone, "cd", strict=True):
        assert same_files(whole.path, tmp_path / name) == []


def test_an_exception_leaves_results_that_can_be_gone_on_with(job, tmp_path):
    with pytest.raises(ZeroDivisionError), job.start(tmp_path / "a") as simulation:
        simulation.step(100)
        1 / 0  # noqa: B018
    assert tr.Result(tmp_path / "a").status == "stopped"
    assert job.run(tmp_path / "a", resume=True).status == "done"


def test_one_thread_drives_at_a_time(job, tmp_path):
    raised = []

    def meddle(now):
        try:
            simulation.step()
        except tr.Error as error:
            raised.append(str(error))

    simulation = job.start(tmp_path / "a", callback=meddle, every=10)
    threading.Thread(target=simulation.step, args=(25,)).run()
    assert raised and "driven by" in raised[0]
    simulation.finish()


def test_looks_show_stress_history_and_energy_by_group(cavern, tmp_path):
    case = tr.Case(cavern).with_(
        {
            "material.concrete.law": "concrete-damage",
            "material.concrete.tensile_strength": "1.2 MPa",
            "material.concrete.fracture_energy": "130 N/m",
            "material.concrete.cohesion": "2 MPa",
            "material.concrete.friction_angle": "46 deg",
            "dynamic.duration": "0.02 s",
        }
    )
    job = tr.Job(case)
    mesh = job.mesh
    with job.start(tmp_path / "a") as simulation:
        for _ in simulation.stages():
            pass
        simulation.step(3)
        look = simulation.look()
    lining = look.elements("*.lining")
    assert set(lining) <= set(mesh.groups["hall.lining"]) and look.displacement.shape == mesh.points.shape
    points = look.points_of("*.lining")
    damage = look.history("*.lining", "d_tension")
    assert look.columns("*.lining")["d_tension"] == "1"
    assert len(points) == len(damage) == len(look.stress("*.lining")) and set(points) == set(lining)
    # The mean over one-point elements is the point's own.
    assert (look.stress("rock") == look.mean_stress("rock")).all()
    # Strain is counted from the hand-over on, where stress is already: so early it may go either way.
    assert look.energy["kinetic"] > 0 and {"strain", "error"} <= set(look.energy)
    assert np.isnan(look.history(["rock", "hall.lining"], "d_tension")).any()
    with pytest.raises(tr.Error, match="hall.lining"):
        look.stress("hal.lining")
    with pytest.raises(tr.Error, match="d_tension"):
        look.history("hall.lining", "damage")
