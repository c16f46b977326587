"""Records in memory, from ObsPy and back."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ._tremolite import (
    Error,
    Target,
    geographic,
    intensity,
    match_record,
    misfit_of,
    orientation,
    process_record,
    read_record,
    spectrum,
)

_UNITS = {"m/s2": 1.0, "cm/s2": 0.01, "gal": 0.01, "mm/s2": 0.001, "g": 9.80665}


@dataclass(frozen=True)
class Channel:
    """One component of a record.

    name: what to call it; NETWORK.STATION.LOCATION.CHANNEL goes back to ObsPy.
    dt: sampling interval [s].
    acceleration: (n,) [m/s²].
    azimuth: the positive direction [deg], clockwise from north; None where it is not known, or `up` is true.
    up: positive upwards.
    start: time of the first sample [s] on a clock that the channels share.
    origin: the time of that clock's zero, as text (ISO 8601, UTC); empty where none is known.
    """

    name: str
    dt: float
    acceleration: np.ndarray
    azimuth: float | None = None
    up: bool = False
    start: float = 0.0
    origin: str = ""

    def __post_init__(self) -> None:
        made = np.array(self.acceleration, dtype=float)
        if made.ndim != 1:
            raise Error(f"'{self.name}' has samples of the shape {made.shape}; a channel has one row of them")
        made.setflags(write=False)
        object.__setattr__(self, "acceleration", made)
        object.__setattr__(self, "dt", float(self.dt))

    @property
    def time(self) -> np.ndarray:
        """Times (n,) [s] of the samples."""
        return self.start + self.dt * np.arange(len(self.acceleration))

    @property
    def intensity(self) -> dict[str, float]:
        """pga [m/s²], pgv [m/s], pgd [m], arias [m/s], t5, t95 and d5_95 [s], cav [m/s], of the samples as they are."""
        return intensity(self.acceleration, self.dt)

    def spectrum(self, periods: Sequence[float], damping: float = 0.05) -> np.ndarray:
        """Pseudo-acceleration (n,) [m/s²] at periods [s], for a damping ratio; period 0 gives the peak."""
        return spectrum(self.acceleration, self.dt, list(map(float, periods)), damping)

    def match(self, target: Target | str, *, band: tuple[float, float] | None = None, tolerance: float = 0.05) -> Channel:
        """It made to fit a target spectrum within `tolerance` at 200 periods of a band [s], by wavelets added in time (Al Atik and
        Abrahamson 2010), at rest at its end: what `tremolite motion match` makes. Its sampling may be finer.

        Raises `Error` where it comes no nearer, with how near it came.
        """
        made, _, _ = match_record(Motion([self]), _target(target), band, tolerance)
        return replace(made[0], name=self.name, origin=self.origin)

    def misfit(self, target: Target | str, *, band: tuple[float, float] | None = None) -> dict[str, float]:
        """How far its spectrum is from a target's in a band of periods [s]: `largest` |Sa/target - 1| and the `period` [s] where it is,
        `rms` of the same, and the `factor` that would bring it to the target in the mean of the logarithm."""
        found, factor = misfit_of(Motion([self]), _target(target), band)
        return {**found, "factor": factor}


@dataclass(frozen=True)
class Motion:
    """A record: channels in m/s², each with its direction where that is known."""

    channels: tuple[Channel, ...]

    def __init__(self, channels: Iterable[Channel]) -> None:
        object.__setattr__(self, "channels", tuple(channels))
        if not self.channels:
            raise Error("a record has one channel and more")

    def __len__(self) -> int:
        return len(self.channels)

    def __iter__(self) -> Any:
        return iter(self.channels)

    def __getitem__(self, name: str | int) -> Channel:
        if isinstance(name, int):
            return self.channels[name]
        for channel in self.channels:
            if channel.name == name:
                return channel
        raise KeyError(f"no channel is called {name!r}; there are {', '.join(c.name for c in self.channels)}")

    def __repr__(self) -> str:
        names = ", ".join(channel.name for channel in self.channels)
        return f"<Motion of {names}; {len(self.channels[0].acceleration)} samples of {self.channels[0].dt} s>"

    def match(self, target: Target | str, *, band: tuple[float, float] | None = None, tolerance: float = 0.05) -> Motion:
        """It with its horizontal components made to fit a target spectrum, each by itself: see `Channel.match`. What looks up stays as it
        is, since the target is horizontal."""
        return Motion(c if c.up else c.match(target, band=band, tolerance=tolerance) for c in self.channels)

    def factor_to(self, target: Target | str, *, band: tuple[float, float] | None = None) -> float:
        """The one factor for all components that brings the geometric mean of the horizontal ones to a target over a band of periods [s],
        in the mean of the logarithm: `motion.scaled(motion.factor_to(target))`."""
        factors = [c.misfit(target, band=band)["factor"] for c in self.channels if not c.up]
        if not factors:
            raise Error("the record has no horizontal component, which the target is of")
        return float(np.exp(np.mean(np.log(factors))))

    @classmethod
    def from_components(cls, dt: float, *, east: Any = None, north: Any = None, up: Any = None, name: str = "motion") -> Motion:
        """A record of arrays (n,) [m/s²], `dt` [s] apart, towards east, north and up; what is left out stands still."""
        given = [samples for samples in (east, north, up) if samples is not None]
        if not given:
            raise Error("a record has one component and more; give east, north or up")
        still = np.zeros(np.shape(given[0]))
        made = []
        for label, samples, where in (
            ("east", east, {"azimuth": 90.0}),
            ("north", north, {"azimuth": 0.0}),
            ("up", up, {"up": True}),
        ):
            made.append(Channel(f"{name}.{label}", dt, still if samples is None else samples, **where))
        return cls(made)

    @classmethod
    def read(
        cls,
        path: str | os.PathLike[str],
        *,
        units: str | None = None,
        dt: float | None = None,
        sensitivity: str | None = None,
        columns: list[str] | None = None,
        encoding: str | None = None,
    ) -> Motion:
        """Reads a record of any format that the program knows (`tremolite list formats`), told by its content.

        `units`, `dt` [s], `sensitivity`, `columns` and `encoding` are for files that do not say, as in a case.
        Remarks of the reader are warned of.
        """
        motion, remarks = read_record(path, units, dt, sensitivity, columns, encoding)
        for remark in remarks:
            warnings.warn(f"{os.fspath(path)}: {remark}", stacklevel=2)
        return motion

    @classmethod
    def from_stream(cls, stream: Any, *, units: str | None = None, inventory: Any = None) -> Motion:
        """A record of an ObsPy stream: every trace a channel, its direction by the inventory or by its code (HNE, NS, UD).

        `units` are those of the samples: "m/s2", "cm/s2", "mm/s2", "g"; left out they follow from a removed response
        (`output="ACC"`) or from the factor that K-NET's files bring along. The case's `model_x_azimuth` turns the record into the
        model's axes.

        Raises `Error` with the way out for gaps, overlaps, several traces of one channel, unlike sampling, unknown units or samples
        that are not finite.
        """
        traces = list(stream)
        if not traces:
            raise Error("the stream is empty; read a record first")
        _whole(traces)
        first = min(trace.stats.starttime for trace in traces)
        channels = []
        for trace in traces:
            stats = trace.stats
            samples = np.asarray(trace.data, dtype=float) * _factor(trace, units)
            if not np.isfinite(samples).all():
                raise Error(f"{trace.id} holds samples that are not finite; interpolate or cut them")
            azimuth, up, sign = _direction(trace, inventory)
            channels.append(
                Channel(
                    trace.id,
                    stats.delta,
                    sign * samples if sign < 0 else samples,
                    azimuth,
                    up,
                    float(stats.starttime - first),
                    str(first),
                )
            )
        return cls(channels)

    def to_stream(self) -> Any:
        """The record as an ObsPy stream, in m/s². Needs ObsPy."""
        from obspy import Stream, Trace, UTCDateTime

        traces = []
        for channel in self.channels:
            trace = Trace(np.array(channel.acceleration))
            parts = channel.name.split(".")
            if len(parts) == 4:
                trace.id = channel.name
            else:
                trace.stats.station = channel.name
            trace.stats.delta = channel.dt
            trace.stats.starttime = (UTCDateTime(channel.origin) if channel.origin else UTCDateTime(0)) + channel.start
            traces.append(trace)
        return Stream(traces)

    def process(self, *steps: str) -> Motion:
        """The record after steps as `motion.processing` of a case has them: "detrend linear", "bandpass 0.1 Hz 20 Hz", "baseline"."""
        made = process_record(self, list(steps))
        return Motion(replace(new, origin=old.origin) for new, old in zip(made.channels, self.channels, strict=True))

    def scaled(self, factor: float) -> Motion:
        """The record times a factor."""
        return Motion(replace(c, acceleration=factor * c.acceleration) for c in self.channels)

    def geographic(self) -> dict[str, Any]:
        """East, north and up (n,) [m/s²], turned from whatever the channels look to, with `dt` and `start` [s]."""
        dt, start, (east, north, up) = geographic(self)
        return {"dt": dt, "start": start, "east": east, "north": north, "up": up}


def _whole(traces: list[Any]) -> None:
    """Refuses gaps and what is sampled unlike."""
    seen: dict[str, Any] = {}
    for trace in traces:
        if np.ma.is_masked(trace.data):
            raise Error(f"{trace.id} has gaps; cut it to a whole stretch (trim), or fill them (merge with fill_value)")
        other = seen.setdefault(trace.id, trace)
        if other is not trace:
            gap = float(trace.stats.starttime - other.stats.endtime) - trace.stats.delta
            kind = "a gap" if gap > 0 else "an overlap"
            raise Error(
                f"{trace.id} comes in several traces, with {kind} of {abs(gap):.3g} s between them; merge the stream "
                "(stream.merge) and cut it to a whole stretch"
            )
    steps = sorted({float(trace.stats.delta) for trace in traces})
    # What headers round differently is one rate, as it is for files.
    if steps[-1] > (1.0 + 1e-6) * steps[0]:
        listed = ", ".join(f"{step:.9g} s" for step in steps)
        raise Error(f"the traces are sampled at {listed}; bring them to one rate (stream.interpolate or resample)")


def _target(target: Target | str) -> Target:
    return target if isinstance(target, Target) else Target(target)


def _factor(trace: Any, units: str | None) -> float:
    """What makes m/s² of a trace's samples."""
    if units is not None:
        if units not in _UNITS:
            raise Error(f"{units!r} is no unit of acceleration; write {', '.join(map(repr, _UNITS))}")
        return _UNITS[units]
    done = " ".join(trace.stats.get("processing", []))
    if "integrate(" in done or "differentiate(" in done:
        raise Error(
            f"{trace.id} was integrated or differentiated: say in which unit its accelerations are, "
            'units="m/s2", or give the record before that'
        )
    if "remove_response" in done and ("output='ACC'" in done or 'output="ACC"' in done):
        return 1.0
    # ObsPy leaves counts of K-NET and KiK-net as they are, and puts the factor to m/s² beside them.
    if trace.stats.get("_format") == "KNET" or "knet" in trace.stats:
        return float(trace.stats.calib)
    raise Error(
        f'nothing says in which unit the samples of {trace.id} are; give units="m/s2" (or "cm/s2", "g"), or remove the '
        'response first: stream.remove_response(inventory, output="ACC")'
    )


def _direction(trace: Any, inventory: Any) -> tuple[float | None, bool, float]:
    """Azimuth [deg], whether upwards, and the sign that turns a sensor that looks down."""
    if inventory is not None:
        place = inventory.get_orientation(trace.id, trace.stats.starttime)
        dip = place["dip"]
        if abs(dip) > 89.0:
            return None, True, 1.0 if dip < 0 else -1.0
        if abs(dip) > 1.0:
            raise Error(f"{trace.id} looks neither along the ground nor up (dip {dip} deg); rotate the stream to ZNE first")
        return float(place["azimuth"]), False, 1.0
    label = trace.stats.channel.rstrip("12") if trace.stats.get("_format") == "KNET" else trace.stats.channel
    azimuth, up = orientation(label)
    if azimuth is None and not up:
        raise Error(
            f"nothing says where {trace.id} looks to; give inventory=, or rename its channel to end in E, N or Z "
            "if those are its directions"
        )
    return azimuth, up, 1.0
