// A part's geometry as arrays.
import { decodeU16, decodeU32, decodeU8 } from "./decode";
import type { Manifest, PartHeld } from "./manifest";

/** Faces of a hexahedron by its corners, outward. */
export const FACES = [
  [0, 4, 7, 3],
  [1, 2, 6, 5],
  [0, 1, 5, 4],
  [3, 7, 6, 2],
  [0, 3, 2, 1],
  [4, 5, 6, 7],
] as const;

/** Where the origin of the drawn coordinates lies and how far they reach, in m. */
export interface Box {
  centre: [number, number, number];
  low: [number, number, number];
  high: [number, number, number];
  diagonal: number;
}

/** A part that can be drawn; coordinates are relative to the model's centre, so that single precision holds them. */
export interface Part {
  held: PartHeld;
  index: number;
  points: Float32Array;
  /** Points by corner: all first corners, all second ones, … */
  cells: Uint32Array;
  count: number;
  corners: 8 | 4;
  elements: Uint32Array;
  /** cell * 6 + face, and what lies beyond it. */
  faces: Uint32Array;
  faceKinds: Uint8Array;
  /** By group, one bit a cell. */
  groups: Uint8Array[];
}

/** Whether a cell is in a group. */
export const inGroup = (part: Part, group: number, cell: number): boolean =>
  ((part.groups[group][cell >> 3] >> (cell & 7)) & 1) === 1;

/** The names of the groups that a cell is in. */
export const groupsOf = (part: Part, cell: number): string[] =>
  part.held.groups.filter((_, g) => inGroup(part, g, cell)).map((g) => g.name);

/** The box of everything, from the steps of its coordinates. */
export function modelBox(held: Manifest): Box {
  const low = held.origin;
  const high = low.map((at, k) => at + held.step[k] * 65535) as Box["high"];
  const centre = low.map((at, k) => (at + high[k]) / 2) as Box["centre"];
  return { centre, low, high, diagonal: Math.hypot(...low.map((at, k) => high[k] - at)) };
}

/** Decodes a part. */
export async function loadPart(held: Manifest, index: number, box: Box): Promise<Part> {
  const part = held.parts[index];
  const [steps, cells, elements, faces, faceKinds, ...groups] = await Promise.all([
    decodeU16(part.points.block, 3),
    decodeU32(part.cells.block, part.cells.corners),
    decodeU32(part.elements, 1),
    decodeU32(part.faces.block, 1),
    decodeU8(part.faces.kind),
    ...part.groups.map((group) => decodeU8(group.block)),
  ]);
  const count = part.points.count;
  const points = new Float32Array(3 * count);
  for (let k = 0; k < 3; k++) {
    const shift = held.origin[k] - box.centre[k];
    for (let i = 0; i < count; i++) points[3 * i + k] = shift + held.step[k] * steps[k * count + i];
  }
  const { corners } = part.cells;
  return { held: part, index, points, cells, count: part.cells.count, corners, elements, faces, faceKinds, groups };
}

/** The standing cells in none of the hidden groups, one byte a cell; nothing where all are shown. */
export function shownCells(part: Part, hidden: ReadonlySet<string>, standing: Uint8Array | null = null): Uint8Array | null {
  const of = part.held.groups.flatMap((group, g) => (hidden.has(group.name) ? [part.groups[g]] : []));
  if (of.length === 0) return standing;
  const shown = new Uint8Array(part.count);
  for (let c = 0; c < part.count; c++) {
    shown[c] = (standing && !standing[c]) || of.some((bits) => (bits[c >> 3] >> (c & 7)) & 1) ? 0 : 1;
  }
  return shown;
}
