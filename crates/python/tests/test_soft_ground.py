"""Soft ground: the columns of pyStrata, and what goes into a case."""

import json
from pathlib import Path

import numpy as np
import pytest

import tremolite as tr

STORED = Path(__file__).parents[2] / "tremolite/src/equivalent_linear/stored.json"
ROCK = {"density": 2300.0, "shear_wave_velocity": 1000.0}


def of_stored(number):
    stored = json.loads(STORED.read_text())["profiles"][number]
    dt, count, peak = (stored["motion"][key] for key in ("dt", "count", "peak"))
    t = dt * np.arange(count)
    group = lambda at, width, hertz: np.exp(-(((t - at) / width) ** 2)) * np.sin(2 * np.pi * hertz * (t - at))  # noqa: E731
    channel = tr.Channel("a", dt, peak * (group(9.0, 1.5, 1.7) + 0.6 * group(12.0, 2.0, 4.3)), azimuth=90.0)
    layers = []
    for layer in stored["layers"]:
        made = {"thickness": layer["thickness"], "density": layer["density"], "shear_wave_velocity": layer["speed"]}
        if layer["curves"] == "vucetic-dobry":
            made["vucetic_dobry"] = layer["plasticity_index"]
        elif layer["curves"] == "darendeli":
            made["darendeli"] = {key: layer[key] for key in ("plasticity_index", "ocr", "stress", "frequency", "cycles")}
        elif layer["curves"] == "table":
            made["table"] = [tuple(row) for row in layer["table"]]
        else:
            made["damping"] = layer["damping"]
        layers.append(made)
    rock = {"density": stored["rock"]["density"], "shear_wave_velocity": stored["rock"]["speed"]}
    return stored, layers, rock, channel


@pytest.mark.parametrize("number", [1, 2])
def test_layers_have_the_moduli_of_their_strain(number):
    stored, layers, rock, channel = of_stored(number)
    found = tr.soft_ground(layers, rock, channel, at=stored["given"])
    # The search ends where nothing changes by a ten-thousandth.
    for key in ("strain", "modulus", "damping"):
        assert [one[key] for one in found] == pytest.approx(stored[key], rel=2e-3)
    assert found[0]["shear_wave_velocity"] == pytest.approx(layers[0]["shear_wave_velocity"] * found[0]["modulus"] ** 0.5)
    # They are what a case's site wants.
    keys = ("thickness", "density", "shear_wave_velocity", "damping")
    units = {"thickness": "m", "density": "kg/m3", "shear_wave_velocity": "m/s"}
    site = [{**{k: f"{one[k]} {units[k]}" if k in units else one[k] for k in keys}, "poisson": 0.3} for one in found]
    from conftest import COLUMN

    motion = {"kind": "surface", "file": "pulse", "site": {"layers": site}}
    assert tr.Case.from_dict({**COLUMN, "motion": motion}).to_dict()["motion"]["site"]["layers"][0]["poisson"] == 0.3


def test_what_is_no_soft_ground_is_refused_in_words():
    _, layers, rock, channel = of_stored(1)
    strong = tr.Motion([channel]).scaled(50.0)[0]
    with pytest.raises(tr.Error, match="shears by"):
        tr.soft_ground(layers, rock, strong, at="outcrop")
    good = {"thickness": 2.0, "density": 1900.0, "shear_wave_velocity": 200.0}
    for layer, words in [
        (good, "one of darendeli"),
        ({**good, "damping": 0.02, "vucetic_dobry": 15}, "one of darendeli"),
        ({**good, "damping": 0.6}, "ratio"),
        ({**good, "vucetic_dobry": 300}, "0 to 200"),
        ({**good, "darendeli": {"plasticity_index": 15}}, "stress"),
        ({**good, "darendeli": {"plasticity_index": 15, "stress": 1e5, "PI": 1}}, "has no"),
        ({**good, "table": [(1e-4, 0.9, 0.02), (1e-5, 0.8, 0.03)]}, "row 2"),
        ({**good, "thickness": 0.0, "damping": 0.02}, "thickness of layer 1"),
    ]:
        with pytest.raises(tr.Error, match=words):
            tr.soft_ground([layer], rock, channel)
    with pytest.raises(tr.Error, match="outcrop"):
        tr.soft_ground([{**good, "damping": 0.02}], rock, channel, at="within")
    with pytest.raises(tr.Error, match="the rock has"):
        tr.soft_ground([{**good, "damping": 0.02}], {"density": 1.0}, channel)
