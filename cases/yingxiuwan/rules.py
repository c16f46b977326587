"""Sets runs of this case beside the paper, by twenty rules that were written before the runs.

    python cases/yingxiuwan/rules.py FOLDER... [--table FILE]

FOLDER is of a run, or of a study of runs. It needs the Python package (`pip install .`). Displacements are lengths of what a monitor of
the lining moves beside the monitor `base`, in mm; s1 is in MPa; times are the paper's, whose zero lies 0.52 s before that of a run. A rule
is met or not, and the score of a run is how many are: never what several runs meet together. Beside it stands the score with displacements
as they are, not relative to the base, and that with D_b as the largest so far in place of that of the last instant.
"""

from __future__ import annotations

import argparse
import csv
import dataclasses
import itertools
import pathlib
import sys

import numpy as np

OFFSET = 0.52  # s: the record's first sample is of 20.52 s, the paper's time begins at 20 s
MONITORS = "ABCDEF"
CRESTS = ((10.0, 48.0), (13.2, 54.0), (16.5, 50.0))  # s, mm
HALLS = ("powerhouse", "transformer")
SIDES = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]])  # corners of an element
JUNCTION = 2.0  # m to each side of a springing, and of the crown's top


@dataclasses.dataclass
class Histories:
    """Of the monitors A to F: time in s from the run's beginning, lengths of displacement in mm, s1 in MPa of A, C and D."""

    time: np.ndarray
    u: dict[str, np.ndarray]
    s1: dict[str, np.ndarray]


@dataclasses.dataclass
class Lining:
    """Elements of one hall's lining: volumes in m3, parts by masks, D_b before and after, D+ and D- after, and their place along the hall.

    `free` is the share of the interface behind an element that slid or opened, None where there is none behind it; `area` is that area.
    """

    volume: np.ndarray
    crown: np.ndarray
    junction: np.ndarray
    top: np.ndarray
    end: np.ndarray  # within a tenth of the hall's length from an end
    before: np.ndarray
    after: np.ndarray
    tension: np.ndarray
    shear: np.ndarray
    area: np.ndarray
    free: np.ndarray


@dataclasses.dataclass
class Row:
    """A rule: its number, what it asks, what was found, and whether that meets it."""

    number: int
    asks: str
    found: str
    met: bool

    def __post_init__(self):
        self.met = bool(self.met)


def crests(u: np.ndarray) -> np.ndarray:
    """Indices of local maxima."""
    return 1 + np.flatnonzero((u[1:-1] > u[:-2]) & (u[1:-1] >= u[2:]))


def in_step(a: np.ndarray, b: np.ndarray, dt: float) -> tuple[float, float]:
    """The largest correlation of two histories over shifts up to half a second, and that shift in s."""
    best = (-2.0, 0.0)
    most = int(round(0.5 / dt))
    for shift in range(-most, most + 1):
        x, y = (a[shift:], b[: len(b) - shift]) if shift >= 0 else (a[:shift], b[-shift:])
        x, y = x - x.mean(), y - y.mean()
        size = np.sqrt((x @ x) * (y @ y))
        value = x @ y / size if size > 0.0 else 0.0
        if value > best[0]:
            best = (value, shift * dt)
    return best


def of_motion(h: Histories) -> list[Row]:
    """Rules 1 to 11."""
    t = h.time + OFFSET
    u = h.u
    a = u["A"]
    rows = []

    def row(number, asks, found, met):
        rows.append(Row(number, asks, found, met))

    early = max(x[t < 6.0].max() for x in u.values())
    row(1, "all at most 15 mm before 6 s", f"{early:.1f} mm", early <= 15.0)
    tops = crests(a)
    near_a_crest = np.zeros(len(tops), bool)
    for number, (at, height) in enumerate(CRESTS, 2):
        here = np.abs(t[tops] - at) <= 0.5
        near_a_crest |= here
        if not here.any():
            row(number, f"A has a crest of {height:.0f} mm ± 15 % within 0.5 s of {at} s", "no crest", False)
            continue
        k = tops[here][np.argmax(a[tops[here]])]
        row(
            number,
            f"A has a crest of {height:.0f} mm ± 15 % within 0.5 s of {at} s",
            f"{a[k]:.1f} mm at {t[k]:.1f} s",
            abs(a[k] - height) <= 0.15 * height,
        )
    others = a[tops[~near_a_crest]]
    other = others.max() if len(others) else 0.0
    row(5, "no other crest of A above 45 mm", f"{other:.1f} mm", other <= 45.0)
    lowest = a[t >= 6.0].min()
    row(6, "A at least 10 to 20 mm after 6 s", f"{lowest:.1f} mm", 10.0 <= lowest <= 20.0)
    left = [x[-1] for x in u.values()]
    row(7, "4 to 12 mm left of each", f"{min(left):.1f} to {max(left):.1f} mm", min(left) >= 4.0 and max(left) <= 12.0)
    dt = float(np.median(np.diff(h.time)))
    steps = [in_step(a, u[m], dt) for m in MONITORS[1:]]
    worst, late = min(c for c, _ in steps), max(abs(s) for _, s in steps)
    row(8, "correlation with A at least 0.95, at most 50 ms apart", f"{worst:.3f}, {late * 1e3:.0f} ms", worst >= 0.95 and late <= 0.0501)
    above = a.max() - max(u["B"].max(), u["C"].max())
    row(9, "A's largest above that of B and C by 5 mm", f"{above:.1f} mm", above >= 5.0)
    apart = max((a - u["B"]).max(), (a - u["C"]).max())
    row(10, "A less B or C at one instant, at most: 13 to 19 mm", f"{apart:.1f} mm", 13.0 <= apart <= 19.0)
    share = min(u[m].max() for m in "DEF") / a.max()
    small = max(np.abs(u["D"] - u[m]).max() for m in "EF")
    row(
        11,
        "D, E, F reach 0.8 of A, and D less E or F at most half of row 10",
        f"{share:.2f}, {small:.1f} mm",
        share >= 0.8 and small <= 0.5 * apart,
    )
    return rows


def of_stress(h: Histories) -> list[Row]:
    """Rules 12 to 16."""
    t = h.time + OFFSET
    s = h.s1
    rows = []

    def within(values, low, high):
        return min(values) >= low and max(values) <= high

    def each(values):
        return " ".join(f"{m} {v:.2f}" for m, v in zip("ACD", values, strict=True))

    first = [s[m][0] for m in "ACD"]
    rows.append(Row(12, "s1 before, at A, C and D: 0.75 to 0.95 MPa", each(first), within(first, 0.75, 0.95)))
    early = t <= 4.0
    low, high = [s[m][early].min() for m in "ACD"], [s[m][early].max() for m in "ACD"]
    rows.append(Row(13, "s1 until 4 s: 0.75 to 1.05 MPa", f"{min(low):.2f} to {max(high):.2f}", within(low + high, 0.75, 1.05)))
    middle = (t >= 4.0) & (t <= 15.0)
    lowest = min(s[m][middle].min() for m in "ACD")
    rows.append(Row(14, "lowest s1 from 4 to 15 s: 0.35 to 0.55 MPa", f"{lowest:.2f}", 0.35 <= lowest <= 0.55))
    most = [s[m].max() for m in "ACD"]
    met = abs(most[0] - 1.64) <= 0.164 and abs(most[2] - 1.52) <= 0.152 and most[1] < min(most[0], most[2])
    rows.append(Row(15, "s1 at most: A 1.64, D 1.52 MPa ± 10 %, C below both", each(most), met))
    last = [s[m][-1] for m in "ACD"]
    met = within(last, 0.75, 1.05) and all(b >= a for a, b in zip(first, last, strict=True))
    rows.append(Row(16, "s1 at the end: 0.75 to 1.05 MPa, none below before", each(last), met))
    return rows


def of_damage(power: Lining, transformer: Lining) -> list[Row]:
    """Rules 17 to 20."""
    halls = (power, transformer)
    rows = []

    def share(values, where):
        whole = sum((v * h.volume).sum() for v, h in zip(values, halls, strict=True))
        return sum((v * h.volume)[w].sum() for v, h, w in zip(values, halls, where, strict=True)) / whole if whole > 0.0 else 0.0

    most = max(h.before.max() for h in halls)
    there = share([h.before for h in halls], [power.junction, transformer.junction | transformer.crown])
    rows.append(
        Row(
            17,
            "D_b before below 0.3, and 80 % of it at junctions and the transformer cavern's crown",
            f"{most:.2f}, {100 * there:.0f} %",
            0.0 < most < 0.3 and there >= 0.8,
        )
    )
    crown = power.volume[power.crown & (power.after > 0.1)].sum() / power.volume[power.crown].sum()
    walls = ~power.crown & ~power.junction

    def mean(where):
        return (power.after * power.volume)[where].sum() / power.volume[where].sum()

    where = int(np.argmax(transformer.after))
    largest = transformer.after[where]
    rows.append(
        Row(
            18,
            "D_b after: above 0.1 in half of the powerhouse's crown, more at junctions than in walls, up to 0.9; "
            "the transformer cavern's 0.7 to 0.9, at an end",
            f"{100 * crown:.0f} %, {mean(power.junction):.2f} and {mean(walls):.2f}, {power.after.max():.2f}; {largest:.2f}"
            + (" at an end" if transformer.end[where] else ""),
            crown >= 0.5
            and mean(power.junction) > mean(walls)
            and power.after.max() >= 0.9
            and 0.7 <= largest <= 0.9
            and transformer.end[where],
        )
    )
    sheared = share([(h.shear > 0.1) * 1.0 for h in halls], [h.junction for h in halls])
    top = power.volume[power.top & (power.tension > 0.1)].sum() / power.volume[power.top].sum()
    rows.append(
        Row(
            19,
            "80 % of what is sheared lies at junctions; half of the powerhouse's crown top is cracked in tension",
            f"{100 * sheared:.0f} %, {100 * top:.0f} %",
            sheared >= 0.8 and top >= 0.5,
        )
    )
    both = either = 0.0
    for h in halls:
        damaged = (h.after > 0.1) * 1.0
        both += (h.area * damaged * h.free).sum()
        either += (h.area * np.maximum(damaged, h.free)).sum()
    jaccard = both / either if either > 0.0 else 0.0
    rows.append(
        Row(20, "area slid or opened and area with D_b above 0.1: common over joint at least 0.5", f"{jaccard:.2f}", jaccard >= 0.5)
    )
    return rows


def histories(result, relative: bool) -> Histories:
    """Of a run's monitors."""
    tables = {m: result.monitors[m] for m in (*MONITORS, "base")}
    time = tables["A"]["time"]

    def length(m):
        parts = [tables[m][c] - (tables["base"][c] if relative else 0.0) for c in ("ux", "uy", "uz")]
        return 1e3 * np.sqrt(sum(p * p for p in parts))

    return Histories(time, {m: length(m) for m in MONITORS}, {m: 1e-6 * tables[m]["s1"] for m in "ACD"})


def volumes(corners: np.ndarray) -> np.ndarray:
    """Of hexahedra, by 2x2x2 points, which are exact."""
    total = np.zeros(len(corners))
    for r in itertools.product(0.5 + np.array([-0.5, 0.5]) / np.sqrt(3.0), repeat=3):
        share, slope = np.where(SIDES, r, 1.0 - np.array(r)), np.where(SIDES, 1.0, -1.0)
        along = [slope[:, k] * np.delete(share, k, axis=1).prod(axis=1) for k in range(3)]
        total += np.abs(np.linalg.det(np.einsum("kn,enc->ekc", np.array(along), corners))) / 8.0
    return total


def lining(result, hall: str, running: bool) -> Lining:
    """Of a run's first and last fields."""
    first, last = result.fields[0].read(), result.fields[-1].read()
    here = np.flatnonzero(last.cell_data[f"group:{hall}.lining"] != 0)
    number = {int(n): k for k, n in enumerate(last.cell_data["element"][here])}
    corners = last.points[last.cells[last.offsets[here][:, None] - 8 + np.arange(8)]]
    in_crown = last.cell_data[f"group:{hall}.lining.crown"][here] != 0
    left, right = corners[..., 0].min(), corners[..., 0].max()
    top, springing = corners[..., 2].max(), corners[in_crown][..., 2].min()

    # Eight pieces along each of an element's three ways tell how much of it lies near a line of the section.
    g = (np.arange(8) + 0.5) / 8.0
    r = np.stack(np.meshgrid(g, g, g, indexing="ij"), -1).reshape(-1, 3)
    shape = np.prod(np.where(SIDES[None], r[:, None], 1.0 - r[:, None]), axis=2)
    pieces = np.einsum("pn,enc->epc", shape, corners)

    def near(lines):
        found = np.zeros(pieces.shape[:2], bool)
        for x, z in lines:
            found |= np.hypot(pieces[..., 0] - x, pieces[..., 2] - z) <= JUNCTION
        return found.mean(axis=1) >= 0.25

    y = corners[..., 1].mean(axis=1)
    reach = max(abs(corners[..., 1].min()), abs(corners[..., 1].max()))
    joint = result.interface_fields[-1].read()
    area, free = np.zeros(len(here)), np.zeros(len(here))
    behind = zip(joint.cell_data["element"], joint.cell_data["other_element"], strict=True)
    which = np.array([number.get(int(n), number.get(int(o), -1)) for n, o in behind])
    quads = joint.cells[joint.offsets[:, None] - 4 + np.arange(4)]
    p = joint.points[quads]
    size = 0.5 * np.linalg.norm(np.cross(p[:, 2] - p[:, 0], p[:, 3] - p[:, 1]), axis=1)
    moved = ((joint.point_data["slid"] != 0) | (joint.point_data["opened"] != 0))[quads].mean(axis=1)
    ours = which >= 0
    np.add.at(area, which[ours], size[ours])
    np.add.at(free, which[ours], (size * moved)[ours])
    after = last.cell_data["d_b_max" if running else "d_b"][here]
    order = {int(n): k for k, n in enumerate(first.cell_data["element"])}
    then = np.array([order[int(n)] for n in last.cell_data["element"][here]])
    return Lining(
        volume=volumes(corners),
        crown=in_crown,
        junction=near([(left, springing), (right, springing)]),
        top=near([(0.5 * (left + right), top)]),
        end=reach - np.abs(y) <= 0.2 * reach,
        before=first.cell_data["d_b"][then],
        after=after,
        tension=last.cell_data["d_tension"][here],
        shear=last.cell_data["d_shear"][here],
        area=area,
        free=np.divide(free, area, out=np.zeros_like(free), where=area > 0.0),
    )


def rows(folder, relative: bool = True, running: bool = False) -> list[Row]:
    """The twenty rows of a run."""
    import tremolite as tr

    result = tr.Result(folder)
    h = histories(result, relative)
    if h.time[-1] + OFFSET < 19.9:
        raise ValueError(f"{folder} has come to {h.time[-1]:.2f} s; the rules ask for all of the record, 19.5 s")
    return of_motion(h) + of_stress(h) + of_damage(*(lining(result, hall, running) for hall in HALLS))


def runs(folders) -> list[pathlib.Path]:
    """The folders of runs among them and below."""
    found = []
    for folder in map(pathlib.Path, folders):
        found += [folder] if (folder / "monitors.csv").exists() else sorted(p.parent for p in folder.glob("runs/*/results/monitors.csv"))
    return found


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", nargs="+")
    parser.add_argument("--table", help="a CSV with a row a run")
    asked = parser.parse_args()
    found = runs(asked.folder)
    if not found:
        print("no run in " + ", ".join(asked.folder), file=sys.stderr)
        return 1
    table = []
    for folder in found:
        try:
            here = rows(folder)
        except ValueError as short:
            print(f"\n{short}")
            continue
        scores = [
            sum(r.met for r in here),
            sum(r.met for r in rows(folder, relative=False)),
            sum(r.met for r in rows(folder, running=True)),
        ]
        print(
            f"\n{folder}: {scores[0]} of {len(here)}; with displacements as they are {scores[1]}, with the largest D_b so far {scores[2]}"
        )
        for r in here:
            print(f"  {'met' if r.met else ' - '} {r.number:2d}  {r.asks}: {r.found}")
        name = folder.parent.name if folder.name == "results" else folder.name
        table.append([name, *map(str, scores), " ".join(str(r.number) for r in here if r.met), *(r.found for r in here)])
    if asked.table:
        with open(asked.table, "w", newline="", encoding="utf-8") as file:
            out = csv.writer(file)
            out.writerow(["run", "score", "score as it is", "score running", "met", *(str(k) for k in range(1, 21))])
            out.writerows(table)
    return 0


if __name__ == "__main__":
    sys.exit(main())
