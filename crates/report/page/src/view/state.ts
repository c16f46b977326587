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

/** What sets the ends of the bar: the coloured parts at all times, or at the time shown, or the reader. */
export type RangeKind = "all" | "now" | "own";

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
  /** Whether the rock takes colours too where the lining has the field: its values would span the bar. */
  colourRock: boolean;
  /** By part. */
  shown: boolean[];
  hidden: Set<string>[];
  openings: boolean;
  edges: boolean;
  /** Whether arrows show the flow of water. */
  flow: boolean;
  range: RangeKind;
  own: Range;
}
