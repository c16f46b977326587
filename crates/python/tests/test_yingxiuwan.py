"""The rules that set runs of Yingxiuwan beside the paper: what the paper prints meets them, and each is failed by what it forbids."""

import dataclasses
import pathlib
import sys

import numpy as np
import pytest

sys.path.insert(0, str(pathlib.Path(__file__).parents[3] / "cases" / "yingxiuwan"))
import rules  # noqa: E402


def bump(t, at, width):
    return np.exp(-(((t - at) / width) ** 2))


def as_the_paper():
    """Histories with the paper's figures."""
    time = np.arange(0.0, 19.49, 0.01)
    t = time + rules.OFFSET
    rise = 15.0 / (1.0 + np.exp(-(t - 6.6) / 0.1))
    fall = 1.0 - (8.0 / 15.0) / (1.0 + np.exp(-(t - 19.2) / 0.05))
    shape = 33.0 * bump(t, 10.0, 0.8) + 39.0 * bump(t, 13.2, 0.8) + 35.0 * bump(t, 16.5, 0.8)
    u = {
        m: (rise + share * shape) * np.where(t > 15.0, fall, 1.0)
        for m, share in zip("ABCDEF", (1.0, 0.6, 0.6, 0.95, 0.9, 0.9), strict=True)
    }
    # From 6 s on the lowest is what is left of the rise.
    late = (t >= 6.0) & (t < 8.0)
    for m in u:
        u[m][late] = np.maximum(u[m][late], 12.0)
        u[m][t > 19.2] = np.maximum(u[m][t > 19.2], 10.5)
    first, last = 0.85, 0.9
    low = {"A": 0.45, "C": 0.6, "D": 0.5}
    high = {"A": 1.64, "C": 1.2, "D": 1.52}
    s1 = {
        m: np.where(t < 15.0, first, last) + (high[m] - first) * bump(t, 9.0, 0.3) - (first - low[m]) * bump(t, 11.0, 0.3) for m in "ACD"
    }
    return rules.Histories(time, u, s1)


def lining():
    """Twelve elements of a hall: two walls of four with a junction each, and a crown of four; its damage is the paper's."""
    volume = np.ones(12)
    crown = np.arange(12) >= 8
    junction = np.isin(np.arange(12), (3, 7, 8, 11))
    top = np.isin(np.arange(12), (9, 10))
    end = np.isin(np.arange(12), (0, 3, 7))
    before = np.where(junction, 0.2, 0.0)
    after = np.where(crown | junction, 0.85, 0.05)
    return rules.Lining(
        volume=volume,
        crown=crown,
        junction=junction,
        top=top,
        end=end,
        before=before,
        after=after,
        tension=np.where(top, 0.9, 0.0),
        shear=np.where(junction, 0.5, 0.0),
        area=volume.copy(),
        free=np.where(crown | junction, 1.0, 0.0),
    )


def halls():
    power, transformer = lining(), lining()
    power.after[9] = 0.95
    transformer.after[transformer.after > 0.1] = 0.6
    transformer.after[3] = 0.8
    return power, transformer


def met(h, power, transformer):
    return {r.number for r in rules.of_motion(h) + rules.of_stress(h) + rules.of_damage(power, transformer) if r.met}


def test_what_the_paper_prints_meets_every_rule():
    assert met(as_the_paper(), *halls()) == set(range(1, 21))


def raised(m, at, by, width=0.3):
    def change(h, _power, _transformer):
        h.u[m] = h.u[m] + by * bump(h.time + rules.OFFSET, at, width)

    return change


def scaled(m, by):
    def change(h, _power, _transformer):
        h.u[m] = by * h.u[m]

    return change


def stressed(m, at, by, width=0.3):
    def change(h, _power, _transformer):
        h.s1[m] = h.s1[m] + by * bump(h.time + rules.OFFSET, at, width)

    return change


def late(h, _power, _transformer):
    h.u["B"] = np.roll(h.u["B"], 8)


def all_left(h, _power, _transformer):
    for m in h.u:
        h.u[m][-1] = 3.0


def elsewhere(_h, _power, transformer):
    transformer.free = 1.0 - transformer.free


def damaged(which, part, mask, value):
    def change(_h, power, transformer):
        hall = (power, transformer)[which]
        getattr(hall, part)[mask(hall)] = value

    return change


@pytest.mark.parametrize(
    ("number", "change"),
    [
        (1, raised("F", 3.0, 16.0)),
        (2, raised("A", 10.0, -12.0, 1.0)),
        (3, raised("A", 13.2, 12.0, 1.0)),
        (4, raised("A", 16.5, -15.0, 1.0)),
        (5, raised("A", 11.6, 40.0)),
        (6, raised("A", 8.2, -9.0)),
        (7, all_left),
        (8, late),
        (9, scaled("B", 1.4)),
        (10, scaled("C", 0.8)),
        (11, scaled("E", 0.7)),
        (12, stressed("C", rules.OFFSET, -0.2)),
        (13, stressed("D", 2.0, 0.4)),
        (14, stressed("A", 11.0, -0.2)),
        (15, stressed("C", 9.0, 0.5)),
        (16, stressed("A", 20.0, -0.3)),
        (17, damaged(0, "before", lambda h: ~h.crown & ~h.junction, 0.2)),
        (17, damaged(1, "before", lambda h: h.junction, 0.4)),
        (18, damaged(0, "after", lambda h: ~h.crown & ~h.junction, 0.95)),
        (18, damaged(1, "after", lambda h: h.crown, 0.85)),
        (19, damaged(0, "shear", lambda h: ~h.junction, 0.5)),
        (20, elsewhere),
    ],
)
def test_each_rule_is_failed_by_what_it_forbids(number, change):
    h, power, transformer = as_the_paper(), *halls()
    change(h, power, transformer)
    assert number not in met(h, power, transformer)


def test_a_hall_without_damage_meets_no_rule_of_damage():
    sound = [
        dataclasses.replace(x, before=0 * x.before, after=0 * x.after, tension=0 * x.tension, shear=0 * x.shear, free=0 * x.free)
        for x in halls()
    ]
    assert not any(r.met for r in rules.of_damage(*sound))
