// Which arrows of the flow of water a choice shows.
import { Vector3 } from "three";
import { drawnAt } from "./layers";
import type { Manifest } from "./manifest";
import type { Box } from "./part";
import type { State } from "./state";

/** Tails and heads at a time, relative to the model's centre. Where planes cut, what lies beside them on the side that is kept, as on a section. */
export function flowShown(held: Manifest, box: Box, state: State, time: number): [Vector3, Vector3][] {
  const number = held.flowAt[time] ?? null;
  if (!state.flow || number === null) return [];
  const { side, arrows } = held.flows[number];
  const cuts = state.cuts.flatMap(({ on, keep }, axis) => (on ? [{ axis, keep, at: drawnAt(state, box, axis) }] : []));
  const shown: [Vector3, Vector3][] = [];
  for (const [x, y, z, ...way] of arrows) {
    const at = new Vector3(x - box.centre[0], y - box.centre[1], z - box.centre[2]);
    const behind = cuts.map((cut) => (at.getComponent(cut.axis) - cut.at) * cut.keep);
    if (behind.some((depth) => depth < 0) || (cuts.length && !behind.some((depth) => depth <= side))) continue;
    const half = new Vector3(...way).multiplyScalar(0.5);
    shown.push([at.clone().sub(half), at.add(half)]);
  }
  return shown;
}
