"""Meshes and records in memory."""

import numpy as np
import pytest

import tremolite as tr
from conftest import COLUMN, pulse, same_files


def box(nz=10):
    """The mesh of the column: bricks 1 m high of 1 m by 2 m."""
    points = np.array([[x, y, z] for z in np.linspace(-20.0, 0.0, nz + 1) for y in (0.0, 2.0) for x in (0.0, 2.0)])
    layer = np.array([0, 1, 3, 2, 4, 5, 7, 6])
    return tr.Mesh(points, {"hex8": np.array([layer + 4 * k for k in range(nz)])}, {"rock": np.arange(nz)})


def in_memory(column):
    column["mesh"] = {"file": {"path": "memory"}}
    return tr.Case.from_dict(column)


def test_a_mesh_in_memory_runs_as_the_same_mesh_from_a_file(column, tmp_path):
    case = in_memory(column)
    box().write(tmp_path / "box.vtu")
    memory = tr.Job(case, mesh=box(), motion=pulse()).run(tmp_path / "memory")
    file = case.with_({"mesh.file.path": str(tmp_path / "box.vtu")})
    file = tr.Job(file, motion=pulse()).run(tmp_path / "file")
    assert same_files(memory.path, file.path) == []
    read = tr.Mesh.read(tmp_path / "box.vtu")
    assert (read.points == box().points).all() and (read.groups["rock"] == np.arange(10)).all()


def test_measures_of_a_mesh():
    mesh = box()
    assert len(mesh) == 10 and np.allclose(mesh.volumes, 8.0) and np.allclose(mesh.quality, 1.0)
    assert np.allclose(mesh.centroids[0], [1.0, 1.0, -19.0])
    assert list(mesh.nodes_near((0, 0, 0), 0.1)) == [40] and len(mesh.nodes_of("rock")) == 44


def test_bad_meshes_are_refused_in_words(column):
    case = in_memory(column)
    good = box()
    for points, cells, groups, words in [
        (good.points[:, :2], good.cells, {}, "shape"),
        (good.points, {"hex20": good.cells[0][1]}, {}, "hex8"),
        (good.points, {"hex8": good.cells[0][1] + 1}, {"rock": np.arange(10)}, "44"),
        (good.points, {"hex8": good.cells[0][1] - 5}, {"rock": np.arange(10)}, "count from 0"),
        (good.points, {"hex8": good.cells[0][1]}, {"rock": np.arange(11)}, "no element 10"),
        (good.points, {"hex8": good.cells[0][1].astype(float)}, {}, "whole numbers"),
        (good.points * np.nan, {"hex8": good.cells[0][1]}, {"rock": np.arange(10)}, "finite"),
        (good.points * [1, 1, 0], {"hex8": good.cells[0][1]}, {"rock": np.arange(10)}, "."),
    ]:
        with pytest.raises((tr.Error, tr.CaseError), match=words):
            tr.Job(case, mesh=tr.Mesh(points, cells, groups), motion=pulse())
    with pytest.raises(tr.Error, match="makes its own mesh"):
        tr.Job(tr.Case.from_dict(COLUMN), mesh=good)


def test_a_meshio_mesh_keeps_all_blocks_and_its_physical_names():
    meshio = pytest.importorskip("meshio")
    points = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1], [0.5, 0.5, 2]], float)
    mesh = meshio.Mesh(
        points,
        [("quad", [[4, 5, 6, 7]]), ("hexahedron", [[0, 1, 2, 3, 4, 5, 6, 7]]), ("pyramid", [[4, 5, 6, 7, 8]])],
        cell_data={"gmsh:physical": [np.array([3]), np.array([1]), np.array([2])]},
        field_data={"rock": np.array([1, 3]), "cap": np.array([2, 3]), "top": np.array([3, 2])},
    )
    made = tr.Mesh.from_meshio(mesh)
    assert [kind for kind, _ in made.cells] == ["hex8", "pyramid5"]
    assert made.groups["rock"].tolist() == [0] and made.groups["cap"].tolist() == [1]
    assert made.faces["top"].tolist() == [[0, 5]]
    back = tr.Mesh.from_meshio(made.to_meshio())
    assert (back.points == made.points).all() and back.groups["cap"].tolist() == [1]
    with pytest.raises(tr.Error, match="only quad"):
        tr.Mesh.from_meshio(meshio.Mesh(points, [("quad", [[4, 5, 6, 7]])]))


def stream(rate=100.0, channels=("HNE", "HNN", "HNZ"), **stats):
    obspy = pytest.importorskip("obspy")
    rng = np.random.default_rng(3)
    traces = []
    for channel in channels:
        trace = obspy.Trace(rng.normal(size=400))
        trace.stats.update({"network": "XX", "station": "ABC", "channel": channel, "sampling_rate": rate, **stats})
        trace.stats.starttime = obspy.UTCDateTime("2004-01-24T19:51:07.3421")
        traces.append(trace)
    return obspy.Stream(traces)


def test_a_stream_goes_there_and_back_to_the_last_digit():
    there = stream()
    motion = tr.Motion.from_stream(there, units="m/s2")
    assert [(c.azimuth, c.up) for c in motion] == [(90.0, False), (0.0, False), (None, True)]
    back = motion.to_stream()
    for a, b in zip(there, back, strict=True):
        assert a.id == b.id and a.stats.delta == b.stats.delta and a.stats.starttime == b.stats.starttime
        assert (a.data == b.data).all()


def test_a_stream_runs_as_its_record_does(column, tmp_path):
    there = stream()
    motion = tr.Motion.from_stream(there, units="cm/s2")
    assert (motion[0].acceleration == 0.01 * there[0].data).all()
    geographic = motion.geographic()
    # East is a direction of sine 1 and cosine 6e-17.
    assert np.allclose(geographic["east"], motion["XX.ABC..HNE"].acceleration, atol=1e-15) and geographic["dt"] == 0.01
    turned = tr.Motion(
        [
            tr.Channel("a", 0.01, motion[0].acceleration, azimuth=120.0),
            tr.Channel("b", 0.01, motion[1].acceleration, azimuth=30.0),
        ]
    ).geographic()
    angle = np.radians(30.0)
    assert np.allclose(turned["east"], np.cos(angle) * motion[0].acceleration + np.sin(angle) * motion[1].acceleration)
    result = tr.Job(tr.Case.from_dict(column), motion=motion).run(tmp_path / "a", set={"dynamic.duration": "0.3 s"})
    assert result.status == "done" and np.abs(result.monitors["top"].uz).max() > 0


def test_headers_that_round_one_rate_differently_are_one_record():
    # As SAC does, with 32 bits. "Sampled at 0.01 s, 0.01 s" was refused.
    there = stream()
    there[1].stats.delta = float(np.float32(0.01))
    motion = tr.Motion.from_stream(there, units="m/s2")
    assert motion.geographic()["dt"] == 0.01 and [a.stats.delta for a in motion.to_stream()] == [a.stats.delta for a in there]
    there[1].stats.delta = 0.01 * (1.0 + 1e-5)
    with pytest.raises(tr.Error, match="0.01 s, 0.0100001 s"):
        tr.Motion.from_stream(there, units="m/s2")


def test_streams_that_are_no_record_are_refused_with_the_way_out():
    obspy = pytest.importorskip("obspy")
    good = stream()
    gap = obspy.Stream([good[0].slice(endtime=good[0].stats.starttime + 1), good[0].slice(starttime=good[0].stats.starttime + 2)])
    masked = gap.copy().merge()
    mixed = stream()[:1] + stream(rate=50.0)[1:2]
    wrong = stream()
    wrong[0].data[7] = np.nan
    for bad, units, words in [
        (obspy.Stream(), "m/s2", "empty"),
        (gap, "m/s2", "a gap of .* s"),
        (masked, "m/s2", "gaps"),
        (mixed, "m/s2", "0.01 s, 0.02 s"),
        (good, None, "units="),
        (good, "km/s2", "no unit"),
        (stream(channels=("HN1",)), "m/s2", "inventory="),
        (wrong, "m/s2", "not finite"),
    ]:
        with pytest.raises(tr.Error, match=words):
            tr.Motion.from_stream(bad, units=units)


def test_a_record_of_a_file_is_that_of_obspy(tmp_path):
    obspy = pytest.importorskip("obspy")
    there = stream()
    there.write(str(tmp_path / "a.mseed"), format="MSEED", encoding="FLOAT64")
    read = tr.Motion.read(tmp_path / "a.mseed", units="m/s2")
    again = tr.Motion.from_stream(obspy.read(str(tmp_path / "a.mseed")), units="m/s2")
    for a, b in zip(read, again, strict=True):
        assert (a.acceleration == b.acceleration).all() and a.dt == b.dt and a.azimuth == b.azimuth


KNET = """Origin Time       2018/01/24 19:51:00
Lat.              41.0
Long.             142.5
Depth. (km)       30
Mag.              6.2
Station Code      AOM004
Station Lat.      41.4087
Station Long.     141.4486
Station Height(m) 30
Record Time       2018/01/24 19:51:37
Sampling Freq(Hz) 10Hz
Duration Time(s)  2
Dir.              E-W
Scale Factor      7845(gal)/8223790
Max. Acc. (gal)   2.0
Last Correction   2018/01/24 19:51:37
Memo.             \n"""


def test_a_file_of_k_net_is_the_same_record_by_obspy_and_by_the_programs_reader(tmp_path):
    obspy = pytest.importorskip("obspy")
    counts = [8000 + [0, 800, -400, 400][k % 4] for k in range(20)]
    lines = ["".join(f"{count:9d}" for count in counts[k : k + 8]) for k in range(0, 20, 8)]
    (tmp_path / "a.EW").write_text(KNET + "\n".join(lines) + "\n")
    own = tr.Motion.read(tmp_path / "a.EW")[0]
    there = tr.Motion.from_stream(obspy.read(str(tmp_path / "a.EW")))[0]
    # The factor is one product here and another there: the last digits may differ.
    assert np.allclose(own.acceleration, there.acceleration, rtol=1e-14, atol=0.0)
    assert own.azimuth == there.azimuth == 90.0 and own.dt == there.dt == 0.1
    assert there.origin.startswith("2018-01-24T10:51:22")


class Inventory:
    """Where one channel looks to."""

    def __init__(self, azimuth, dip):
        self.place = {"azimuth": azimuth, "dip": dip}

    def get_orientation(self, name, time):
        return self.place


def test_directions_come_from_the_inventory_where_one_is_given():
    one = stream(channels=("HN1",))
    (channel,) = tr.Motion.from_stream(one, units="m/s2", inventory=Inventory(37.0, 0.0))
    assert channel.azimuth == 37.0 and (channel.acceleration == one[0].data).all()
    (down,) = tr.Motion.from_stream(one, units="m/s2", inventory=Inventory(0.0, 90.0))
    assert down.up and (down.acceleration == -one[0].data).all()
    with pytest.raises(tr.Error, match="dip 30"):
        tr.Motion.from_stream(one, units="m/s2", inventory=Inventory(0.0, 30.0))


def test_processing_and_spectra_are_the_programs_own():
    motion = pulse(200)
    channel = motion[0]
    assert channel.spectrum([0.0])[0] == np.abs(channel.acceleration).max() == channel.intensity["pga"]
    processed = motion.process("detrend linear", "taper 0.1 s")
    assert abs(processed[0].acceleration[0]) < 1e-12 and len(processed[0].acceleration) == 200
    assert (motion.scaled(2.0)[0].acceleration == 2.0 * channel.acceleration).all()
    with pytest.raises(tr.Error, match="bandpas"):
        motion.process("bandpas 1 Hz")
    with pytest.raises(tr.Error, match="damping"):
        channel.spectrum([1.0], damping=2.0)
    with pytest.raises(tr.Error, match="record"):
        tr.Job(tr.Case.from_dict(COLUMN), motion=[1.0, 2.0])


def test_solids_that_no_run_knows_and_masks_of_another_length_are_refused():
    meshio = pytest.importorskip("meshio")
    points = np.zeros((64, 3))
    blocks = [("hexahedron", np.arange(8)[None]), ("hexahedron64", np.arange(64)[None])]
    with pytest.raises(tr.Error, match="1 cells of the kind hexahedron64"):
        tr.Mesh.from_meshio(meshio.Mesh(points, blocks))
    with pytest.raises(tr.Error, match="a truth for each of 64"):
        tr.Mesh(points, {"hex8": np.arange(8)[None]}, groups={"rock": np.zeros(64, bool)})
