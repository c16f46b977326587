// Numbers of a logarithmic axis.

/** Where they may stand within a power of ten, from few to many; the first that gives enough is taken. */
const WITHIN = [[1], [1, 2, 5], [1, 2, 3, 4, 5, 6, 7, 8, 9]];

/** About `wanted` round values from `low` to `high`: powers of ten, between them where there is room, evenly spaced in a short stretch. */
export function marks(low: number, high: number, wanted: number): number[] {
  const from = Math.floor(Math.log10(low) + 1e-9);
  const to = Math.ceil(Math.log10(high) - 1e-9);
  const inside = (x: number): boolean => x >= low * (1 - 1e-9) && x <= high * (1 + 1e-9);
  for (const parts of WITHIN) {
    const every = Math.max(1, Math.ceil((to - from) / (1.4 * wanted)));
    const found: number[] = [];
    for (let power = from; power <= to; power++) {
      // As a decimal text, so that 0.2 is 0.2 and no sum that nearly is.
      if (power % every === 0) found.push(...parts.map((part) => Number(`${part}e${power}`)).filter(inside));
    }
    if (every > 1 || (found.length > 1 && found.length >= 0.5 * wanted)) return found;
  }
  const step = 10 ** Math.floor(Math.log10((high - low) / 2));
  const first = Math.ceil(low / step - 1e-9);
  const rows = Math.floor(high / step + 1e-9) - first + 1;
  return Array.from({ length: rows }, (_, k) => Number(((first + k) * step).toPrecision(12)));
}
