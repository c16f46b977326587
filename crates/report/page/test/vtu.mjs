// Field files read from their definition, by nothing of the page's or the program's own: appended raw data in blocks of zlib.
import { inflateSync } from "node:zlib";
import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";

const TYPES = { Float32: Float32Array, Float64: Float64Array, UInt8: Uint8Array, Int32: Int32Array, Int64: BigInt64Array };

/** The arrays of a file by name, those of points and of cells apart. */
export function readVtu(path) {
  const file = readFileSync(path);
  const begin = file.indexOf("_", file.indexOf('<AppendedData encoding="raw">')) + 1;
  const head = file.subarray(0, begin).toString("latin1");
  const found = { points: new Map(), cells: new Map(), unit: new Map() };
  const part = (name) => head.match(new RegExp(`<${name}>(.*?)</${name}>`, "s"))?.[1] ?? "";
  const arrays = (text, into) => {
    for (const [, attributes, inner] of text.matchAll(/<DataArray ([^>]*?)(?:\/>|>(.*?)<\/DataArray>)/gs)) {
      const of = (key) => attributes.match(new RegExp(`${key}="([^"]*)"`))?.[1];
      const bytes = unpacked(file, begin + Number(of("offset")));
      into.set(of("Name"), new TYPES[of("type")](bytes.buffer, 0, bytes.length / TYPES[of("type")].BYTES_PER_ELEMENT));
      found.unit.set(of("Name"), inner?.match(/UNITS_LABEL[^>]*>([^<]*)/)?.[1] ?? "");
    }
  };
  arrays(part("PointData"), found.points);
  arrays(part("CellData"), found.cells);
  arrays(part("Points"), found.points);
  arrays(part("Cells"), found.cells);
  return found;
}

/** An array: number of blocks, size of one, size of the last, packed sizes; then the blocks. */
function unpacked(file, at) {
  const number = (k) => Number(file.readBigUInt64LE(at + 8 * k));
  const count = number(0);
  let from = at + 8 * (3 + count);
  const blocks = Array.from({ length: count }, (_, k) => {
    const block = inflateSync(file.subarray(from, from + number(3 + k)));
    from += number(3 + k);
    return block;
  });
  // A copy of its own, so that views of any width may lie on it.
  const whole = new Uint8Array(blocks.reduce((sum, block) => sum + block.length, 0));
  blocks.reduce((offset, block) => (whole.set(block, offset), offset + block.length), 0);
  return whole;
}

/** The files that a .pvd lists, in their order. */
export function filesOf(pvd) {
  const text = readFileSync(pvd, "utf8");
  return [...text.matchAll(/file="([^"]*)"/g)].map((match) => join(dirname(pvd), match[1]));
}

/** Of each element of a file: its number, groups, corners with their middle, and its row. */
export function elements(file) {
  const points = file.points.get("Points");
  const ends = Array.from(file.cells.get("offsets"), Number);
  const corners = Array.from(file.cells.get("connectivity"), Number);
  const groups = [...file.cells.keys()].filter((name) => name.startsWith("group:"));
  return Array.from(file.cells.get("element"), Number).map((element, row) => {
    const own = corners.slice(row ? ends[row - 1] : 0, ends[row]);
    const middle = [0, 1, 2].map((axis) => own.reduce((sum, point) => sum + points[3 * point + axis], 0) / own.length);
    const inside = groups.filter((name) => file.cells.get(name)[row]).map((name) => name.slice("group:".length));
    return { element, row, groups: inside, middle, corners: own };
  });
}
