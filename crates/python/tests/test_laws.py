"""Laws at a point."""

import subprocess

import numpy as np
import pytest

import tremolite as tr

CONCRETE = dict(
    young="25 GPa", poisson=0.17, tensile_strength="1.2 MPa", fracture_energy="130 N/m", cohesion="2 MPa", friction_angle="46 deg"
)
SIDES = ["yy", "zz", "xy", "yz", "zx"]


def test_an_elastic_law_in_uniaxial_stress_and_in_uniaxial_strain():
    law = tr.law("elastic", young="10 GPa", poisson=0.25)
    path = law.drive({"xx": [0.0, 1e-4, 2e-4]}, free=SIDES)
    assert np.allclose(path.stress[:, 0], 1e10 * path.strain[:, 0]) and np.allclose(path.strain[:, 1], -0.25 * path.strain[:, 0])
    confined = law.drive({"xx": [0.0, 1e-4]})
    assert confined.stress[1, 0] == pytest.approx(1.2e6) and law.parameters["young"] == 1e10


def test_concrete_cracks_at_its_strength_and_takes_its_fracture_energy():
    law = tr.law("concrete-damage", size="0.5 m", **CONCRETE)
    path = law.drive({"xx": np.linspace(0.0, 4e-3, 4000)}, free=SIDES)
    stress, strain = path.stress[:, 0], path.strain[:, 0]
    # The steps are 25 kPa of elastic stress.
    assert stress.max() == pytest.approx(1.2e6, abs=3e4)
    work = np.sum(0.5 * (stress[1:] + stress[:-1]) * np.diff(strain))
    left = 0.5 * stress[-1] * strain[-1]
    # What is left of the tail is little: the curve is exponential.
    assert 0.5 * (work - left) == pytest.approx(130.0, rel=0.1)
    assert path.history["d_tension"][-1] > 0.9 and path.units["d_tension"] == "1"


def test_the_command_gives_the_same_numbers(command, tmp_path):
    law = tr.law("concrete-damage", size="0.5 m", **CONCRETE)
    strain = np.linspace(0.0, 1e-3, 50)
    (tmp_path / "law.toml").write_text(law.text)
    rows = ["time,exx,syy,szz,sxy,syz,szx"] + [f"0,{float(e)!r},0,0,0,0,0" for e in strain]
    (tmp_path / "path.csv").write_text("\n".join(rows) + "\n")
    subprocess.run([*command, "law", "law.toml", "--path", "path.csv", "--out", "out.csv"], cwd=tmp_path, check=True, capture_output=True)
    table = tr.Table.read(tmp_path / "out.csv")
    path = law.drive({"xx": strain}, free=SIDES)
    assert (table["sxx"] == path.stress[:, 0]).all() and (table["d_tension"] == path.history["d_tension"]).all()


def test_an_interface_slides_at_its_strength():
    law = tr.law("coulomb", interface=True, normal_stiffness="10 GPa/m", shear_stiffness="5 GPa/m", friction_coefficient=0.6)
    path = law.drive_interface(pressure=1e6, slip=np.linspace(0.0, 1e-3, 20))
    assert path.shear[-1, 0] == pytest.approx(0.6e6) and path.pressure == pytest.approx(1e6)


def test_a_law_is_calibrated_with_scipy():
    optimize = pytest.importorskip("scipy.optimize")
    strain = np.linspace(0.0, 5e-4, 60)
    measured = tr.law("concrete-damage", size="0.5 m", **{**CONCRETE, "tensile_strength": "1.5 MPa"}).drive({"xx": strain}, free=SIDES)

    def miss(strength):
        law = tr.law("concrete-damage", size="0.5 m", **{**CONCRETE, "tensile_strength": f"{float(strength)!r} MPa"})
        return float(np.sum((law.drive({"xx": strain}, free=SIDES).stress[:, 0] - measured.stress[:, 0]) ** 2))

    assert optimize.minimize_scalar(miss, bounds=(1.0, 2.0), method="bounded").x == pytest.approx(1.5, abs=0.02)


def test_what_cannot_be_driven_is_refused_in_words():
    with pytest.raises(tr.CaseError, match="did you mean `young`"):
        tr.law("elastic", yuong="1 GPa", poisson=0.2)
    with pytest.raises(tr.Error, match="size="):
        tr.law("concrete-damage", **CONCRETE).drive({"xx": [0.0, 1e-3]}, free=SIDES)
    law = tr.law("elastic", young="1 GPa", poisson=0.2)
    for given, words in [
        (dict(strain={"ab": [0.0]}), "no component"),
        (dict(strain=np.zeros((3, 5))), r"\(n, 6\)"),
        (dict(strain={"xx": [0.0, 1.0]}, stress={"yy": [0.0, 1.0, 2.0]}), "3 rows"),
        (dict(strain={"xx": [0.0]}, free=["xx"]), "keep one"),
        (dict(strain={"xx": [0.0, np.nan]}), "not finite"),
        (dict(strain={"xx": [0.0, 1e-4]}, time=[1.0, 0.0]), "time falls"),
    ]:
        with pytest.raises(tr.Error, match=words):
            law.drive(**given)
    with pytest.raises(tr.Error, match="material"):
        law.drive_interface(gap=[0.0])


def test_parameters_in_si_are_those_with_units():
    with_units = tr.law("elastic", young="25 GPa", poisson=0.2)
    assert tr.law("elastic", units="SI", young=25e9, poisson=0.2).parameters == with_units.parameters
    with pytest.raises(tr.CaseError, match="has no unit"):
        tr.law("elastic", young=25e9, poisson=0.2)
