"""Soft ground: moduli and damping that go with the strain of a record."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from ._motion import Channel
from ._tremolite import Error, equivalent_linear

_PLAIN = ("thickness", "density", "shear_wave_velocity")
_CURVES = ("darendeli", "vucetic_dobry", "table", "damping")


def soft_ground(
    layers: Sequence[Mapping[str, Any]], rock: Mapping[str, float], channel: Channel, *, at: str = "surface", share: float = 0.65
) -> list[dict[str, float]]:
    """The equivalent-linear column of soil layers, from the surface down, under one horizontal component of a record: a dict a layer.

    layers: each with `thickness` [m], `density` [kg/m³], `shear_wave_velocity` [m/s] at small strains, and its curves, one of
        `darendeli={"plasticity_index": 15, "stress": 80e3, "ocr": 1.0, "frequency": 1.0, "cycles": 10}` (Darendeli 2001; % and mean
        effective stress in Pa, the last three as here where left out), `vucetic_dobry=15` (Vucetic and Dobry 1991, a plasticity index),
        `table=[(shear strain, G/Gmax, damping ratio), ...]` (linear in the strain's logarithm), or `damping=0.02` for what stays linear.
        Strain is taken in the middle of each, so divide the ground into layers of a few metres.
    rock: `density` and `shear_wave_velocity` of the half-space below, undamped.
    channel: one of `Motion`; at="surface" says that it was recorded on these layers, at="outcrop" on bare rock.
    share: the effective strain over the largest.

    Returns `thickness`, `density`, `shear_wave_velocity` and `damping` as they go with the strain, the keys of `[[motion.site.layers]]`
    (which wants `poisson` too), and `strain` (the largest) and `modulus` (G/Gmax). Raises `Error` beyond a strain of 0.5 %, and where no
    moduli fit.
    """
    if at not in ("surface", "outcrop"):
        raise Error(f"at={at!r}: a record is of the \"surface\" of the layers or of an \"outcrop\" of rock")
    given = []
    for number, layer in enumerate(layers, 1):
        kinds = [key for key in layer if key in _CURVES]
        lacking = [key for key in _PLAIN if key not in layer]
        odd = [key for key in layer if key not in (*_PLAIN, *_CURVES)]
        if lacking or odd or len(kinds) != 1:
            raise Error(f"layer {number} has {', '.join(layer) or 'nothing'}; it has {', '.join(_PLAIN)} and one of {', '.join(_CURVES)}")
        given.append((layer["thickness"], layer["density"], layer["shear_wave_velocity"], kinds[0], layer[kinds[0]]))
    if set(rock) != {"density", "shear_wave_velocity"}:
        raise Error("the rock has density and shear_wave_velocity")
    below = (rock["density"], rock["shear_wave_velocity"])
    reached, _ = equivalent_linear(given, below, channel.acceleration.tolist(), channel.dt, at == "surface", share)
    return [
        {
            "thickness": float(layer["thickness"]),
            "density": float(layer["density"]),
            "shear_wave_velocity": float(layer["shear_wave_velocity"]) * modulus**0.5,
            "damping": damping,
            "strain": strain,
            "modulus": modulus,
        }
        for layer, (strain, modulus, damping) in zip(layers, reached, strict=True)
    ]
