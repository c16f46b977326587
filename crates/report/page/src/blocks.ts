// Blocks of numbers in the page: zlib, base64, little-endian.

/** The texts of the page's blocks, by their number. */
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

/** What a `<script type="application/json">` with this id holds; nothing without one. */
export function manifest<T>(id: string): T | undefined {
  const element = document.getElementById(id);
  return element ? (JSON.parse(element.textContent ?? "") as T) : undefined;
}
