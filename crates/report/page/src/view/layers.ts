// Which sheets a choice asks for.
import { cutter } from "./cut";
import { FaceKind } from "./manifest";
import type { Layer } from "./paint";
import { type Box, type Part, shownCells } from "./part";
import type { Sheet } from "./sheet";
import type { Standing } from "./standing";
import type { State } from "./state";
import { outline, surface } from "./surface";

/** Coordinate of a cut as drawn, relative to the model's centre. */
export const drawnAt = (state: State, box: Box, axis: number): number => state.cuts[axis].at - box.centre[axis];

/** Makes the layers of each panel from what stands in it, by part, keeping sheets that stay as they are. */
export function layering(parts: Part[], box: Box) {
  const cutters = parts.map(cutter);
  let kept = new Map<string, Sheet>();
  const layersOf = (state: State, standing: Standing[], next: Map<string, Sheet>): Layer[] => {
    const layers: Layer[] = [];
    const add = (key: string, make: () => Sheet, cut: boolean, opacity: number, lines: number) => {
      const sheet = next.get(key) ?? kept.get(key) ?? make();
      next.set(key, sheet);
      if (sheet.lines.length) layers.push({ key: `${key} ${cut} ${opacity} ${lines}`, sheet, cut, opacity, lines });
    };
    const edges = (strength: number) => (state.edges ? strength : 0);
    parts.forEach((part, p) => {
      const hidden = state.hidden[p];
      const shown = shownCells(part, hidden, standing[p].cells);
      const named = `${p} ${[...hidden].join("|")} ${standing[p].key}`;
      const rock = part.held.kind === "rock";
      const cut = rock || state.cutAll;
      if (rock) add(`${p} ${standing[p].key} outline`, () => outline(part, standing[p].cells), false, 0, 0.55);
      const faces = (kinds: number[], opacity: number, lines: number) =>
        add(`${named} faces ${kinds}`, () => surface(part, shown, kinds), cut, opacity, lines);
      if (!state.shown[p]) {
        if (state.openings) faces([FaceKind.opening], 1, edges(0.2));
        return;
      }
      if (!rock) faces([FaceKind.side, FaceKind.against, FaceKind.opening], 1, edges(0.4));
      else {
        if (state.rock === "solid") faces([FaceKind.side, FaceKind.against, FaceKind.opening], 1, edges(0.16));
        else if (state.openings) faces([FaceKind.opening, FaceKind.against], 1, edges(0.2));
        if (state.rock === "translucent") faces([FaceKind.side], 0.25, edges(0.12));
      }
      if (!cut) return;
      state.cuts.forEach(({ on, keep }, axis) => {
        if (!on) return;
        const at = drawnAt(state, box, axis);
        add(`${named} cut ${axis} ${at} ${keep}`, () => cutters[p](axis, at, keep, shown), cut, 1, edges(rock ? 0.16 : 0.4));
      });
    });
    return layers;
  };
  return (state: State, standing: Standing[][]): Layer[][] => {
    const next = new Map<string, Sheet>();
    const layers = standing.map((of) => layersOf(state, of, next));
    kept = next;
    return layers;
  };
}
