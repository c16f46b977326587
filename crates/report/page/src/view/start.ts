// The state in which the view is first shown.
import type { Vector3 } from "three";
import type { Manifest } from "./manifest";
import type { Box } from "./part";
import type { Cut, State } from "./state";
import type { Choice } from "./values";

/** The scale at which the largest displacement is 3 % of the model. */
function easilySeen(held: Manifest, box: Box): number {
  return (0.03 * box.diagonal) / held.displacementLargest;
}

/** Scales of the displacement: none, true, and round ones past the one at which it is easily seen. */
export function scalesOf(held: Manifest, box: Box): number[] {
  const suggested = easilySeen(held, box);
  const scales = [0, 1];
  if (!Number.isFinite(suggested)) return scales;
  for (let power = 1; power <= 1e12; power *= 10) {
    for (const m of [2, 5, 10]) if (m * power <= suggested * 20) scales.push(m * power);
  }
  return scales;
}

/** Of the scales past the true one that nearest to the one at which it is easily seen; nothing without any. */
export function suggestedOf(scales: number[], held: Manifest, box: Box): number | null {
  const away = (scale: number) => Math.abs(Math.log(scale / easilySeen(held, box)));
  return scales.slice(2).reduce<number | null>((best, next) => (best === null || away(next) < away(best) ? next : best), null);
}

/** The axis along which the subject reaches through most of the model: caverns are looked at across it. */
export function alongAxis(box: Box, subject: { low: Vector3; high: Vector3 }): 0 | 1 {
  const share = [0, 1].map((k) => (subject.high.getComponent(k) - subject.low.getComponent(k)) / (box.high[k] - box.low[k] || 1));
  return share[0] > share[1] * 1.01 ? 0 : 1;
}

/** The damage, else the lining's first field, at the last time, the rock cut in the middle. */
export function firstState(held: Manifest, box: Box, fields: Choice[], along: number): State {
  const last = held.times.length - 1;
  const cut = (axis: number): Cut => ({ on: axis === along, at: box.centre[axis], keep: axis === 1 ? 1 : -1 });
  return {
    field: (fields.find((f) => f.name === "d_b_max") ?? fields.find((f) => f.name === "d_b") ?? fields[0])?.name ?? "",
    times: [0, last],
    beside: false,
    cuts: [cut(0), cut(1), cut(2)],
    cutAll: false,
    scale: 0,
    rock: "section",
    // Interfaces lie in the lining's outer face and would hide it.
    shown: held.parts.map((part) => part.kind !== "interface"),
    hidden: held.parts.map(() => new Set()),
    openings: true,
    edges: true,
    flow: true,
    colourRock: false,
    range: "all",
    own: { low: 0, high: 1 },
  };
}
