// The outer faces of a part, and the sharp edges of the model.
import { FaceKind } from "./manifest";
import { FACES, type Part } from "./part";
import { gatherer, type Sheet } from "./sheet";

/** The points of a face. */
function facePoints(part: Part, cell: number, face: number): number[] {
  const corners = part.corners === 4 ? [0, 1, 2, 3] : FACES[face];
  return corners.map((corner) => part.cells[corner * part.count + cell]);
}

/** Faces between a shown and a hidden cell, as cell * 6 + face of the shown one. */
function bared(part: Part, shown: Uint8Array): number[] {
  if (part.corners === 4) return [];
  const outer = new Set(part.faces);
  const waiting = new Map<number, number>();
  const total = part.points.length / 3;
  for (let cell = 0; cell < part.count; cell++) {
    for (let face = 0; face < 6; face++) {
      if (outer.has(cell * 6 + face)) continue;
      // The least point and the one across from it tell a face from all others.
      const points = FACES[face].map((corner) => part.cells[corner * part.count + cell]);
      const least = points.indexOf(Math.min(...points));
      const key = points[least] * total + points[(least + 2) % 4];
      const other = waiting.get(key);
      if (other === undefined) waiting.set(key, cell * 6 + face);
      else if (shown[cell] === shown[Math.floor(other / 6)]) waiting.delete(key);
      else waiting.set(key, shown[cell] ? cell * 6 + face : other);
    }
  }
  return [...waiting.values()].filter((entry) => shown[Math.floor(entry / 6)]);
}

/** The faces of these kinds of the shown cells; with cells hidden, what that bares too. */
export function surface(part: Part, shown: Uint8Array | null, kinds: readonly number[]): Sheet {
  const gather = gatherer(part, false);
  const add = (entry: number) => {
    const cell = Math.floor(entry / 6);
    const points = facePoints(part, cell, entry % 6);
    gather.polygon(points.map((point) => gather.vertex(point, point, 0, cell)));
  };
  part.faces.forEach((entry, i) => {
    if (kinds.includes(part.faceKinds[i]) && (!shown || shown[Math.floor(entry / 6)])) add(entry);
  });
  if (shown && kinds.includes(FaceKind.against)) bared(part, shown).forEach(add);
  return gather.sheet();
}

/** Edges of the model's sides where they meet at more than 30 degrees or end. */
export function outline(part: Part, shown: Uint8Array | null): Sheet {
  const gather = gatherer(part, false);
  const total = part.points.length / 3;
  const met = new Map<number, { cell: number; normal: number[]; sharp: boolean; ends: [number, number] }>();
  part.faces.forEach((entry, i) => {
    const cell = Math.floor(entry / 6);
    if (part.faceKinds[i] !== FaceKind.side || (shown && !shown[cell])) return;
    const points = facePoints(part, cell, entry % 6);
    const normal = normalOf(part, points);
    points.forEach((p, j) => {
      const q = points[(j + 1) % 4];
      const key = Math.min(p, q) * total + Math.max(p, q);
      const edge = met.get(key);
      if (!edge) met.set(key, { cell, normal, sharp: true, ends: [p, q] });
      else edge.sharp = normal.reduce((sum, n, k) => sum + n * edge.normal[k], 0) < Math.cos(Math.PI / 6);
    });
  });
  for (const { cell, sharp, ends } of met.values()) {
    if (sharp) gather.polygon(ends.map((p) => gather.vertex(p, p, 0, cell)));
  }
  return gather.sheet();
}

function normalOf(part: Part, points: number[]): number[] {
  const at = (p: number, k: number) => part.points[3 * p + k];
  const u = [0, 1, 2].map((k) => at(points[2], k) - at(points[0], k));
  const v = [0, 1, 2].map((k) => at(points[3], k) - at(points[1], k));
  const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
  const length = Math.hypot(...n) || 1;
  return n.map((x) => x / length);
}
