// The range that the bar spans.
import type { Range } from "./colours";
import type { Manifest } from "./manifest";
import type { Panel } from "./panel";
import { type Part, shownCells } from "./part";
import type { State } from "./state";
import { hasField, rangeOf, rangeOverTimes, union } from "./values";

/** The parts that take colours: those seen that have the field, the rock among them where asked for or alone. */
export function coloured(parts: Part[], state: State): Part[] {
  const able = parts.filter((part, p) => (state.shown[p] || state.openings) && hasField(part, state.field));
  const others = able.filter((part) => part.held.kind !== "rock");
  return others.length && !state.colourRock ? others : able;
}

/** The range shown now by these parts in all panels. */
export function rangeNow(panels: Panel[], parts: Part[], state: State): Range | null {
  return union(
    panels.flatMap((panel) =>
      parts.map((part) => {
        const values = panel.values[part.index];
        return values ? rangeOf(part, values, shownCells(part, state.hidden[part.index])) : null;
      }),
    ),
  );
}

/** A function for the ends of the bar that remembers what took going through all times. */
export function spanning(held: Manifest, parts: Part[]) {
  const known = new Map<string, Promise<Range | null>>();
  return async (state: State, panels: Panel[]): Promise<Range | null> => {
    if (state.range === "own") return state.own;
    const of = coloured(parts, state);
    if (state.range === "now") return rangeNow(panels, of, state);
    const key = `${state.field} ${of.map((part) => part.index)}`;
    if (!known.has(key)) known.set(key, rangeOverTimes(held, of, state.field));
    return known.get(key)!;
  };
}
