"""A stranger's way: from a mesh of meshio and a record of ObsPy to a lined, shaken tunnel that a callback stops, and its histories."""

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


def test_from_meshio_and_obspy_to_a_lined_and_shaken_tunnel(tmp_path):
    meshio, obspy = pytest.importorskip("meshio"), pytest.importorskip("obspy")
    mesh = tr.Mesh.from_meshio(tunnel(meshio))
    t = 0.01 * np.arange(300)
    stream = obspy.Stream()
    for channel, share in (("HNE", 1.0), ("HNN", 0.5), ("HNZ", 0.3)):
        trace = obspy.Trace(2.0 * share * np.exp(-((4 * (t - 1.0)) ** 2)) * np.sin(2 * np.pi * 3 * t))
        trace.stats.update({"network": "XX", "station": "ABC", "channel": channel, "delta": 0.01})
        stream += trace
    motion = tr.Motion.from_stream(stream.taper(0.05), units="m/s2").process("detrend linear", "bandpass 0.5 Hz 15 Hz", "baseline")
    case = tr.Case.from_dict(
        {
            "title": "a tunnel",
            "mesh": {"file": {"path": "tunnel"}},
            "material": {
                "rock": {"law": "elastic", "young": "5 GPa", "poisson": 0.25, "density": "2500 kg/m3"},
                "concrete": {
                    "law": "concrete-damage",
                    "young": "25 GPa",
                    "poisson": 0.17,
                    "density": "2450 kg/m3",
                    "tensile_strength": "1.2 MPa",
                    "fracture_energy": "130 N/m",
                    "cohesion": "2 MPa",
                    "friction_angle": "46 deg",
                },
            },
            "region": [
                {"groups": ["rock", "opening"], "material": "rock", "element": "one-point"},
                {"groups": ["lining"], "material": "concrete", "before": "rock", "element": "full"},
            ],
            "initial": {"lateral": 0.8},
            "stage": [
                {"name": "excavation", "excavate": ["opening"], "release": 0.7},
                {"name": "lining", "install": ["lining"]},
            ],
            "motion": {"kind": "outcrop", "file": "record"},
            "dynamic": {
                "base": "viscous-spring",
                "sides": {"x": "free-field", "y": "periodic"},
                "damping": {"rayleigh": {"mass": "0.3 1/s"}},
            },
            "monitor": [{"name": "crown", "at": ["0 m", "1 m", "-11.5 m"], "body": "lining"}],
        }
    )
    job = tr.Job(case, mesh=mesh, motion=motion)
    crown = job.mesh.nodes_near((0.0, 1.0, -12.0), 1.1)
    seen = []

    def watch(now):
        damage = now.history("lining", "d_tension")
        seen.append((now.stage, len(damage), np.abs(now.displacement[crown]).max()))
        return now.stage is not None or now.time < 1.0

    result = job.run(tmp_path / "a", callback=watch, every="0.05 s")
    assert result.status == "stopped" and result.monitors["crown"].time[-1] == pytest.approx(1.0, abs=0.05)
    assert [stage for stage, *_ in seen[:3]] == ["initial equilibrium", "excavation", "lining"]
    assert [points for _, points, _ in seen[:4]] == [0, 0, 8 * 24, 8 * 24] and seen[-1][2] > 1e-4
    assert np.abs(result.monitors["crown"].ux).max() > 1e-4
