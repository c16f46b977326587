// What lies under the pointer, found by following its ray through the triangles that are drawn.
import { type Camera, Vector3 } from "three";
import { type Part } from "./part";
import type { Drawn, Paints } from "./paint";
import type { Panel } from "./panel";

export interface Hit {
  part: Part;
  cell: number;
  /** Where the point was at rest, relative to the model's centre. */
  place: [number, number, number];
  /** In SI; NaN where there is nothing. */
  value: number;
  half: number;
}

/** The nearest drawn triangle at a place of the panel, -1 to 1 both ways. */
export function pick(panel: Panel, camera: Camera, paint: Paints, x: number, y: number): Hit | null {
  const near = new Vector3(x, y, -1).unproject(camera);
  const far = new Vector3(x, y, 1).unproject(camera);
  const way = far.clone().sub(near).normalize();
  const deform = paint.shared.deform.value;
  let best = Infinity;
  let found: { drawn: Drawn; at: number; u: number; v: number } | null = null;
  for (const drawn of panel.drawn) {
    if (drawn.layer.opacity < 1) continue;
    const { triangles } = drawn.layer.sheet;
    const { place, moved } = drawn;
    const gone = cutAway(drawn.layer.cut, paint);
    for (let t = 0; t < triangles.length; t += 3) {
      const [i, j, k] = [3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2]];
      const ax = place[i] + deform * moved[i], ay = place[i + 1] + deform * moved[i + 1], az = place[i + 2] + deform * moved[i + 2];
      const bx = place[j] + deform * moved[j] - ax, by = place[j + 1] + deform * moved[j + 1] - ay, bz = place[j + 2] + deform * moved[j + 2] - az;
      const cx = place[k] + deform * moved[k] - ax, cy = place[k + 1] + deform * moved[k + 1] - ay, cz = place[k + 2] + deform * moved[k + 2] - az;
      // Möller and Trumbore (1997).
      const px = way.y * cz - way.z * cy, py = way.z * cx - way.x * cz, pz = way.x * cy - way.y * cx;
      const det = bx * px + by * py + bz * pz;
      if (det === 0) continue;
      const sx = near.x - ax, sy = near.y - ay, sz = near.z - az;
      const u = (sx * px + sy * py + sz * pz) / det;
      if (u < 0 || u > 1) continue;
      const qx = sy * bz - sz * by, qy = sz * bx - sx * bz, qz = sx * by - sy * bx;
      const v = (way.x * qx + way.y * qy + way.z * qz) / det;
      if (v < 0 || u + v > 1) continue;
      const along = (cx * qx + cy * qy + cz * qz) / det;
      if (along < 0 || along >= best) continue;
      const mix = (axis: number) => place[i + axis] + u * (place[j + axis] - place[i + axis]) + v * (place[k + axis] - place[i + axis]);
      if (gone(mix)) continue;
      best = along;
      found = { drawn, at: t, u, v };
    }
  }
  return found && hitOf(panel, found);
}

function cutAway(cut: boolean, paint: Paints): (coordinate: (axis: number) => number) => boolean {
  if (!cut) return () => false;
  const keep = paint.planes.cutKeep.value.toArray();
  const at = paint.planes.cutAt.value.toArray();
  const gap = paint.shared.cutGap.value;
  return (coordinate) => keep.some((side, axis) => side !== 0 && side * (coordinate(axis) - at[axis]) < -gap);
}

function hitOf(panel: Panel, { drawn, at, u, v }: { drawn: Drawn; at: number; u: number; v: number }): Hit {
  const { sheet } = drawn.layer;
  const [i, j, k] = sheet.triangles.subarray(at, at + 3);
  const mix = (of: (vertex: number) => number) => of(i) + u * (of(j) - of(i)) + v * (of(k) - of(i));
  const place = [0, 1, 2].map((axis) => mix((n) => drawn.place[3 * n + axis])) as Hit["place"];
  const known = [i, j, k].every((n) => drawn.level[2 * n + 1] === 1);
  const value = known ? mix((n) => drawn.level[2 * n]) : NaN;
  return { part: sheet.part, cell: sheet.cell[i], place, value, half: panel.values[sheet.part.index]?.half ?? 0 };
}

/** A place of the panel, -1 to 1 both ways, at which a cell of this element number is seen. */
export function locate(panel: Panel, camera: Camera, paint: Paints, element: number): [number, number] | null {
  const deform = paint.shared.deform.value;
  for (const drawn of panel.drawn) {
    const { part, cell, triangles } = drawn.layer.sheet;
    if (drawn.layer.opacity < 1) continue;
    for (let t = 0; t < triangles.length; t += 3) {
      if (part.elements[cell[triangles[t]]] !== element) continue;
      const middle = new Vector3();
      for (let n = t; n < t + 3; n++) {
        const i = triangles[n];
        middle.add(new Vector3().fromArray(drawn.place, 3 * i).addScaledVector(new Vector3().fromArray(drawn.moved, 3 * i), deform));
      }
      const { x, y } = middle.divideScalar(3).project(camera);
      if (Math.abs(x) > 1 || Math.abs(y) > 1) continue;
      const hit = pick(panel, camera, paint, x, y);
      if (hit && hit.part === part && part.elements[hit.cell] === element) return [x, y];
    }
  }
  return null;
}
