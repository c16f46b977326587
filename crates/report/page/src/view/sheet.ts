// A sheet of triangles over a part: its outer faces, or what a plane cuts.
import type { Part } from "./part";

/** Vertices lie on a line between two points of the part (the same one twice, at a corner) and belong to a cell. */
export interface Sheet {
  part: Part;
  a: Uint32Array;
  b: Uint32Array;
  /** How far from a to b. */
  s: Float32Array;
  cell: Uint32Array;
  triangles: Uint32Array;
  lines: Uint32Array;
  /** A cut is flat and shows colours as they are on the bar. */
  flat: boolean;
}

/** Gathers vertices of polygons, each of one cell. */
export function gatherer(part: Part, flat: boolean) {
  const a: number[] = [];
  const b: number[] = [];
  const s: number[] = [];
  const cell: number[] = [];
  const triangles: number[] = [];
  const lines: number[] = [];
  const drawn = new Set<number>();
  const total = part.points.length / 3;
  // A vertex for telling edges that were drawn already: only corners can be shared by number.
  const edge = (from: number, to: number) => {
    const [p, q] = a[from] < a[to] ? [a[from], a[to]] : [a[to], a[from]];
    const key = p * total + q;
    if (!flat && drawn.has(key)) return;
    if (!flat) drawn.add(key);
    lines.push(from, to);
  };
  return {
    vertex(from: number, to: number, at: number, of: number): number {
      a.push(from);
      b.push(to);
      s.push(at);
      cell.push(of);
      return a.length - 1;
    },
    polygon(vertices: number[]) {
      for (let i = 2; i < vertices.length; i++) triangles.push(vertices[0], vertices[i - 1], vertices[i]);
      vertices.forEach((v, i) => edge(v, vertices[(i + 1) % vertices.length]));
    },
    sheet: (): Sheet => ({
      part,
      a: Uint32Array.from(a),
      b: Uint32Array.from(b),
      s: Float32Array.from(s),
      cell: Uint32Array.from(cell),
      triangles: Uint32Array.from(triangles),
      lines: Uint32Array.from(lines),
      flat,
    }),
  };
}

/** Three numbers a point, brought to the vertices of a sheet. */
export function spread(sheet: Sheet, points: Float32Array): Float32Array {
  const { a, b, s } = sheet;
  const out = new Float32Array(3 * a.length);
  for (let i = 0; i < a.length; i++) {
    for (let k = 0; k < 3; k++) {
      const from = points[3 * a[i] + k];
      out[3 * i + k] = from + s[i] * (points[3 * b[i] + k] - from);
    }
  }
  return out;
}
