"""Writes stored.json: what pyStrata finds for three columns of soft ground, and its curves. pip install pystrata pandas"""

import json
from pathlib import Path

import numpy as np
import pystrata
from pystrata import site
from pystrata.site import DarendeliSoilType, Layer, NonlinearProperty, Profile, SoilType

site.COMP_MODULUS_MODEL = "seed"
GRAVITY = pystrata.motion.GRAVITY
# So fine that what is between two points of a curve is no matter.
STRAINS = np.logspace(-8, -2, 60001)
OSCILLATORS = np.geomspace(0.2, 20.0, 40)


def darendeli(pi, ocr, stress, freq=1.0, cycles=10.0, strains=STRAINS):
    return DarendeliSoilType(0.0, pi, ocr, stress / 1000.0, freq, cycles, strains=strains)


def soil_type(layer):
    weight = layer["density"] * GRAVITY / 1000.0
    if layer["curves"] == "linear":
        return SoilType("linear", weight, None, layer["damping"])
    if layer["curves"] == "vucetic-dobry":
        name = f"Vucetic & Dobry (91), PI={layer['plasticity_index']}"
        curves = [NonlinearProperty.from_published(name, which) for which in ("mod_reduc", "damping")]
    elif layer["curves"] == "table":
        strains, modulus, damping = np.transpose(layer["table"])
        curves = [NonlinearProperty("t", strains, modulus, "mod_reduc"), NonlinearProperty("t", strains, damping, "damping")]
    else:
        made = darendeli(layer["plasticity_index"], layer["ocr"], layer["stress"], layer["frequency"], layer["cycles"])
        curves = [made.mod_reduc, made.damping]
    return SoilType(layer["curves"], weight, *curves)


def accelerations(dt, count, peak):
    t = dt * np.arange(count)
    group = lambda at, width, hertz: np.exp(-(((t - at) / width) ** 2)) * np.sin(2 * np.pi * hertz * (t - at))
    return peak * (group(9.0, 1.5, 1.7) + 0.6 * group(12.0, 2.0, 4.3))


def run(name, layers, rock, motion, given):
    series = pystrata.motion.TimeSeriesMotion("", "", motion["dt"], accelerations(**motion) / GRAVITY)
    base = Layer(SoilType("rock", rock["density"] * GRAVITY / 1000.0, None, 0.0), 0, rock["speed"])
    profile = Profile([Layer(soil_type(one), one["thickness"], one["speed"]) for one in layers] + [base])
    profile.update_layers()
    calculator = pystrata.propagation.EquivalentLinearCalculator(strain_ratio=0.65, tolerance=1e-11, max_iterations=500)
    rock_top, surface = profile.location("outcrop", index=-1), profile.location("outcrop", index=0)
    source, seen = (surface, rock_top) if given == "surface" else (rock_top, surface)
    calculator(series, profile, source)
    spectrum = series.calc_osc_accels(OSCILLATORS, 0.05, calculator.calc_accel_tf(source, seen)) * GRAVITY
    soft = profile[:-1]
    return {
        "name": name,
        "layers": layers,
        "rock": rock,
        "motion": motion,
        "given": given,
        "strain": [float(one.strain_max) for one in soft],
        "modulus": [float(one.shear_mod / one.initial_shear_mod) for one in soft],
        "damping": [float(one.damping) for one in soft],
        "spectrum": spectrum.tolist(),
    }


def soil(thickness, speed, density=1900.0, **curves):
    return {"thickness": thickness, "speed": speed, "density": density, **curves}


def by_darendeli(pi, ocr, stress, frequency=1.0, cycles=10.0):
    return {"curves": "darendeli", "plasticity_index": pi, "ocr": ocr, "stress": stress, "frequency": frequency, "cycles": cycles}


MOTION = {"dt": 0.02, "count": 4000, "peak": 1.0}
PROFILES = [
    run(
        "30 m of sand and clay by Darendeli",
        [soil(3.0, 160.0 + 12.0 * k, **by_darendeli(0 if k < 5 else 30, 1.0, 30e3 + 25e3 * k)) for k in range(10)],
        {"speed": 1000.0, "density": 2300.0},
        MOTION,
        "outcrop",
    ),
    run(
        "clays by Vucetic and Dobry",
        [soil(2.0, 130.0 + 15.0 * k, 1800.0, curves="vucetic-dobry", plasticity_index=pi) for k, pi in enumerate([15, 15, 30, 30, 50, 50, 100, 0])],
        {"speed": 760.0, "density": 2200.0},
        {**MOTION, "peak": 0.8},
        "outcrop",
    ),
    run(
        "a record at the surface, on a table, Darendeli and a linear layer",
        [
            soil(2.0, 200.0, curves="table", table=[[1e-6, 1.0, 0.008], [1e-5, 0.97, 0.012], [1e-4, 0.75, 0.04], [1e-3, 0.3, 0.13], [1e-2, 0.06, 0.22]]),
            soil(3.0, 240.0, curves="table", table=[[1e-6, 1.0, 0.008], [1e-5, 0.97, 0.012], [1e-4, 0.75, 0.04], [1e-3, 0.3, 0.13], [1e-2, 0.06, 0.22]]),
            *[soil(3.0, 260.0 + 10.0 * k, **by_darendeli(20, 2.0, 100e3 + 30e3 * k, 2.0, 15.0)) for k in range(4)],
            soil(8.0, 450.0, 2100.0, curves="linear", damping=0.02),
        ],
        {"speed": 1500.0, "density": 2500.0},
        {**MOTION, "peak": 1.5},
        "surface",
    ),
]

CURVES = []
for given in ((0, 1.0, 50e3, 1.0, 10.0), (40, 4.0, 400e3, 2.0, 20.0)):
    made = darendeli(*given, strains=np.logspace(-4.5, np.log10(5e-3), 15))
    points = np.transpose([made.mod_reduc.strains, made.mod_reduc.values, made.damping.values])
    CURVES.append({**by_darendeli(*given), "points": points.tolist()})
for pi in (0, 15, 200):
    name = f"Vucetic & Dobry (91), PI={pi}"
    g, d = (NonlinearProperty.from_published(name, which) for which in ("mod_reduc", "damping"))
    at = np.logspace(-6.5, -1.5, 12)
    CURVES.append({"curves": "vucetic-dobry", "plasticity_index": pi, "points": np.transpose([at, g(at), d(at)]).tolist()})

made = {"program": f"pyStrata {pystrata.__version__}", "oscillators": OSCILLATORS.tolist(), "profiles": PROFILES, "curves": CURVES}
Path(__file__).with_name("stored.json").write_text(json.dumps(made, indent=1) + "\n")
for one in PROFILES:
    print(one["name"], max(one["strain"]), min(one["modulus"]), max(one["damping"]))
