"""Motions that fit a target spectrum: matched, artificial, chosen."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from ._motion import Channel, Motion, _target
from ._tremolite import Error, Target, artificial_record, select_records


def artificial(
    target: Target | str,
    duration: float,
    *,
    count: int = 1,
    seed: int = 1,
    band: tuple[float, float] | None = None,
    dt: float = 0.01,
    rise: float | None = None,
    fall: float | None = None,
    tolerance: float = 0.05,
) -> list[Channel]:
    """Motions of `duration` [s] with random phases whose spectra are a target's within `tolerance` in a band of periods [s], of mutual
    correlation below 0.3: those of `tremolite motion artificial`. Equal seeds give equal motions.

    Full strength is reached at `rise` [s] and left at `fall` [s]; left out, at a seventh and three fifths of the duration. `dt` [s] may
    become finer. Each is a `Channel` towards east; `dataclasses.replace(channel, azimuth=0.0)` turns it. Raises `Error` where phases
    give none that fits.
    """
    made, _ = artificial_record(_target(target), band, (duration, rise, fall), dt, (seed, count), tolerance)
    return [replace(channel, azimuth=90.0) for channel in made]


@dataclass(frozen=True)
class Candidate:
    """A component that `select` considered.

    motion, channel: its record's place in the list that was given, and its place in that.
    name: the channel's.
    factor: what to multiply it by: e to the mean of ln(target/Sa).
    misfit: root of the mean square of ln(factor Sa/target) over the band.
    largest, period: largest |factor Sa/target - 1|, and the period [s] where it is.
    """

    motion: int
    channel: int
    name: str
    factor: float
    misfit: float
    largest: float
    period: float


def select(
    motions: Sequence[Motion],
    target: Target | str,
    *,
    band: tuple[float, float] | None = None,
    factors: tuple[float, float] = (0.25, 4.0),
) -> list[Candidate]:
    """The horizontal components of records by how near their spectra are to a target in shape, nearest first, those apart whose factor is
    not within `factors`: as `tremolite motion select`, which first takes off the line of best fit (`motion.process("detrend linear")`)."""
    places = [(k, c) for k, motion in enumerate(motions) for c, channel in enumerate(motion) if not channel.up]
    if not places:
        raise Error("there is no horizontal component to choose from")
    chosen = [motions[k][c] for k, c in places]
    found, _ = select_records(Motion(chosen), _target(target), band, factors)
    return [Candidate(*places[at], chosen[at].name, *numbers) for at, *numbers in found]
