"""Draws figures 5 to 9 of the paper from runs of this case, with the paper's numbers as marks.

    python cases/yingxiuwan/figures.py OUT NAME=FOLDER [NAME=FOLDER]

A column for each run. It needs the Python package (`pip install .`) and Matplotlib. Displacements are those beside the monitor `base`;
times are the paper's.
"""

from __future__ import annotations

import pathlib
import sys

import matplotlib

matplotlib.use("agg")
import matplotlib.pyplot as plt
import numpy as np
import rules
from matplotlib.colors import ListedColormap
from matplotlib.patches import Patch
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

import tremolite as tr

FACES = np.array([[0, 1, 2, 3], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]])
ZONES = ("#dddddd", "#4477aa", "#ee6677", "#aa3377")
STYLE = {"font.size": 8, "axes.spines.top": False, "axes.spines.right": False}


def motion(runs, out):
    """Figure 5."""
    figure, axes = plt.subplots(3, len(runs), figsize=(4.6 * len(runs), 6.2), sharex=True, sharey="row", squeeze=False)
    for column, (name, result) in zip(axes.T, runs, strict=True):
        h = rules.histories(result, relative=True)
        t = h.time + rules.OFFSET
        for m in rules.MONITORS:
            column[0].plot(t, np.minimum(h.u[m], 70.0), lw=0.8, label=m)
        for at, height in rules.CRESTS:
            column[0].errorbar(at, height, yerr=0.15 * height, xerr=0.5, color="black", lw=1.0, capsize=2, zorder=5)
        column[0].plot([], [], "k+", label="paper")
        column[0].set_title(name)
        for axis, way, label in ((column[1], "ux", "across"), (column[2], "uz", "up")):
            for m in rules.MONITORS:
                u = 1e3 * (result.monitors[m][way] - result.monitors["base"][way])
                axis.plot(t, np.clip(u, -70.0, 70.0), lw=0.6)
            axis.set_ylabel(f"{label} [mm]")
        column[0].set_ylabel("length [mm]")
        column[2].set_xlabel("paper's time [s]")
    figure.tight_layout(rect=(0.0, 0.0, 1.0, 0.96))
    figure.legend(*axes[0, 0].get_legend_handles_labels(), ncol=7, loc="upper center", frameon=False)
    figure.savefig(out / "motion.png", dpi=120)


def stress(runs, out):
    """Figure 6."""
    figure, axes = plt.subplots(1, len(runs), figsize=(4.6 * len(runs), 2.8), sharey=True, squeeze=False)
    for axis, (name, result) in zip(axes[0], runs, strict=True):
        h = rules.histories(result, relative=True)
        for m in "ACD":
            axis.plot(h.time + rules.OFFSET, h.s1[m], lw=0.7, label=m)
        for start, end, low, high in ((0.0, 4.0, 0.8, 1.0), (4.0, 15.0, 0.45, 1.64), (15.0, 20.0, 0.8, 1.0)):
            axis.fill_between([start, end], low, high, color="black", alpha=0.1, lw=0, label="paper" if start == 0.0 else None)
        axis.axhline(1.2, color="black", lw=0.6, ls="--", label="tensile strength")
        axis.set_title(name)
        axis.set_xlabel("paper's time [s]")
    axes[0, 0].set_ylabel("largest principal stress [MPa]")
    figure.tight_layout(rect=(0.0, 0.0, 1.0, 0.93))
    figure.legend(*axes[0, 0].get_legend_handles_labels(), ncol=5, loc="upper center", frameon=False)
    figure.savefig(out / "stress.png", dpi=120)


def drawn(axis, faces, colours, title=None):
    """Quadrilaterals in three dimensions, seen from above and beside."""
    axis.add_collection3d(Poly3DCollection(faces, facecolors=colours, edgecolors="#00000030", linewidths=0.2))
    low, high = faces.reshape(-1, 3).min(axis=0), faces.reshape(-1, 3).max(axis=0)
    axis.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
    axis.set_box_aspect(high - low, zoom=1.35)
    axis.view_init(elev=28, azim=-50)
    axis.set_axis_off()
    if title:
        axis.set_title(title, fontsize=8, y=1.05)


def elements(grid, hall):
    """The outer faces of a hall's lining and the element behind each."""
    here = np.flatnonzero(grid.cell_data[f"group:{hall}.lining"] != 0)
    corners = grid.cells[grid.offsets[here][:, None] - 8 + np.arange(8)]
    faces = corners[:, FACES].reshape(-1, 4)
    _, index, count = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
    outside = index[count == 1]
    return grid.points[faces[outside]], here[outside // 6]


def damage(runs, out):
    """Figures 7 and 8: D_b before and at the end, and zones of tension, shear and both."""
    colours = plt.get_cmap("OrRd")
    for file, parts in (("damage.png", ("before", "at 20 s")), ("zones.png", ("zones",))):
        figure, axes = plt.subplots(
            2, len(parts) * len(runs), figsize=(2.6 * len(parts) * len(runs) + 0.8, 5.0), subplot_kw={"projection": "3d"}, squeeze=False
        )
        for k, (name, result) in enumerate(runs):
            first, last = result.fields[0].read(), result.fields[-1].read()
            for row, hall in enumerate(rules.HALLS):
                for p, part in enumerate(parts):
                    grid = first if part == "before" else last
                    faces, cell = elements(grid, hall)
                    if part == "zones":
                        kind = (grid.cell_data["d_tension"][cell] > 0.1) * 1 + (grid.cell_data["d_shear"][cell] > 0.1) * 2
                        shown = np.array(ZONES)[kind]
                    else:
                        shown = colours(np.clip(grid.cell_data["d_b"][cell], 0.0, 1.0))
                    drawn(axes[row, len(parts) * k + p], faces, shown, f"{name}\n{hall}" + (f", {part}" if part != "zones" else ""))
        if file == "damage.png":
            bar = figure.colorbar(plt.cm.ScalarMappable(cmap=colours), ax=axes, shrink=0.5, pad=0.01)
            bar.set_label("$D_b$, of the signs of that instant")
        else:
            legend(figure, ("sound", "tension", "shear", "both"))
        figure.savefig(out / file, dpi=120, bbox_inches="tight")


def legend(figure, names):
    figure.legend(handles=[Patch(color=c, label=n) for c, n in zip(ZONES, names, strict=True)], ncol=4, loc="lower center", frameon=False)


def interface(runs, out):
    """Figure 9."""
    figure, axes = plt.subplots(2, len(runs), figsize=(2.6 * len(runs) + 0.8, 5.0), subplot_kw={"projection": "3d"}, squeeze=False)
    cmap = ListedColormap(ZONES)
    for column, (name, result) in zip(axes.T, runs, strict=True):
        joint = result.interface_fields[-1].read()
        quads = joint.cells[joint.offsets[:, None] - 4 + np.arange(4)]
        slid = joint.point_data["slid"][quads].mean(axis=1) >= 0.5
        opened = joint.point_data["opened"][quads].mean(axis=1) >= 0.5
        kind = slid * 1 + opened * 2
        grid = result.fields[-1].read()
        own = {h: set(grid.cell_data["element"][grid.cell_data[f"group:{h}.lining"] != 0].tolist()) for h in rules.HALLS}
        pairs = list(zip(joint.cell_data["element"].tolist(), joint.cell_data["other_element"].tolist(), strict=True))
        for axis, hall in zip(column, rules.HALLS, strict=True):
            here = np.array([a in own[hall] or b in own[hall] for a, b in pairs])
            drawn(axis, joint.points[quads[here]], cmap(kind[here]), f"{name}\n{hall}")
    legend(figure, ("neither", "slid", "opened", "both"))
    figure.savefig(out / "interface.png", dpi=120, bbox_inches="tight")


def main() -> int:
    if len(sys.argv) < 3 or not all("=" in a for a in sys.argv[2:]):
        print(__doc__.splitlines()[2].strip(), file=sys.stderr)
        return 2
    out = pathlib.Path(sys.argv[1])
    out.mkdir(parents=True, exist_ok=True)
    runs = [(name, tr.Result(folder)) for name, folder in (a.split("=", 1) for a in sys.argv[2:])]
    with plt.rc_context(STYLE):
        for draw in (motion, stress, damage, interface):
            draw(runs, out)
    return 0


if __name__ == "__main__":
    sys.exit(main())
