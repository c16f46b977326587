"""A stranger's way: from a mesh of meshio and a record of ObsPy to a lined, shaken tunnel that a callback stops, and its histories."""

from pathlib import Path

import numpy as np
import pytest

import tremolite as tr


def tunnel(meshio):
    """A block of 28 m by 2 m by 28 m with a square tunnel: an opening of 4 m in a lining 1 m thick, as Gmsh would name it."""
    lines = np.array([-14.0, -9.0, -5.0, -3.0, -2.0, 0.0, 2.0, 3.0, 5.0, 9.0, 14.0])
    n = len(lines)
    points = np.array([[x, y, z - 14.0] for z in lines for y in (0.0, 1.0, 2.0) for x in lines])
    node = lambda i, j, k: (k * 3 + j) * n + i  # noqa: E731
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    cells, tags = [], []
    for k in range(n - 1):
        for j in range(2):
            for i in range(n - 1):
                cells.append([node(i + a, j + b, k + c) for a, b, c in corners])
                far = max(abs(lines[i] + lines[i + 1]), abs(lines[k] + lines[k + 1])) / 2
                tags.append(1 if far < 2 else 2 if far < 3 else 3)
    return meshio.Mesh(
        points,
        [("hexahedron", np.array(cells))],
        cell_data={"gmsh:physical": [np.array(tags)]},
        field_data={"opening": np.array([1, 3]), "lining": np.array([2, 3]), "rock": np.array([3, 3])},
    )


PAGE = Path(__file__).resolve().parents[3] / "docs" / "python.md"


@pytest.mark.skipif(not PAGE.exists(), reason="the documentation is not beside the tests")
def test_the_way_of_the_documentation_leads_to_a_lined_and_shaken_tunnel(tmp_path, monkeypatch, capsys):
    meshio, obspy, plots = (pytest.importorskip(name) for name in ("meshio", "obspy", "matplotlib"))
    plots.use("Agg")
    monkeypatch.chdir(tmp_path)
    meshio.write("tunnel.msh", tunnel(meshio), file_format="gmsh22", binary=False)
    t = 0.01 * np.arange(300)
    stream = obspy.Stream()
    for channel, share in (("HNE", 1.0), ("HNN", 0.5), ("HNZ", 0.3)):
        trace = obspy.Trace(2.0 * share * np.exp(-((4 * (t - 1.0)) ** 2)) * np.sin(2 * np.pi * 3 * t))
        trace.stats.update({"network": "XX", "station": "ABC", "channel": channel, "delta": 0.01})
        stream += trace
    stream.write("record.mseed", format="MSEED", encoding="FLOAT64")
    chapter = PAGE.read_text(encoding="utf-8").split("## From a mesh and a record to a tunnel")[1]
    code = chapter.split("```python\n")[1].split("```")[0]
    there: dict = {}
    exec(compile(code, str(PAGE), "exec"), there)  # noqa: S102
    result, mesh = there["result"], there["mesh"]
    assert sorted(mesh.groups) == ["lining", "opening", "rock"] and "<Mesh of 200 elements" in capsys.readouterr().out
    assert result.status == "stopped" and "resume=True" in result.verdict
    assert result.monitors["crown"].time[-1] == pytest.approx(1.0, abs=0.05)
    assert [row["name"] for row in result.rows("stages")] == ["initial equilibrium", "excavation", "lining"]
    assert np.abs(result.monitors["crown"].ux).max() > 1e-4
    assert (tmp_path / "crown.png").stat().st_size > 5000 and (tmp_path / "results/tunnel/report.html").exists()


@pytest.mark.skipif(not PAGE.exists(), reason="the documentation is not beside the tests")
def test_the_callback_of_the_documentation_goes_on_while_the_lining_stands(cavern, tmp_path, monkeypatch):
    # Before its stage there is no lining: of its damage a share is no number, and that stopped the run.
    monkeypatch.chdir(tmp_path)
    concrete = {"law": "concrete-damage", "tensile_strength": "1.2 MPa", "fracture_energy": "130 N/m", "cohesion": "2 MPa"}
    changes = {f"material.concrete.{key}": value for key, value in {**concrete, "friction_angle": "46 deg"}.items()}
    job = tr.Job(tr.Case(cavern).with_({**changes, "dynamic.duration": "0.1 s"}))
    code = PAGE.read_text(encoding="utf-8").split("```python\ndef watch(now):  ")[1].split("```")[0]
    there = {"job": job, "np": np}
    exec(compile("def watch(now):  " + code, str(PAGE), "exec"), there)  # noqa: S102
    assert there["result"].status == "done"
