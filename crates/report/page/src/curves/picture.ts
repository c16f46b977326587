// A figure as PNG: on white, in twice the pixels of the page, with what is shown now.
import type uPlot from "uplot";
import { acrossName, type Entry, labelled, type Numbers, type Panel } from "./data";
import { type Palette, pen } from "./palette";
import { LEFT, place, plot } from "./plot";

/** Pixels for each of the page. */
const MAGNIFIED = 2;
/** Room for a panel's title, and with its names. */
const TITLE = 26;
const HEADING = 44;
const WIDTH = 940;

/** What of a figure is shown. */
export interface Shown {
  entry: Entry;
  numbers: Numbers;
  palette: Palette;
  hidden: Set<string>;
  range: [number, number];
}

/** Draws the picture. */
export async function picture(shown: Shown): Promise<Blob | null> {
  const { entry, palette } = shown;
  palette.onPaper = true;
  const plots = entry.panels.map((_, k) => magnifiedPlot(shown, k));
  // uPlot draws in a microtask.
  await new Promise((done) => setTimeout(done, 0));
  const { abreast } = entry;
  const wide = WIDTH / abreast;
  // Panels beside each other have the same names, which stand above them once.
  const heading = abreast > 1 ? TITLE : HEADING;
  const heights = plots.map((u) => heading + u.height / MAGNIFIED);
  const top = 26 + (entry.heading ? HEADING : 0);
  const row = Math.max(...heights);
  const bottom = abreast > 1 ? top + row * Math.ceil(plots.length / abreast) : heights.reduce((sum, height) => sum + height, top);
  const canvas = document.createElement("canvas");
  canvas.width = WIDTH * MAGNIFIED;
  canvas.height = (bottom + 28) * MAGNIFIED;
  const context = canvas.getContext("2d");
  if (!context) return null;
  context.fillStyle = palette.paper();
  context.fillRect(0, 0, canvas.width, canvas.height);
  const text = writer(context);
  const names = (panel: Panel, left: number, y: number): void => {
    let x = left;
    for (const line of panel.lines.filter((line) => line.name && !shown.hidden.has(line.name))) {
      const { width, dash } = pen(line.stroke, line.colour);
      context.strokeStyle = palette.line(line.colour);
      context.lineWidth = Math.max(2.4, width);
      context.setLineDash(dash ?? []);
      context.beginPath();
      context.moveTo(x, y - 4);
      context.lineTo(x + 20, y - 4);
      context.stroke();
      x += 26 + text(line.name, x + 25, y, {}) + 14;
    }
  };
  text(entry.title, LEFT, 20, { bold: true, size: 15 });
  if (entry.heading) text(entry.heading, LEFT, 44, { bold: true });
  if (abreast > 1) names(entry.panels[0], LEFT, 63);
  let y = top;
  entry.panels.forEach((panel, k) => {
    const left = (k % abreast) * wide;
    text(labelled(panel.title, panel.unit), left + LEFT, y + 18, { bold: true });
    text(panel.remark, left + wide - 10, y + 18, { end: true, colour: palette.muted() });
    if (abreast === 1) names(panel, LEFT, y + 37);
    const { ctx, height } = plots[k];
    context.drawImage(ctx.canvas, left, y + heading, wide, height / MAGNIFIED);
    if (abreast === 1) y += heights[k];
    else if (k % abreast === abreast - 1) y += row;
  });
  text(labelled(acrossName(entry), entry.across.unit), WIDTH - 10, bottom + 14, { end: true, colour: palette.muted() });
  for (const u of plots) u.destroy();
  palette.onPaper = false;
  return new Promise((done) => canvas.toBlob(done, "image/png"));
}

function magnifiedPlot({ entry, numbers, palette, hidden, range }: Shown, k: number): uPlot {
  const panel = entry.panels[k];
  const { height, ...placed } = place(entry, k);
  const u = plot({
    panel,
    palette,
    ...placed,
    across: numbers.across,
    values: numbers.panels[k],
    logAcross: entry.across.log,
    rules: entry.rules,
    width: (WIDTH / entry.abreast) * MAGNIFIED,
    height: height * MAGNIFIED,
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
