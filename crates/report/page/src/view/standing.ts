// Which cells stand at a time: stages take rock away and put lining in.
import { fieldBytes } from "./decode";
import type { Part } from "./part";

/** One byte a cell, or null where all stand; equal keys mean equal cells. */
export interface Standing {
  key: string;
  cells: Uint8Array | null;
}

const NOTHING = 255;
const ALL: Standing = { key: "", cells: null };

/** The cells of a part with values at a time, by its first field; of a time left out, those of the time before. */
export function standings(part: Part) {
  const known = new Map<number, Promise<Standing>>();
  const field = part.held.fields.find((f) => f.at === "cells") ?? part.held.fields[0];
  return async (time: number): Promise<Standing> => {
    const block = field?.blocks.slice(0, time + 1).filter((b) => b !== null).pop() ?? null;
    if (!field || block === null) return ALL;
    if (!known.has(block)) known.set(block, fieldBytes(block).then((bytes) => read(part, field.at, bytes, String(block))));
    return known.get(block)!;
  };
}

function read(part: Part, at: "cells" | "points", bytes: Uint8Array, key: string): Standing {
  if (!bytes.includes(NOTHING)) return ALL;
  const cells = new Uint8Array(part.count);
  for (let c = 0; c < part.count; c++) {
    let stands = 1;
    if (at === "cells") stands = bytes[c] === NOTHING ? 0 : 1;
    else for (let k = 0; k < part.corners; k++) if (bytes[part.cells[k * part.count + c]] === NOTHING) stands = 0;
    cells[c] = stands;
  }
  return { key, cells };
}
