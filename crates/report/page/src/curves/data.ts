// The numbers of a figure's curves, as the page holds them.
import { singles } from "../blocks";
import { words } from "./words";

export interface Line {
  name: string;
  colour: number;
  stroke: "thin" | "broad" | "dashed";
  /** Whether its points are drawn too. */
  points: boolean;
}

/** A place along the abscissa that has a name; its start, centre or end stands there. */
export interface Rule {
  across: number;
  name: string;
  side: "start" | "center" | "end";
}

export interface Panel {
  title: string;
  unit: string;
  log: boolean;
  /** The ends of the upright axis, where they do not follow the values. */
  ends: [number, number] | null;
  remark: string;
  mark: { line: number; across: number; value: number } | null;
  lines: Line[];
}

/** A figure in the manifest. */
export interface Entry {
  title: string;
  /** Above all panels; may be empty. */
  heading: string;
  across: { name: string; unit: string; log: boolean };
  panels: Panel[];
  /** Panels beside each other. */
  abreast: number;
  rules: Rule[];
  rows: number;
  of_rows: number;
  block: number;
  across_block: number;
}

/** A number; null where the curve has a gap, undefined where the row is another curve's and this one goes on. */
export type Value = number | null | undefined;

/** The numbers of a figure: the abscissa, and of each panel's lines. */
export interface Numbers {
  across: number[];
  panels: Value[][][];
}

/** A quantity with its unit in round brackets. */
export function labelled(name: string, unit: string): string {
  return unit ? `${name} (${unit})` : name;
}

/** The name of the abscissa. */
export function acrossName(entry: Entry): string {
  return entry.across.name || words.time;
}

/** The row of a line that is nearest to this one, where this one is another line's. */
export function ownRow(line: Value[], row: number): number {
  for (let away = 0; away < line.length; away++) {
    if (row - away >= 0 && line[row - away] !== undefined) return row - away;
    if (row + away < line.length && line[row + away] !== undefined) return row + away;
  }
  return row;
}

/** Unpacks the numbers of a figure. */
export async function numbers(entry: Entry): Promise<Numbers> {
  const [across, values] = await Promise.all([singles(entry.across_block), singles(entry.block)]);
  let line = 0;
  const next = (): Value[] => {
    const own = values.subarray(line * entry.rows, ++line * entry.rows);
    return Array.from(own, (x) => (Number.isNaN(x) ? null : Number.isFinite(x) ? x : undefined));
  };
  return { across: Array.from(across), panels: entry.panels.map((panel) => panel.lines.map(next)) };
}
