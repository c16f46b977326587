"""Motions that fit a spectrum."""

import json
import subprocess

import numpy as np
import pytest

import tremolite as tr

CODE = "EN 1998-1 type 1 ground B 2 m/s2"
BAND = (0.2, 2.0)


@pytest.fixture(scope="module")
def made():
    return tr.artificial(CODE, 12.0, count=2, seed=3, band=BAND, dt=0.02)


def test_a_target_is_that_of_the_code_or_of_a_table():
    code = tr.Target(CODE)
    # S = 1.2, T_B = 0.15 s, T_C = 0.5 s, T_D = 2 s.
    assert np.allclose(code.at([0.15, 0.5, 1.0, 4.0]), np.array([2.5, 2.5, 1.25, 0.15625]) * 2.4) and code.damping == 0.05
    table = tr.Target.of_table([0.1, 0.4, 1.6], [5.0, 5.0, 1.25])
    assert np.allclose(table.at([0.2, 0.8]), [5.0, 2.5]) and table.range == pytest.approx((0.1, 1.6))
    for given, words in [("EN 1998-1 type 3 ground A 2 m/s2", "there is no type 3"), ("code.csv", "neither a file nor a spectrum")]:
        with pytest.raises(tr.Error, match=words):
            tr.Target(given)
    with pytest.raises(tr.Error, match="give one a period"):
        tr.Target.of_table([0.1, 0.4], [1.0])


def test_artificial_motions_fit_differ_and_are_those_of_the_command(made, command, tmp_path):
    for channel in made:
        found = channel.misfit(CODE, band=BAND)
        assert found["largest"] <= 0.05 and found["factor"] == pytest.approx(1.0, abs=0.05)
        # By the spectrum itself, at periods that nothing was matched at.
        periods = np.geomspace(*BAND, 37)
        assert np.abs(channel.spectrum(periods) / tr.Target(CODE).at(periods) - 1.0).max() < 0.06
    a, b = (channel.acceleration for channel in made)
    assert abs(np.corrcoef(a, b)[0, 1]) < 0.31
    out = subprocess.run(
        [*command, "motion", "artificial", "--target", CODE, "--band", "0.2 s", "2 s", "--duration", "12 s", "--dt", "0.02 s"]
        + ["--seed", "4", "--out", str(tmp_path), "--no-plot", "--json"],
        check=True,
        capture_output=True,
        text=True,
    )
    told = json.loads(out.stdout)["motions"][0]
    assert told["after"]["pga"] == pytest.approx(made[1].intensity["pga"], rel=1e-12)


def test_matching_fits_the_horizontals_and_leaves_the_vertical(made):
    motion = tr.Motion(
        [
            tr.Channel("a", made[0].dt, 0.3 * made[0].acceleration, azimuth=0.0),
            tr.Channel("b", made[0].dt, 0.5 * made[1].acceleration, azimuth=90.0),
            tr.Channel("c", made[0].dt, 0.2 * made[0].acceleration, up=True),
        ]
    )
    other = tr.Target("EN 1998-1 type 1 ground C 3 m/s2")
    matched = motion.match(other, band=BAND)
    assert [c.misfit(other, band=BAND)["largest"] <= 0.05 for c in matched][:2] == [True, True]
    assert [(c.name, c.azimuth, c.up) for c in matched] == [(c.name, c.azimuth, c.up) for c in motion]
    assert (matched[2].acceleration == motion[2].acceleration).all()
    # One factor for all components: the geometric mean of what each would need.
    factor = motion.factor_to(CODE, band=BAND)
    assert factor == pytest.approx(1.0 / np.sqrt(0.15), rel=0.03)
    assert motion.scaled(factor).factor_to(CODE, band=BAND) == pytest.approx(1.0, rel=1e-12)
    with pytest.raises(tr.Error, match="no horizontal"):
        tr.Motion([motion[2]]).factor_to(CODE)
    with pytest.raises(tr.Error, match="comes no nearer"):
        motion[0].match(tr.Target.of_table([0.2, 0.21, 2.0], [50.0, 0.05, 40.0]), band=BAND, tolerance=0.01)


def test_the_nearest_is_chosen_and_its_factor_undoes_a_scale(made):
    far = tr.artificial("EN 1998-1 type 2 ground A 2 m/s2", 12.0, seed=5, band=BAND, dt=0.02)[0]
    near = tr.Motion([made[0]]).scaled(0.5)
    up = tr.Channel("up", near[0].dt, near[0].acceleration, up=True)
    chosen = tr.select([tr.Motion([far, up]), near], CODE, band=BAND)
    assert [(c.motion, c.channel) for c in chosen] == [(1, 0), (0, 0)]
    assert chosen[0].factor == pytest.approx(2.0, rel=0.05) and chosen[0].misfit < 0.05 < 0.2 < chosen[1].misfit
    assert [c.motion for c in tr.select([tr.Motion([far]), near], CODE, band=BAND, factors=(1.9, 2.1))] == [1]
    with pytest.raises(tr.Error, match="no horizontal"):
        tr.select([tr.Motion([up])], CODE)
