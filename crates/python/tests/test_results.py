"""Result folders, read."""

import copy
import math
import pickle

import pytest

import tremolite as tr
from conftest import pulse


@pytest.fixture(scope="module")
def result(tmp_path_factory):
    import warnings

    from conftest import COLUMN

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", tr.CaseWarning)
        return tr.Job(tr.Case.from_dict(COLUMN), motion=pulse()).run(tmp_path_factory.mktemp("results") / "a")


def test_tables_have_columns_units_and_subjects(result):
    text = (result.path / "monitors.csv").read_text().splitlines()
    table = result.monitors.table
    assert text[0].split(",")[1] == f"top.ux [{table.units['top.ux']}]" == "top.ux [m]"
    assert table["top.ux"][5] == float(text[6].split(",")[1])
    top = result.monitors["top"]
    assert (top.ux == table["top.ux"]).all() and (top["time"] == table["time"]).all()
    assert list(result.monitors) == ["top"] and "kinetic" in result.energy
    with pytest.raises(KeyError, match="top"):
        result.monitors["bottom"]
    with pytest.raises(tr.Error, match="monitors"):
        result.table("bolts")


def test_tables_are_data_frames_and_streams_where_these_are_there(result):
    pandas = pytest.importorskip("pandas")
    frame = result.monitors["top"].to_pandas()
    assert isinstance(frame, pandas.DataFrame) and frame.index.name == "time" and frame.attrs["units"]["ux"] == "m"
    pytest.importorskip("obspy")
    back = result.monitors["top"].to_stream("ax")
    assert (back[0].data == result.monitors["top"].ax).all() and back[0].stats.delta == pytest.approx(0.01)


def test_summary_verdict_and_trust_are_objects(result):
    assert result.status == "done" and result.verdict.startswith("The run reached its end")
    # A column of rock has no lining.
    assert result.state.class_ == result.summary.state["class"] == "not_judged"
    assert result.state.reasons[0].item == "no_lining" and result.state.reasons[0].text.startswith("The run has no lining")
    assert result.reliance.class_ in ("sound", "with_reservations", "not_to_be_used")
    assert "State: not judged. Reliance: " in result.verdict
    assert result.summary.model.elements == result.summary["model"]["elements"] == 10
    assert result.checks["free_field_theory"].pass_ is True
    assert all(not line.pass_ for line in result.checks.failed)
    assert "limit" in repr(result.checks) and result.title in result._repr_html_()
    with pytest.raises(AttributeError, match="title"):
        result.summary.titel  # noqa: B018


def test_fields_are_grids(result):
    assert len(result.fields) == 11 and result.fields.at(0.52).time == pytest.approx(0.5)
    grid = result.fields[-1].read()
    assert grid.points.shape == (44, 3) and grid.point_data["displacement"].shape == (44, 3)
    assert grid.cell_data["stress"].shape == (10, 6) and grid.units["stress"] == "Pa" and grid.in_group("rock").all()
    with pytest.raises(KeyError, match="rock"):
        grid.in_group("lining")


def test_fields_are_meshios_with_every_cell_in_its_order(result):
    pytest.importorskip("meshio")
    grid = result.fields[-1].read()
    mesh = grid.to_meshio()
    assert (mesh.cells[0].data == grid.cells.reshape(-1, 8)).all() and (mesh.cell_data["stress"][0] == grid.cell_data["stress"]).all()


def test_fields_are_pyvistas(result):
    pytest.importorskip("pyvista")
    made = result.fields[-1].to_pyvista()
    assert made.n_cells == 10 and made.compute_cell_sizes()["Volume"].sum() == pytest.approx(80.0)


def test_a_run_that_goes_on_can_be_read(job, tmp_path):
    simulation = job.start(tmp_path / "a")
    simulation.step(200)
    result = tr.Result(tmp_path / "a")
    assert result.status == "running" and len(result.monitors["top"].time) > 10
    with pytest.raises(tr.Error, match="no summary yet"):
        result.summary  # noqa: B018
    assert simulation.finish().status == "stopped"


def test_pages_and_comparisons(result, tmp_path):
    assert "<html" in result.page().read_text(encoding="utf-8")[:200]
    assert 'lang="zh' in result.page("zh").read_text(encoding="utf-8")[:300]
    page = tr.compare([result, result.path], tmp_path / "compare.html")
    assert page.stat().st_size > 1000
    with pytest.raises(tr.Error, match="two results"):
        tr.compare([result], page)
    with pytest.raises(tr.Error, match="no such folder"):
        tr.Result(tmp_path / "nothing")
    with pytest.raises(tr.Error, match="language"):
        result.page("xx")


def test_records_are_copied_and_sent_to_other_processes(result):
    assert copy.copy(result.summary).verdict == pickle.loads(pickle.dumps(result.summary)).verdict == result.verdict


def test_names_that_look_like_numbers_stay_names(tmp_path, result):
    import shutil

    folder = tmp_path / "a"
    shutil.copytree(result.path, folder)
    (folder / "bolts.csv").write_text("bolt,name,x [m],stage,lives\n1,nan,1e-3,1_0,3\n2,infinity,NaN,7,\n3,12,inf,6,4\n4,1")
    rows = tr.Result(folder).rows("bolts")
    assert [row["name"] for row in rows] == ["nan", "infinity", "12"] and [row["stage"] for row in rows] == ["1_0", "7", "6"]
    assert rows[0]["x"] == 1e-3 and math.isnan(rows[1]["x"]) and rows[2]["x"] == math.inf and math.isnan(rows[1]["lives"])
    assert tr.Result(folder).units_of("bolts")["x"] == "m"
