// What tests of the page ask the view: window.tremolite.view.
import type { From } from "./camera";
import type { State } from "./state";

/** What lies at a place; the value and half a step of it in the field's SI unit. */
export interface Picked {
  part: string;
  element: number;
  groups: string[];
  field: string;
  /** Null where there is nothing. */
  value: number | null;
  unit: string;
  halfLevel: number;
  /** As the reader sees it. */
  text: string;
}

/** What to show; what is left out stays. */
export interface Show {
  field?: string;
  /** By number; shown alone, or on the right. */
  time?: number;
  left?: number;
  beside?: boolean;
  cut?: { axis: 0 | 1 | 2; at: number } | null;
  cutAll?: boolean;
  scale?: number;
  rock?: State["rock"];
  colourRock?: boolean;
  range?: State["range"];
  /** Arrows of the flow of water. */
  flow?: boolean;
  /** Where to look from. */
  look?: From;
  /** Names of the parts to show. */
  parts?: string[];
}

export interface ViewHook {
  /** Settled once the first picture stands; false where there is none. */
  ready: Promise<boolean>;
  /** What is seen at a place of the canvas, in CSS pixels from its upper left corner. */
  pick(x: number, y: number): Picked | null;
  /** Settled once the picture shows it. */
  show(what: Show): Promise<void>;
  /** Such a place at which this element is seen, in the last panel. */
  locate(element: number): { x: number; y: number } | null;
  /** Names of the fields, labels of the times. */
  fields(): string[];
  times(): string[];
  /** The picture as the button saves it. */
  picture(): Promise<Blob | null>;
}

/** Takes over what is asked for into the state. */
export function take(state: State, what: Show, parts: string[]) {
  if (what.field !== undefined) state.field = what.field;
  if (what.time !== undefined) state.times[1] = what.time;
  if (what.left !== undefined) state.times[0] = what.left;
  if (what.beside !== undefined) state.beside = what.beside;
  if (what.cut !== undefined) {
    state.cuts.forEach((cut, axis) => {
      cut.on = what.cut?.axis === axis;
      if (what.cut?.axis === axis) cut.at = what.cut.at;
    });
  }
  if (what.cutAll !== undefined) state.cutAll = what.cutAll;
  if (what.scale !== undefined) state.scale = what.scale;
  if (what.rock !== undefined) state.rock = what.rock;
  if (what.colourRock !== undefined) state.colourRock = what.colourRock;
  if (what.flow !== undefined) state.flow = what.flow;
  if (what.range !== undefined) state.range = what.range;
  if (what.parts !== undefined) state.shown = parts.map((name) => what.parts!.includes(name));
}

declare global {
  interface Window {
    tremolite?: { view?: ViewHook };
  }
}

/** Makes the hook known. */
export function offer(view: ViewHook) {
  window.tremolite = { ...window.tremolite, view };
}
