// What the reader chose, as plain data.
import type { Range } from "./colours";

/** A plane across an axis: what lies before it is cut away. */
export interface Cut {
  on: boolean;
  /** Coordinate, in m. */
  at: number;
  /** 1 keeps what has larger coordinates, -1 what has smaller ones. */
  keep: 1 | -1;
}

/** How the rock is drawn. */
export type RockStyle = "section" | "translucent" | "solid";

/** Whose values, and of which times, set the ends of the bar. */
export type RangeKind = "lining-all" | "lining-now" | "shown-all" | "shown-now" | "own";

export interface State {
  field: string;
  /** Left (or only) time and right time, by number. */
  times: [number, number];
  beside: boolean;
  cuts: [Cut, Cut, Cut];
  /** Whether planes cut linings and interfaces too, or the rock alone. */
  cutAll: boolean;
  scale: number;
  rock: RockStyle;
  /** By part. */
  shown: boolean[];
  hidden: Set<string>[];
  openings: boolean;
  edges: boolean;
  range: RangeKind;
  own: Range;
}
