// Blocks of numbers in the page: zlib, base64, little-endian.

/** The text of a block. */
function text(block: number): string {
  const element = document.getElementById(`block-${block}`);
  if (!element) throw new Error(`block ${block} is missing`);
  return element.textContent ?? "";
}

/** Base64 as bytes; by the browser where it can, else by a plain loop, which is many times as fast as a function for each. */
function unpacked(base64: string): Uint8Array<ArrayBuffer> {
  const own = Uint8Array as unknown as { fromBase64?: (text: string) => Uint8Array<ArrayBuffer> };
  if (own.fromBase64) return own.fromBase64(base64);
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let k = 0; k < text.length; k++) bytes[k] = text.charCodeAt(k);
  return bytes;
}

/** The bytes of a block. */
export async function bytes(block: number): Promise<ArrayBuffer> {
  const stream = new Blob([unpacked(text(block))]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).arrayBuffer();
}

/** Numbers of single precision from a block that holds their bytes in four planes. */
export async function singles(block: number): Promise<Float32Array> {
  const planes = new Uint8Array(await bytes(block));
  const count = planes.length / 4;
  const numbers = new DataView(new ArrayBuffer(planes.length));
  for (let k = 0; k < count; k++) {
    for (let plane = 0; plane < 4; plane++) numbers.setUint8(4 * k + plane, planes[plane * count + k]);
  }
  // Little-endian in the page; of whatever order here.
  return Float32Array.from({ length: count }, (_, k) => numbers.getFloat32(4 * k, true));
}

/** What a `<script type="application/json">` with this id holds; nothing without one. */
export function manifest<T>(id: string): T | undefined {
  const element = document.getElementById(id);
  return element ? (JSON.parse(element.textContent ?? "") as T) : undefined;
}
