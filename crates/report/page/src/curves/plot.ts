// One set of axes, drawn by uPlot.
import uPlot from "uplot";
import type { Entry, Numbers, Panel, Rule } from "./data";
import { ticks } from "./format";
import { marks } from "./log";
import { type Palette, pen } from "./palette";

const FONT = `system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans CJK SC", sans-serif`;
/** Room left of the axes for their numbers, equal in all panels of a figure so that they stand in line. */
export const LEFT = 62;
/** Room below the last panel for the numbers of the abscissa. */
const BELOW = 26;
/** Room above the panels that name the rules. */
const NAMES = 16;
/** Pixels between the cursor and a point that is marked. */
const NEAR = 20;
/** How much of the other curves is left to see while one is lifted. */
const BEHIND = 0.14;

/** What a plot is made of. */
export interface Wanted {
  panel: Panel;
  across: Numbers["across"];
  values: Numbers["panels"][number];
  logAcross: boolean;
  rules: Rule[];
  /** Whether it carries the names of the rules. */
  named: boolean;
  palette: Palette;
  width: number;
  height: number;
  /** Whether it carries the numbers of the abscissa. */
  last: boolean;
  /** Pixels of the plot for each of the page: 1, and more in a file. */
  magnified: number;
  /** Plots with one key share a cursor. */
  shared?: { key: string; listens: () => boolean };
  onCursor?: (row: number | null) => void;
  onRange?: (min: number, max: number) => void;
}

/** What a panel has by its place in the figure; its height is about as in the drawing. */
export function place({ panels, abreast }: Entry, k: number): Pick<Wanted, "last" | "named" | "height"> {
  // A phone has panels of a row below each other, each with its numbers.
  const last = abreast > 1 || k === panels.length - 1;
  const height = abreast > 1 ? 140 : ({ 1: 270, 2: 200 }[panels.length] ?? 158);
  const named = k < abreast;
  return { last, named, height: height + (last ? BELOW : 6) };
}

/** Makes a plot. */
export function plot(wanted: Wanted): uPlot {
  const { panel, palette, magnified, shared } = wanted;
  const font = `${12 * magnified}px ${FONT}`;
  const grid = { stroke: palette.grid, width: magnified };
  const series = panel.lines.map((line): uPlot.Series => {
    const { width, dash } = pen(line.stroke, line.colour);
    return {
      label: line.name,
      stroke: () => palette.line(line.colour),
      width: width * magnified,
      dash: dash?.map((length) => length * magnified),
      // uPlot draws on across a gap and cuts it out, to whole pixels: of a steep stretch more than a pixel's length is left.
      gaps: (_u, _line, _from, _to, gaps) => gaps.map(([from, to]) => [from - magnified, to + magnified]),
      points: { show: line.points, size: 5 * magnified, width: 0, fill: () => palette.line(line.colour) },
    };
  });
  // Few numbers in a narrow plot.
  const spread = (space: number) => (u: uPlot, axis: number, low: number, high: number) =>
    marks(low, high, Math.max(2, (axis ? u.bbox.height : u.bbox.width) / devicePixelRatio / (space * magnified)));
  const logarithmic = (space: number): uPlot.Axis => ({ splits: spread(space), filter: (_, splits) => splits });
  const options: uPlot.Options = {
    width: wanted.width,
    height: wanted.height,
    padding: [(wanted.named && wanted.rules.length ? 7 + NAMES : 7) * magnified, 10 * magnified, 0, 0],
    legend: { show: false },
    focus: { alpha: BEHIND },
    cursor: {
      show: Boolean(shared),
      y: false,
      points: { size: 7, fill: palette.paper, width: 1.6 },
      drag: { x: true, y: false, dist: 4 },
      // At a row of other lines, a line's own point is marked where it is near.
      hover: { prox: (u, line, row) => (u.data[line][row] === undefined ? NEAR : null) },
      sync: shared && {
        key: shared.key,
        scales: ["x", null],
        setSeries: false,
        // The cursor alone is shared among figures; what is enlarged is the figure's own.
        filters: { pub: (type) => type === "mousemove" || type === "mouseleave", sub: shared.listens },
      },
    },
    scales: {
      x: { time: false, distr: wanted.logAcross ? 3 : 1, range: (_, min, max) => [min, max] },
      y: { distr: panel.log ? 3 : 1, ...(panel.ends && { range: panel.ends }) },
    },
    axes: [
      {
        grid,
        font,
        stroke: palette.muted,
        ticks: { ...grid, size: 4 * magnified, show: wanted.last },
        size: (wanted.last ? BELOW : 6) * magnified,
        gap: 3 * magnified,
        space: 60 * magnified,
        ...(wanted.logAcross ? logarithmic(34) : {}),
        values: (_, values) => (wanted.last ? ticks(values, wanted.logAcross) : values.map(() => "")),
      },
      {
        grid,
        font,
        stroke: palette.muted,
        ticks: { ...grid, size: 4 * magnified },
        size: LEFT * magnified,
        gap: 4 * magnified,
        space: 30 * magnified,
        ...(panel.log ? logarithmic(30) : {}),
        values: (_, values) => ticks(values, panel.log),
      },
    ],
    series: [{}, ...series],
    hooks: {
      setCursor: [(u) => wanted.onCursor?.(u.cursor.idx ?? null)],
      setScale: [
        (u, key) => {
          const { min, max } = u.scales.x;
          if (key === "x" && min != null && max != null) wanted.onRange?.(min, max);
        },
      ],
      drawClear: [(u) => rules(u, wanted)],
      draw: [(u) => ring(u, wanted)],
    },
  };
  return new uPlot(options, [wanted.across, ...wanted.values] as uPlot.AlignedData);
}

/** Draws the places that have names, below the curves. */
function rules(u: uPlot, { rules, named, palette, magnified }: Wanted): void {
  const { ctx } = u;
  const ratio = (ctx.canvas.width / u.width) * magnified;
  const { left, top, width, height } = u.bbox;
  ctx.save();
  ctx.strokeStyle = palette.axis();
  ctx.fillStyle = palette.muted();
  ctx.lineWidth = ratio;
  ctx.font = `${11 * ratio}px ${FONT}`;
  ctx.textBaseline = "alphabetic";
  ctx.textAlign = "left";
  let free = -Infinity;
  for (const { across, name, side } of rules) {
    const x = u.valToPos(across, "x", true);
    if (!(x >= left - 1 && x <= left + width + 1)) continue;
    ctx.beginPath();
    ctx.moveTo(x, top);
    ctx.lineTo(x, top + height);
    ctx.stroke();
    if (!named) continue;
    const wide = ctx.measureText(name).width;
    const wanted = { start: x + 2 * ratio, center: x - wide / 2, end: x - wide - 2 * ratio }[side];
    const at = Math.min(Math.max(wanted, left), left + width - wide);
    // A name that would lie over another waits until the stretch is enlarged.
    if (at < free) continue;
    ctx.fillText(name, at, top - 5 * ratio);
    free = at + wide + 8 * ratio;
  }
  ctx.restore();
}

/** Marks the point that the panel's remark names. */
function ring(u: uPlot, { panel: { mark, lines }, palette, magnified }: Wanted): void {
  if (!mark || !u.series[mark.line + 1].show) return;
  const x = u.valToPos(mark.across, "x", true);
  const y = u.valToPos(mark.value, "y", true);
  const { left, top, width, height } = u.bbox;
  if (x < left || x > left + width || y < top || y > top + height) return;
  const ratio = u.ctx.canvas.width / u.width * magnified;
  u.ctx.save();
  u.ctx.setLineDash([]);
  u.ctx.beginPath();
  u.ctx.arc(x, y, 3.6 * ratio, 0, 2 * Math.PI);
  u.ctx.fillStyle = palette.paper();
  u.ctx.fill();
  u.ctx.lineWidth = 1.6 * ratio;
  u.ctx.strokeStyle = palette.line(lines[mark.line].colour);
  u.ctx.stroke();
  u.ctx.restore();
}
