// Blocks decoded into arrays, and those of times kept for a while.
import { bytes } from "../blocks";

type Whole = Uint16Array | Int16Array | Uint32Array;

/** Sums up differences row by row; what overflows wraps as it did when they were taken. */
function summed<T extends Whole>(array: T, rows: number): T {
  const count = array.length / rows;
  for (let row = 0; row < rows; row++) {
    for (let i = row * count + 1; i < (row + 1) * count; i++) array[i] += array[i - 1];
  }
  return array;
}

export const decodeU8 = async (block: number) => new Uint8Array(await bytes(block));
export const decodeU16 = async (block: number, rows: number) => summed(new Uint16Array(await bytes(block)), rows);
export const decodeU32 = async (block: number, rows: number) => summed(new Uint32Array(await bytes(block)), rows);
const decodeI16 = async (block: number) => summed(new Int16Array(await bytes(block)), 3);

/** Bytes of decoded fields and displacements that are kept at most. */
const KEPT = 192e6;

/** A decoder that remembers what was asked for last. */
function remembering<T extends Uint8Array | Int16Array>(decode: (block: number) => Promise<T>) {
  const kept = new Map<number, Promise<T>>();
  let size = 0;
  return (block: number): Promise<T> => {
    const found = kept.get(block);
    if (found) {
      kept.delete(block);
      kept.set(block, found);
      return found;
    }
    const made = decode(block);
    kept.set(block, made);
    made.then(
      async (array) => {
        size += array.byteLength;
        for (const [old, of] of kept) {
          if (size <= KEPT || old === block) break;
          kept.delete(old);
          size -= (await of).byteLength;
        }
      },
      () => kept.delete(block),
    );
    return made;
  };
}

/** The bytes of a field at a time. */
export const fieldBytes = remembering(decodeU8);
/** The displacement at a time: all x, all y, all z. */
export const displacementSteps = remembering(decodeI16);
