// One set of axes, drawn by uPlot.
import uPlot from "uplot";
import type { Numbers, Panel } from "./data";
import { ticks } from "./format";
import { type Palette, pen } from "./palette";

const FONT = `system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans CJK SC", sans-serif`;
/** Room left of the axes for their numbers, equal in all panels of a figure so that they stand in line. */
export const LEFT = 62;
/** Room below the last panel for the numbers of the abscissa. */
export const BELOW = 26;
/** How much of the other curves is left to see while one is lifted. */
const BEHIND = 0.14;

/** What a plot is made of. */
export interface Wanted {
  panel: Panel;
  across: Numbers["across"];
  values: Numbers["panels"][number];
  logAcross: boolean;
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
      points: { show: false },
    };
  });
  const options: uPlot.Options = {
    width: wanted.width,
    height: wanted.height,
    padding: [7 * magnified, 10 * magnified, 0, 0],
    legend: { show: false },
    focus: { alpha: BEHIND },
    cursor: {
      show: Boolean(shared),
      y: false,
      points: { size: 7, fill: palette.paper, width: 1.6 },
      drag: { x: true, y: false, dist: 4 },
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
      y: { distr: panel.log ? 3 : 1 },
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
      draw: [(u) => ring(u, wanted)],
    },
  };
  return new uPlot(options, [wanted.across, ...wanted.values] as uPlot.AlignedData);
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
