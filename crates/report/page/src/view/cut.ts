// What a plane across an axis cuts out of the hexahedra of a part.
import type { Part } from "./part";
import { gatherer, type Sheet } from "./sheet";

const EDGES = [
  [0, 1], [1, 2], [2, 3], [3, 0],
  [4, 5], [5, 6], [6, 7], [7, 4],
  [0, 4], [1, 5], [2, 6], [3, 7],
] as const;

/** The least and the largest coordinate of every cell along an axis. */
function spans(part: Part, axis: number): { low: Float32Array; high: Float32Array } {
  const low = new Float32Array(part.count).fill(Infinity);
  const high = new Float32Array(part.count).fill(-Infinity);
  for (let corner = 0; corner < part.corners; corner++) {
    for (let c = 0; c < part.count; c++) {
      const at = part.points[3 * part.cells[corner * part.count + c] + axis];
      if (at < low[c]) low[c] = at;
      if (at > high[c]) high[c] = at;
    }
  }
  return { low, high };
}

/** A function that cuts a part, remembering how far its cells reach. */
export function cutter(part: Part) {
  const reach: ({ low: Float32Array; high: Float32Array } | undefined)[] = [];
  return (axis: number, at: number, keep: 1 | -1, shown: Uint8Array | null): Sheet => {
    const gather = gatherer(part, true);
    if (part.corners === 8) {
      const { low, high } = (reach[axis] ??= spans(part, axis));
      // Where the plane runs between elements, it shows those of the side that is kept.
      for (let c = 0; c < part.count; c++) {
        const through = keep > 0 ? low[c] <= at && high[c] > at : low[c] < at && high[c] >= at;
        if (through && (!shown || shown[c])) polygon(part, c, axis, at, keep, gather);
      }
    }
    return gather.sheet();
  };
}

function polygon(part: Part, cell: number, axis: number, at: number, keep: number, gather: ReturnType<typeof gatherer>) {
  const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
  const { points } = part;
  const found: { p: number; q: number; s: number; x: number; y: number; angle: number }[] = [];
  for (const [from, to] of EDGES) {
    const p = part.cells[from * part.count + cell];
    const q = part.cells[to * part.count + cell];
    const dp = (points[3 * p + axis] - at) * keep;
    const dq = (points[3 * q + axis] - at) * keep;
    if (dp > 0 === dq > 0) continue;
    const s = dp / (dp - dq);
    const x = points[3 * p + u] + s * (points[3 * q + u] - points[3 * p + u]);
    const y = points[3 * p + v] + s * (points[3 * q + v] - points[3 * p + v]);
    // Three edges from a corner in the plane meet it at one point.
    if (found.some((f) => Math.abs(f.x - x) + Math.abs(f.y - y) < 1e-5)) continue;
    found.push({ p, q, s, x, y, angle: 0 });
  }
  if (found.length < 3) return;
  const x = found.reduce((sum, f) => sum + f.x, 0) / found.length;
  const y = found.reduce((sum, f) => sum + f.y, 0) / found.length;
  for (const f of found) f.angle = Math.atan2(f.y - y, f.x - x);
  found.sort((f, g) => f.angle - g.angle);
  gather.polygon(found.map((f) => gather.vertex(f.p, f.q, f.s, cell)));
}
