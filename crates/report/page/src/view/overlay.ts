// What is written over the picture: colour bar, captions, axes. Drawn alike on the page and in the PNG.
import { Vector3, type Camera } from "three";
import { placing, type Range, type Scheme, table } from "./colours";
import { minus } from "./units";
import { ticks } from "./ticks";
import type { Shown } from "./units";
import type { WaveHeld } from "./manifest";
import { words } from "./words";

export interface Overlay {
  width: number;
  height: number;
  ink: string;
  muted: string;
  paper: string;
  /** The colour of what has no value. */
  nothing: string;
  /** In SI, with the unit to show it in. */
  bar: { range: Range; scheme: Scheme; shown: Shown; beyond: { below: boolean; above: boolean }; nothing: boolean } | null;
  /** By panel: where it is, its lines of text, and the pieces of flow lines, relative to the model's centre. */
  panels: { left: number; top: number; width: number; height: number; lines: string[]; flow: Vector3[][] }[];
  camera: Camera;
  waves: WaveHeld[];
}

/** Of the flow of water. */
const FLOW = "#0b4f9e";
/** Of the ways of waves. */
const WAVE = "#b0561b";

const FONT = '12px system-ui, -apple-system, "Segoe UI", Roboto, sans-serif';

/** Draws it in units of CSS pixels. */
export function drawOverlay(pen: CanvasRenderingContext2D, over: Overlay) {
  pen.font = FONT;
  pen.textBaseline = "middle";
  pen.lineJoin = "round";
  over.panels.forEach((panel, i) => {
    if (i > 0) {
      pen.strokeStyle = over.muted;
      pen.globalAlpha = 0.5;
      pen.strokeRect(panel.left - 0.5, panel.top - 0.5, panel.width + 2, panel.height + 2);
      pen.globalAlpha = 1;
    }
    drawFlow(pen, over, panel);
    const room = panel.width - 24 - (panel.left + panel.width === over.width && over.bar ? 70 : 0);
    let y = panel.top + 16;
    const lines = panel.lines.flatMap((line) => wrapped(pen, line, room));
    const wide = Math.max(...lines.map((line, n) => widthOf(pen, line, n === 0)));
    ground(pen, over, panel.left + 6, panel.top + 5, wide + 14, 17 * lines.length + 6);
    lines.forEach((line, n) => {
      text(pen, line, panel.left + 12, y, n === 0 ? over.ink : over.muted, n === 0);
      y += 17;
    });
  });
  if (over.bar) drawBar(pen, over, over.bar);
  const corner = over.panels[0];
  drawAxes(pen, over, corner.left + 38, corner.top + corner.height - 38);
  over.waves.forEach((wave, k) => drawWave(pen, over, wave, corner.left + 112 + 74 * k, corner.top + corner.height - 44));
}

function widthOf(pen: CanvasRenderingContext2D, line: string, bold: boolean): number {
  pen.font = bold ? `600 ${FONT}` : FONT;
  return pen.measureText(line).width;
}

/** A ground on which text can be read over anything. */
function ground(pen: CanvasRenderingContext2D, over: Overlay, x: number, y: number, width: number, height: number) {
  pen.globalAlpha = 0.82;
  pen.fillStyle = over.paper;
  pen.beginPath();
  pen.roundRect(x, y, width, height, 4);
  pen.fill();
  pen.globalAlpha = 1;
}

function text(pen: CanvasRenderingContext2D, line: string, x: number, y: number, colour: string, bold = false) {
  pen.font = bold ? `600 ${FONT}` : FONT;
  pen.fillStyle = colour;
  pen.fillText(line, x, y);
}

/** Lines no wider than there is room for, broken at spaces, or anywhere between wide characters. */
export function wrapped(pen: CanvasRenderingContext2D, line: string, room: number): string[] {
  const lines: string[] = [];
  let now = "";
  for (const piece of line.match(/[\u3000-\uffef]|[^\s\u3000-\uffef]+\s*|\s+/gu) ?? []) {
    if (now && pen.measureText(now + piece).width > room) {
      lines.push(now.trimEnd());
      now = "";
    }
    now += piece;
  }
  return now ? [...lines, now.trimEnd()] : lines;
}

/** The kinds of codes with their colours, one below the other. */
function drawKinds(pen: CanvasRenderingContext2D, over: Overlay, kinds: { name: string; colour: number[] | string }[]) {
  const last = over.panels[over.panels.length - 1];
  const row = 20;
  pen.font = FONT;
  const room = Math.max(...kinds.map(({ name }) => pen.measureText(name).width));
  const left = over.width - room - 40;
  const top = last.top + (last.height - row * kinds.length) / 2;
  ground(pen, over, left - 8, top - 6, room + 40, row * kinds.length + 12);
  kinds.forEach(({ name, colour }, k) => {
    const y = top + row * (k + 0.5);
    pen.fillStyle = typeof colour === "string" ? colour : `rgb(${colour.join()})`;
    pen.fillRect(left, y - 6, 14, 12);
    pen.strokeStyle = over.muted;
    pen.lineWidth = 1;
    pen.strokeRect(left + 0.5, y - 5.5, 13, 11);
    text(pen, name, left + 20, y, over.ink);
  });
}

function drawBar(pen: CanvasRenderingContext2D, over: Overlay, bar: NonNullable<Overlay["bar"]>) {
  const { range, scheme, shown, beyond } = bar;
  if (typeof scheme !== "string") {
    return drawKinds(pen, over, [...scheme.kinds, ...(bar.nothing ? [{ name: words.nothing, colour: over.nothing }] : [])]);
  }
  const last = over.panels[over.panels.length - 1];
  const height = Math.min(260, last.height * 0.55);
  const top = last.top + (last.height - height) / 2;
  const left = over.width - 66;
  const wide = 14;
  const colours = table(scheme);
  const { scale, shift } = placing(scheme, range);
  const colourAt = (share: number) => {
    const place = scale * (range.low + share * (range.high - range.low)) + shift;
    const i = 4 * Math.round(255 * Math.min(1, Math.max(0, place)));
    return `rgb(${colours[i]},${colours[i + 1]},${colours[i + 2]})`;
  };
  ground(pen, over, left - 12, top - 30, 78 - 4, height + 46);
  for (let y = 0; y < height; y++) {
    pen.fillStyle = colourAt(1 - (y + 0.5) / height);
    pen.fillRect(left, top + y, wide, 1.5);
  }
  // Points where values lie beyond the ends.
  const point = (from: number, to: number, colour: string) => {
    pen.fillStyle = colour;
    pen.beginPath();
    pen.moveTo(left, from);
    pen.lineTo(left + wide, from);
    pen.lineTo(left + wide / 2, to);
    pen.fill();
  };
  if (beyond.above) point(top, top - 10, colourAt(1));
  if (beyond.below) point(top + height, top + height + 10, colourAt(0));
  pen.strokeStyle = over.muted;
  pen.lineWidth = 1;
  pen.strokeRect(left + 0.5, top + 0.5, wide - 1, height - 1);
  const [low, high] = [range.low * shown.factor, range.high * shown.factor];
  const marks = ticks(low, high, height / 45);
  for (const value of marks.values) {
    const y = top + height * (1 - (high > low ? (value - low) / (high - low) : 0.5));
    pen.strokeStyle = over.muted;
    pen.lineWidth = 1;
    pen.beginPath();
    pen.moveTo(left + wide, y);
    pen.lineTo(left + wide + 4, y);
    pen.stroke();
    text(pen, tickLabel(value, marks.decimals), left + wide + 7, y, over.ink);
  }
  if (shown.unit) {
    pen.textAlign = "center";
    text(pen, shown.unit, left + wide / 2, top - (beyond.above ? 20 : 12), over.ink);
    pen.textAlign = "start";
  }
  if (bar.nothing) {
    const y = top + height + 30;
    pen.strokeStyle = over.muted;
    pen.lineWidth = 1;
    const room = pen.measureText(words.nothing).width;
    ground(pen, over, left - room - 14, y - 10, room + wide + 20, 20);
    pen.fillStyle = over.nothing;
    pen.fillRect(left, y - 6, wide, 12);
    pen.strokeRect(left + 0.5, y - 5.5, wide - 1, 11);
    text(pen, words.nothing, left - room - 8, y, over.ink);
  }
}

function tickLabel(value: number, decimals: number): string {
  const size = Math.abs(value);
  return minus(size && (decimals > 5 || size >= 1e6) ? value.toExponential(1) : value.toFixed(decimals));
}

/** The axes as they are turned, the near ones last. */
function drawAxes(pen: CanvasRenderingContext2D, over: Overlay, x: number, y: number) {
  const inverse = over.camera.quaternion.clone().invert();
  const axes = [
    { name: "x", way: new Vector3(1, 0, 0), colour: "#c4422f" },
    { name: "y", way: new Vector3(0, 1, 0), colour: "#2f8f4e" },
    { name: "z", way: new Vector3(0, 0, 1), colour: "#3a72c9" },
  ];
  for (const axis of axes) axis.way.applyQuaternion(inverse);
  axes.sort((p, q) => p.way.z - q.way.z);
  pen.textAlign = "center";
  for (const { name, way, colour } of axes) {
    pen.strokeStyle = colour;
    pen.lineWidth = 2;
    pen.beginPath();
    pen.moveTo(x, y);
    pen.lineTo(x + 22 * way.x, y - 22 * way.y);
    pen.stroke();
    text(pen, name, x + 30 * way.x, y - 30 * way.y, colour, true);
  }
  pen.textAlign = "start";
}

/** A wave as it is turned: an arrow along its way, thinner what it moves, and its name. */
function drawWave(pen: CanvasRenderingContext2D, over: Overlay, wave: WaveHeld, x: number, y: number) {
  const inverse = over.camera.quaternion.clone().invert();
  const seen = (of: [number, number, number], length: number): [number, number] => {
    const turned = new Vector3(...of).applyQuaternion(inverse).multiplyScalar(length);
    return [turned.x, -turned.y];
  };
  ground(pen, over, x - 35, y - 34, 70, 76);
  pen.strokeStyle = pen.fillStyle = over.ink;
  const [px, py] = seen(wave.polarisation, 20);
  pen.lineWidth = 1;
  arrow(pen, x - px, y - py, x + px, y + py, 4);
  arrow(pen, x + px, y + py, x - px, y - py, 4);
  pen.strokeStyle = pen.fillStyle = WAVE;
  const [dx, dy] = seen(wave.way, 24);
  pen.lineWidth = 2.5;
  arrow(pen, x - dx, y - dy, x + dx, y + dy, 9);
  pen.textAlign = "center";
  text(pen, wave.label, x, y + 35, over.ink);
  pen.textAlign = "start";
}

/** Flow lines as the camera sees them, with heads along each and a light edge so that they are seen on any colour. */
function drawFlow(pen: CanvasRenderingContext2D, over: Overlay, panel: Overlay["panels"][number]) {
  const seen = (at: Vector3) => {
    const { x, y, z } = at.clone().project(over.camera);
    return { x: panel.left + ((x + 1) / 2) * panel.width, y: panel.top + ((1 - y) / 2) * panel.height, before: z < 1 };
  };
  const lines = panel.flow.map((line) => line.map(seen)).filter((line) => line.every((point) => point.before));
  pen.save();
  pen.beginPath();
  pen.rect(panel.left, panel.top, panel.width, panel.height);
  pen.clip();
  for (const [colour, width, head] of [["#ffffff", 2.6, 9], [FLOW, 1.1, 8]] as const) {
    pen.strokeStyle = pen.fillStyle = colour;
    pen.lineWidth = width;
    for (const line of lines) {
      pen.beginPath();
      line.forEach((point, k) => (k ? pen.lineTo(point.x, point.y) : pen.moveTo(point.x, point.y)));
      pen.stroke();
      for (const { x, y, alongX, alongY } of headsOf(line)) arrow(pen, x - 2 * alongX * head, y - 2 * alongY * head, x, y, head);
    }
  }
  pen.restore();
}

/** Between the heads of a line, and the shortest that has one, in pixels. */
const APART = 110;
const SHORTEST = 20;

/** The places of heads on a line and its way there: evenly along it, one in its middle where it is short, none where it is too short. */
function headsOf(line: { x: number; y: number }[]) {
  const lengths = line.slice(1).map((point, k) => Math.hypot(point.x - line[k].x, point.y - line[k].y));
  const whole = lengths.reduce((sum, length) => sum + length, 0);
  const heads: { x: number; y: number; alongX: number; alongY: number }[] = [];
  if (whole < SHORTEST) return heads;
  const apart = whole / Math.max(1, Math.round(whole / APART));
  let next = apart / 2;
  lengths.forEach((length, k) => {
    const [alongX, alongY] = [(line[k + 1].x - line[k].x) / length, (line[k + 1].y - line[k].y) / length];
    for (; next <= length; next += apart) heads.push({ x: line[k].x + next * alongX, y: line[k].y + next * alongY, alongX, alongY });
    next -= length;
  });
  return heads;
}

/** A line that ends in a head, which is shorter where the line is. */
function arrow(pen: CanvasRenderingContext2D, fromX: number, fromY: number, toX: number, toY: number, head: number) {
  const [wayX, wayY] = [toX - fromX, toY - fromY];
  const length = Math.hypot(wayX, wayY);
  if (length < 1) return;
  const [x, y] = [wayX / length, wayY / length];
  const long = Math.min(head, length / 2);
  pen.beginPath();
  pen.moveTo(fromX, fromY);
  pen.lineTo(toX - long * x, toY - long * y);
  pen.stroke();
  pen.beginPath();
  pen.moveTo(toX, toY);
  pen.lineTo(toX - long * x - 0.45 * long * y, toY - long * y + 0.45 * long * x);
  pen.lineTo(toX - long * x + 0.45 * long * y, toY - long * y - 0.45 * long * x);
  pen.fill();
}
