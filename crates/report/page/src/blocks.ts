// Blocks of numbers in the page: zlib, base64, little-endian.

/** The text of a block. */
function text(block: number): string {
  const element = document.getElementById(`block-${block}`);
  if (!element) throw new Error(`block ${block} is missing`);
  return element.textContent ?? "";
}

/** The bytes of a block. */
export async function bytes(block: number): Promise<ArrayBuffer> {
  const packed = Uint8Array.from(atob(text(block)), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
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
