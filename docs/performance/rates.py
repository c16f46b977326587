#!/usr/bin/env python3
"""Measures and draws the charts of docs/performance.md: the rate over size, over threads and over levels of steps.

    docs/performance/rates.py [--program PROGRAM] [--drawn]

Takes five minutes on two cores, which should do nothing else. What was measured is kept in rates.json beside this file; with `--drawn` nothing is measured and the charts
are drawn from it. Rates of other machines are given there by hand. Needs Python alone.
"""

import argparse
import json
import math
import pathlib
import re
import subprocess
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
SIZES = [1000, 3375, 8000, 27000, 97336, 262144, 1000000]
KINDS = {
    "elastic": [],
    "rock": ["--material", "mohr-coulomb", "--band", "--stressed"],
}
COLOURS = ["#1f5f99", "#c0504d", "#5b8c3e", "#7a5aa6"]


def bench(program, elements, threads, more):
    """Million element updates a second, the best of three."""
    steps = str(max(20, 40_000_000 // elements // 4))
    said = subprocess.run(
        [program, "bench", "bricks", "--elements", str(elements), "--threads", str(threads), "--steps", steps, "--json", *more],
        check=True,
        capture_output=True,
        text=True,
    ).stdout
    return json.loads(said)["element_updates_per_second"] / 1e6


def shaken(program, levels):
    """Half a second of quick.toml's strong motion on two threads: seconds by the clock, steps of the finest level, and updates in one over elements, slabs and columns of
    the ground beside them counted as updates alone."""
    with tempfile.TemporaryDirectory() as at:
        case = ROOT / "cases/yingxiuwan/quick.toml"
        change = ['dynamic.duration="0.5 s"', 'motion.window=["26 s","29 s"]', f"dynamic.levels={levels}"]
        subprocess.run(
            [program, "run", case, "--out", at, "--overwrite", "--threads", "2", *(word for one in change for word in ("--set", one))],
            check=True,
            capture_output=True,
        )
        log = (pathlib.Path(at) / "log.txt").read_text()
    seconds, steps, rate = re.search(r"([\d.]+) s for (\d+) steps: ([\d.]+) million", log).groups()
    elements = int(re.search(r"([\d,]+) elements", log).group(1).replace(",", ""))
    return {"levels": levels, "seconds": float(seconds), "steps": int(steps), "updates": float(rate) * 1e6 * float(seconds) / int(steps) / elements}


def measure(program, known):
    known["size"] = [
        {"kind": kind, "threads": threads, "rates": [[n, round(bench(program, n, threads, more), 2)] for n in SIZES]}
        for kind, more in KINDS.items()
        for threads in (1, 2)
    ]
    known["levels"] = [shaken(program, levels) for levels in (1, 2, 3, 4)]
    return known


def chart(label, across, up, lines, logarithmic):
    """Lines of points (x, y) with their names; from 0 on upwards."""
    width, height, left, right, top, bottom = 760, 360, 70, 570, 30, 310
    xs = [x for _, points in lines for x, _ in points]
    most = max(y for _, points in lines for _, y in points)
    tick = next(t for t in (0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50) if most / t <= 8)
    most = tick * math.ceil(most / tick)
    scale = math.log10 if logarithmic else float
    first, last = scale(min(xs)), scale(max(xs))
    x_of = lambda x: left + (right - left) * (scale(x) - first) / (last - first)
    y_of = lambda y: bottom - (bottom - top) * y / most
    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="13" role="img" aria-label="{label}">',
        f'<rect width="{width}" height="{height}" fill="#fff"/>',
    ]
    for k in range(round(most / tick) + 1):
        y = k * tick
        out.append(f'<line x1="{left}" x2="{right}" y1="{y_of(y):.1f}" y2="{y_of(y):.1f}" stroke="#ddd"/>')
        out.append(f'<text x="{left - 8}" y="{y_of(y) + 4:.1f}" text-anchor="end">{y:g}</text>')
    ticks = [10**k for k in range(math.ceil(first - 1e-9), math.floor(last + 1e-9) + 1)] if logarithmic and last - first > 2 else sorted(set(xs))
    for x in ticks:
        out.append(f'<line x1="{x_of(x):.1f}" x2="{x_of(x):.1f}" y1="{top}" y2="{bottom}" stroke="#ddd"/>')
        out.append(f'<text x="{x_of(x):.1f}" y="{bottom + 18}" text-anchor="middle">{x:,.0f}</text>')
    out.append(f'<text x="{(left + right) / 2}" y="{bottom + 40}" text-anchor="middle">{across}</text>')
    out.append(f'<text transform="translate(20 {(top + bottom) / 2}) rotate(-90)" text-anchor="middle">{up}</text>')
    # Names beside the ends of lines, apart from each other.
    ends = sorted((y_of(points[-1][1]), k) for k, (_, points) in enumerate(lines))
    places, at = {}, -1e9
    for y, k in ends:
        at = places[k] = max(y, at + 16)
    for k, (name, points) in enumerate(lines):
        colour, dash = COLOURS[k // 2 % 4 if len(lines) > 2 else k], ' stroke-dasharray="6 4"' if len(lines) > 2 and k % 2 else ""
        path = " ".join(f"{x_of(x):.1f},{y_of(y):.1f}" for x, y in points)
        out.append(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="2"{dash}/>')
        out += [f'<circle cx="{x_of(x):.1f}" cy="{y_of(y):.1f}" r="3" fill="{colour}"/>' for x, y in points]
        out.append(f'<text x="{x_of(points[-1][0]) + 10:.1f}" y="{places[k] + 4:.1f}" fill="{colour}">{name}</text>')
    return "\n".join([*out, "</svg>", ""])


def draw(known):
    threads = {1: "one thread", 2: "two threads"}
    rate = "million element updates a second"
    (HERE / "size.svg").write_text(
        chart("Element updates a second over the number of elements", "elements", rate, [(f"{of['kind']}, {threads[of['threads']]}", of["rates"]) for of in known["size"]], True)
    )
    of_size = {(of["kind"], of["threads"]): dict(map(tuple, of["rates"])) for of in known["size"]}
    here = [[n, of_size["rock", n][1000000]] for n in (1, 2)]
    (HERE / "threads.svg").write_text(
        chart("Element updates a second over threads, a million bricks of rock", "threads", rate, [(of["machine"], of["rates"]) for of in known["threads"]] + [("EPYC, two cores", here)], True)
    )
    step = [of["seconds"] / of["steps"] for of in known["levels"]]
    lines = [
        ("time of a step", [[of["levels"], time / step[0]] for of, time in zip(known["levels"], step)]),
        ("updates in it", [[of["levels"], of["updates"] / known["levels"][0]["updates"]] for of in known["levels"]]),
    ]
    (HERE / "levels.svg").write_text(chart("Time of a finest step, and updates in it, over the number of levels", "levels of steps", "over those with one level", lines, False))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", default=str(ROOT / "target/release/tremolite"))
    parser.add_argument("--drawn", action="store_true")
    args = parser.parse_args()
    path = HERE / "rates.json"
    known = json.loads(path.read_text())
    if not args.drawn:
        known = measure(args.program, known)
        path.write_text(json.dumps(known, indent=1) + "\n")
    draw(known)


if __name__ == "__main__":
    main()
