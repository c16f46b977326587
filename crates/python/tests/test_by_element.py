"""Materials that differ by element."""

import numpy as np
import pytest

import tremolite as tr
from conftest import pulse, same_files


def test_factors_of_one_leave_the_run_as_it_is(column, tmp_path):
    case = tr.Case.from_dict(column)
    made, mesh = tr.by_element(case, "rock", {"young": np.ones(10)})
    assert made.to_dict()["material"]["rock-00"]["young"] == "2.0 GPa" and "rock" not in made.to_dict()["material"]
    a = tr.Job(case, motion=pulse()).run(tmp_path / "a")
    b = tr.Job(made, mesh=mesh, motion=pulse()).run(tmp_path / "b")
    assert same_files(a.path, b.path, ["monitors.csv", "energy.csv"]) == []


def test_a_layered_column_is_that_of_two_materials(column, tmp_path):
    case = tr.Case.from_dict(column)
    z = case.mesh().centroids[:, 2]
    made, mesh = tr.by_element(case, "rock", {"young": np.where(z > -10.0, 0.5, 1.0)}, classes=2)
    keys = made.to_dict()
    assert {m["young"] for m in keys["material"].values()} == {"1.0 GPa", "2.0 GPa"}
    groups = {"upper": np.flatnonzero(z > -10.0), "lower": np.flatnonzero(z < -10.0)}
    column["mesh"] = {"file": {"path": "memory"}}
    rock = column["material"]["rock"]
    column["material"] = {"upper": {**rock, "young": "1 GPa"}, "lower": rock}
    column["region"] = [{"groups": [name], "material": name, "element": "reduced-integration"} for name in groups]
    plain = tr.Mesh(mesh.points, mesh.cells, groups)
    a = tr.Job(tr.Case.from_dict(column), mesh=plain, motion=pulse()).run(tmp_path / "a")
    b = tr.Job(made, mesh=mesh, motion=pulse()).run(tmp_path / "b")
    # Bodies may stand in another order, and so sums.
    assert np.allclose(a.monitors["top"].ux, b.monitors["top"].ux, rtol=1e-9, atol=1e-15)


def test_a_random_field_in_stages_runs_with_its_classes_in_the_summary(cavern, tmp_path):
    case = tr.Case(cavern).with_({"dynamic.duration": "0.01 s"})
    field = np.exp(0.3 * np.random.default_rng(5).standard_normal(len(case.mesh())))
    made, mesh = tr.by_element(case, "rock", {"young": field}, classes=4)
    result = tr.Job(made, mesh=mesh).run(tmp_path / "a")
    assert result.status == "done" and {f"rock-{k:02d}" for k in range(4)} <= set(result.summary["materials"])
    assert [row["name"] for row in result.rows("stages")] == ["initial equilibrium", "excavation", "lining"]
    # Means of classes: the spread that is lost is at most a quarter of the field's range in the logarithm.
    classes = {name: float(m["young"].split()[0]) / 10 for name, m in made.to_dict()["material"].items() if name.startswith("rock-")}
    lost = [np.abs(np.log(field[mesh.groups[name]] / factor)).max() for name, factor in classes.items() if name in mesh.groups]
    assert max(lost) <= np.ptp(np.log(field)) / 4


def test_factors_that_do_not_fit_are_refused_in_words(column):
    case = tr.Case.from_dict(column)
    for material, factors, words in [
        ("roc", {"young": np.ones(10)}, "there are rock"),
        ("rock", {"yuong": np.ones(10)}, "it has law, young"),
        ("rock", {"young": np.ones(9)}, "10 elements"),
        ("rock", {"young": np.zeros(10)}, "not above 0"),
        ("rock", {"law": np.ones(10)}, "no number"),
    ]:
        with pytest.raises(tr.Error, match=words):
            tr.by_element(case, material, factors)


def test_a_field_of_a_job_is_read_and_set(column, tmp_path):
    job = tr.Job(tr.Case.from_dict(column), motion=pulse())
    young = job.field("rock.young")
    assert (young[:] == 2e9).all() and len(young) == 10 and list(young.elements) == list(range(10))
    upper = young.centroids[:, 2] > -10.0
    young[upper] = 1e9
    assert (job.field("rock.young")[:] == np.where(upper, 1e9, 2e9)).all() and (young.of_classes == young[:]).all()
    density = job.field("rock.density")
    density[:] = 2400.0
    a = job.run(tmp_path / "a")
    assert [entry["name"] for entry in a.summary["inputs"]][-2:] == ["rock.young by element", "rock.density by element"]

    case = tr.Case.from_dict(column).with_({"material.rock.density": "2400 kg/m3"})
    made, mesh = tr.by_element(case, "rock", {"young": np.where(upper, 0.5, 1.0)})
    b = tr.Job(made, mesh=mesh, motion=pulse()).run(tmp_path / "b")
    assert same_files(a.path, b.path, ["monitors.csv", "energy.csv"]) == []
    young[:] = 2e9
    density[:] = 2500.0
    plain = tr.Job(tr.Case.from_dict(column), motion=pulse()).run(tmp_path / "plain")
    assert same_files(plain.path, job.run(tmp_path / "again").path, ["monitors.csv", "energy.csv"]) == []


def test_fields_stay_with_stages_stress_forces_and_changes(cavern, tmp_path):
    job = tr.Job(tr.Case(cavern).with_({"dynamic.duration": "0.01 s"}))
    assert job.initial_stress.any()
    young = job.field("rock.young", classes=4)
    young[:] = young[:] * np.exp(0.3 * np.random.default_rng(5).standard_normal(len(young)))
    stress = 0.9 * job.initial_stress
    job = job.with_fields(initial_stress=stress)
    assert job.field("rock.young")[:].std() > 0.0 and np.allclose(job.initial_stress, stress)
    result = job.run(tmp_path / "a", set={"dynamic.duration": "0.02 s"})
    assert result.status == "done" and {"rock-00", "rock-01"} <= set(result.summary["materials"])
    lost = np.abs(np.log(young.of_classes / young[:])).max()
    assert 0.0 < lost <= np.ptp(np.log(young[:])) / 4


def test_a_mesh_of_a_file_in_other_units_keeps_its_size(column, tmp_path):
    mesh = tr.Case.from_dict(column).mesh()
    tr.Mesh(mesh.points * 1000.0, mesh.cells, {"rock": np.arange(10)}).write(tmp_path / "box.vtu")
    column["mesh"] = {"file": {"path": str(tmp_path / "box.vtu"), "unit": "1 mm"}}
    made, read = tr.by_element(tr.Case.from_dict(column), "rock", {"young": np.ones(10)})
    assert np.allclose(tr.Job(made, mesh=read, motion=pulse()).mesh.points, mesh.points)


def test_fields_that_cannot_be_are_refused_in_words(column):
    job = tr.Job(tr.Case.from_dict(column), motion=pulse())
    for name, words in [
        ("young", "there are rock"),
        ("roc.young", "there are rock"),
        ("rock.yuong", "it has law, young"),
        ("rock.law", "no number"),
    ]:
        with pytest.raises(tr.Error, match=words):
            job.field(name)
    young = job.field("rock.young")
    with pytest.raises(tr.Error, match="not above 0"):
        young[3] = -1.0
    with pytest.raises(ValueError, match="broadcast"):
        young[:] = np.ones(9)
    with pytest.raises(tr.CaseError, match="poisson"):
        job.field("rock.poisson")[:] = 0.7
    assert (job.field("rock.poisson")[:] == 0.25).all()
