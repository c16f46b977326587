// A figure as PNG: on white, in twice the pixels of the page, with what is shown now.
import type uPlot from "uplot";
import { acrossName, type Entry, labelled, type Numbers } from "./data";
import { type Palette, pen } from "./palette";
import { LEFT, plot } from "./plot";

/** Pixels for each of the page. */
const MAGNIFIED = 2;
const HEADING = 44;
const WIDTH = 940;

/** What of a figure is shown. */
export interface Shown {
  entry: Entry;
  numbers: Numbers;
  palette: Palette;
  hidden: Set<string>;
  range: [number, number];
  height: (last: boolean) => number;
}

/** Draws the picture. */
export async function picture(shown: Shown): Promise<Blob | null> {
  const { entry, palette } = shown;
  palette.onPaper = true;
  const plots = entry.panels.map((_, k) => magnifiedPlot(shown, k));
  // uPlot draws in a microtask.
  await new Promise((done) => setTimeout(done, 0));
  const heights = plots.map((u) => u.height + HEADING * MAGNIFIED);
  const canvas = document.createElement("canvas");
  canvas.width = WIDTH * MAGNIFIED;
  canvas.height = heights.reduce((sum, height) => sum + height, 54 * MAGNIFIED);
  const context = canvas.getContext("2d");
  if (!context) return null;
  context.fillStyle = palette.paper();
  context.fillRect(0, 0, canvas.width, canvas.height);
  const text = writer(context);
  text(entry.title, LEFT, 20, { bold: true, size: 15 });
  let top = 26;
  entry.panels.forEach((panel, k) => {
    text(labelled(panel.title, panel.unit), LEFT, top + 18, { bold: true });
    text(panel.remark, WIDTH - 10, top + 18, { end: true, colour: palette.muted() });
    let x = LEFT;
    for (const line of panel.lines.filter((line) => !shown.hidden.has(line.name))) {
      const { width, dash } = pen(line.stroke, line.colour);
      context.strokeStyle = palette.line(line.colour);
      context.lineWidth = Math.max(2.4, width);
      context.setLineDash(dash ?? []);
      context.beginPath();
      context.moveTo(x, top + 33);
      context.lineTo(x + 20, top + 33);
      context.stroke();
      x += 26 + text(line.name, x + 25, top + 37, {}) + 14;
    }
    top += HEADING;
    const { ctx, height } = plots[k];
    context.drawImage(ctx.canvas, 0, top, WIDTH, height / MAGNIFIED);
    top += height / MAGNIFIED;
  });
  text(labelled(acrossName(entry), entry.across.unit), WIDTH - 10, top + 14, { end: true, colour: palette.muted() });
  for (const u of plots) u.destroy();
  palette.onPaper = false;
  return new Promise((done) => canvas.toBlob(done, "image/png"));
}

function magnifiedPlot({ entry, numbers, palette, hidden, range, height }: Shown, k: number): uPlot {
  const last = k === entry.panels.length - 1;
  const panel = entry.panels[k];
  const u = plot({
    panel,
    palette,
    last,
    across: numbers.across,
    values: numbers.panels[k],
    logAcross: entry.across.log,
    width: WIDTH * MAGNIFIED,
    height: height(last) * MAGNIFIED,
    magnified: MAGNIFIED,
  });
  u.setScale("x", { min: range[0], max: range[1] });
  panel.lines.forEach((line, i) => hidden.has(line.name) && u.setSeries(i + 1, { show: false }));
  return u;
}

interface Style {
  bold?: boolean;
  end?: boolean;
  size?: number;
  colour?: string;
}

/** Writes a text in units of the page; returns how wide it is. */
function writer(context: CanvasRenderingContext2D) {
  context.scale(MAGNIFIED, MAGNIFIED);
  return (text: string, x: number, y: number, { bold, end, size = 12.5, colour = "#1f2933" }: Style): number => {
    context.font = `${bold ? "600 " : ""}${size}px system-ui, -apple-system, "Noto Sans CJK SC", sans-serif`;
    context.fillStyle = colour;
    context.textAlign = end ? "end" : "start";
    context.fillText(text, x, y);
    return context.measureText(text).width;
  };
}
