// Values of a field over a part at a time, held or made from the displacement.
import { codesOf } from "./codes";
import { displacementSteps, fieldBytes } from "./decode";
import type { FieldHeld, Manifest } from "./manifest";
import type { Range } from "./colours";
import type { Part } from "./part";
import { words } from "./words";

/** A field that can be chosen, of all parts that have it. */
export interface Choice {
  name: string;
  label: string;
  unit: string;
}

/** Values in SI by cell or by point, NaN where there is nothing, and how far each may be from what was computed. */
export interface Values {
  at: "cells" | "points";
  array: Float32Array;
  half: number;
}

/** Names of what is made from the displacement here. */
export const MADE = ["|u - mean|", "|u|"] as const;
const isMade = (name: string): boolean => (MADE as readonly string[]).includes(name);

/** What can be chosen, the lining's fields first. */
export function choices(held: Manifest): Choice[] {
  const found = new Map<string, Choice>();
  const order = { lining: 0, interface: 1, rock: 2 };
  for (const part of [...held.parts].sort((p, q) => order[p.kind] - order[q.kind])) {
    for (const { name, label, unit } of part.fields) if (!found.has(name)) found.set(name, { name, label, unit });
  }
  if (held.displacementStep > 0) {
    found.set(MADE[0], { name: MADE[0], label: words.relativeDisplacement, unit: "m" });
    found.set(MADE[1], { name: MADE[1], label: words.totalDisplacement, unit: "m" });
  }
  return [...found.values()];
}

const fieldOf = (part: Part, name: string): FieldHeld | undefined => part.held.fields.find((f) => f.name === name);

/** Whether a part has this field at some time. */
export const hasField = (part: Part, name: string): boolean =>
  isMade(name) ? part.held.displacement.some((block) => block !== null) : fieldOf(part, name) !== undefined;

/** Displacement relative to the mean motion, in m, three numbers a point; nothing where none is held. */
export async function relativeDisplacement(held: Manifest, part: Part, time: number): Promise<Float32Array | null> {
  const block = part.held.displacement[time] ?? null;
  if (block === null || !held.displacementStep) return null;
  const steps = await displacementSteps(block);
  const count = steps.length / 3;
  const out = new Float32Array(3 * count);
  for (let k = 0; k < 3; k++) {
    for (let i = 0; i < count; i++) out[3 * i + k] = held.displacementStep * steps[k * count + i];
  }
  return out;
}

/** A field's values; nothing where the part has none at this time. */
export async function valuesOf(held: Manifest, part: Part, name: string, time: number): Promise<Values | null> {
  if (isMade(name)) {
    const u = await relativeDisplacement(held, part, time);
    if (!u) return null;
    const [x, y, z] = name === MADE[1] ? held.mean[time] : [0, 0, 0];
    const array = new Float32Array(u.length / 3);
    for (let i = 0; i < array.length; i++) array[i] = Math.hypot(u[3 * i] + x, u[3 * i + 1] + y, u[3 * i + 2] + z);
    return { at: "points", array, half: (Math.sqrt(3) / 2) * held.displacementStep };
  }
  const field = fieldOf(part, name);
  const block = field?.blocks[time] ?? null;
  if (!field || block === null) return null;
  const level = (field.high - field.low) / 254;
  // Codes are whole, so what is held is exact once rounded.
  if (codesOf(name)) {
    const code = Float32Array.from({ length: 256 }, (_, q) => (q === 255 ? NaN : Math.round(field.low + q * level)));
    const codes = Float32Array.from(await fieldBytes(block), (q) => code[q]);
    return { at: "cells", array: field.at === "cells" ? codes : worst(part, codes), half: 0 };
  }
  const value = Float32Array.from({ length: 256 }, (_, q) => (q === 255 ? NaN : field.low + q * level));
  const array = Float32Array.from(await fieldBytes(block), (q) => value[q]);
  return { at: field.at, array, half: level / 2 };
}

/** By cell the largest code of its points: between two codes there is none that could be drawn. */
function worst(part: Part, codes: Float32Array): Float32Array {
  return Float32Array.from({ length: part.count }, (_, c) => {
    let most = NaN;
    for (let k = 0; k < part.corners; k++) {
      const code = codes[part.cells[k * part.count + c]];
      if (!(most >= code)) most = Number.isNaN(code) ? most : code;
    }
    return most;
  });
}

/** The least and the largest of the values over the shown cells. */
export function rangeOf(part: Part, values: Values, shown: Uint8Array | null): Range | null {
  let low = Infinity;
  let high = -Infinity;
  const take = (value: number) => {
    if (value < low) low = value;
    if (value > high) high = value;
  };
  for (let c = 0; c < part.count; c++) {
    if (shown && !shown[c]) continue;
    if (values.at === "cells") take(values.array[c]);
    else for (let k = 0; k < part.corners; k++) take(values.array[part.cells[k * part.count + c]]);
  }
  return low <= high ? { low, high } : null;
}

/** The range of a field over all times of these parts, as held; of what is made here, by going through all times. */
export async function rangeOverTimes(held: Manifest, parts: Part[], name: string): Promise<Range | null> {
  const ranges: (Range | null)[] = [];
  for (const part of parts) {
    if (!isMade(name)) {
      ranges.push(fieldOf(part, name) ?? null);
      continue;
    }
    for (let time = 0; time < held.times.length; time++) {
      const values = await valuesOf(held, part, name, time);
      ranges.push(values && rangeOf(part, values, null));
    }
  }
  return union(ranges);
}

/** What covers all of these. */
export function union(ranges: (Range | null)[]): Range | null {
  const some = ranges.filter((range) => range !== null);
  if (some.length === 0) return null;
  return { low: Math.min(...some.map((r) => r.low)), high: Math.max(...some.map((r) => r.high)) };
}
