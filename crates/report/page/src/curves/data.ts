// The numbers of a figure's curves, as the page holds them.
import { singles } from "../blocks";
import { words } from "./words";

export interface Line {
  name: string;
  colour: number;
  stroke: "thin" | "broad" | "dashed";
}

export interface Panel {
  title: string;
  unit: string;
  log: boolean;
  remark: string;
  mark: { line: number; across: number; value: number } | null;
  lines: Line[];
}

/** A figure in the manifest. */
export interface Entry {
  title: string;
  across: { name: string; unit: string; log: boolean };
  panels: Panel[];
  rows: number;
  of_rows: number;
  block: number;
  across_block: number;
}

/** A number, or nothing where the curve has a gap. */
export type Value = number | null;

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

/** Unpacks the numbers of a figure. */
export async function numbers(entry: Entry): Promise<Numbers> {
  const [across, values] = await Promise.all([singles(entry.across_block), singles(entry.block)]);
  let line = 0;
  const next = (): Value[] => {
    const own = values.subarray(line * entry.rows, ++line * entry.rows);
    return Array.from(own, (x) => (Number.isFinite(x) ? x : null));
  };
  return { across: Array.from(across), panels: entry.panels.map((panel) => panel.lines.map(next)) };
}
