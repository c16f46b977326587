// Which flow lines of water a choice shows.
import { Vector3 } from "three";
import { drawnAt } from "./layers";
import type { Manifest } from "./manifest";
import type { Box } from "./part";
import type { State } from "./state";

/** What of the lines is shown at a time, piece by piece, relative to the model's centre. Where planes cut, what lies beside them on the side that is kept, as on a section. */
export function flowShown(held: Manifest, box: Box, state: State, time: number): Vector3[][] {
  const number = held.flowAt[time] ?? null;
  if (!state.flow || number === null) return [];
  const { beside, lines } = held.flows[number];
  const cuts = state.cuts.flatMap(({ on, keep }, axis) => (on ? [{ axis, keep, at: drawnAt(state, box, axis) }] : []));
  const isShown = (at: Vector3) => {
    const behind = cuts.map((cut) => (at.getComponent(cut.axis) - cut.at) * cut.keep);
    return behind.every((depth) => depth >= 0) && (!cuts.length || behind.some((depth) => depth <= beside));
  };
  const shown: Vector3[][] = [];
  for (const line of lines) {
    let piece: Vector3[] = [];
    let last: Vector3 | null = null;
    for (let k = 0; k < line.length; k += 3) {
      const at = new Vector3(...[0, 1, 2].map((axis) => line[k + axis] - box.centre[axis]));
      if (last && isShown(last.clone().add(at).multiplyScalar(0.5))) {
        if (!piece.length) shown.push((piece = [last]));
        piece.push(at);
      } else {
        piece = [];
      }
      last = at;
    }
  }
  return shown;
}
