// Units as the page writes them (MPa, mm), and numbers to go with them.

/** A value in SI times `factor` is a number of `unit`. */
export interface Shown {
  factor: number;
  unit: string;
  /** What a value means, where it is a code. */
  says?: (value: number) => string;
}

// As the page's other figures take them: the size in SI from which on it serves, its factor, its name.
const LADDERS: Record<string, [number, number, string][]> = {
  m: [[1, 1, "m"], [1e-3, 1e3, "mm"], [1e-6, 1e6, "µm"], [1e-9, 1e9, "nm"]],
  "m/s": [[0.1, 1, "m/s"], [1e-4, 1e3, "mm/s"], [1e-7, 1e6, "µm/s"]],
  Pa: [[1e9, 1e-9, "GPa"], [1e5, 1e-6, "MPa"], [1e2, 1e-3, "kPa"], [0.1, 1, "Pa"]],
};

/** The unit that suits sizes up to the largest; a power of ten where none does. */
export function suiting(unit: string, largest: number): Shown {
  const step = LADDERS[unit]?.find(([from]) => largest >= from);
  if (step && largest * step[1] < 1e5) return { factor: step[1], unit: step[2] };
  if (!(largest > 0) || !Number.isFinite(largest) || (largest >= 1e-2 && largest < 1e5)) return { factor: 1, unit };
  const power = 3 * Math.floor(Math.log10(largest) / 3 + 1e-9);
  return { factor: 10 ** -power, unit: `×10${superscript(power)} ${unit}`.trim() };
}

/** A number to so many figures, without an exponent where it can be read without one. */
export function figures(value: number, count: number): string {
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size < 1e-4 || size >= 1e6) {
    const [digits, power] = value.toExponential(count - 1).split("e");
    return `${minus(digits)}×10${superscript(Number(power))}`;
  }
  const decimals = Math.max(0, count - 1 - Math.floor(Math.log10(size)));
  return minus(value.toFixed(Math.min(decimals, 8)));
}

/** To so many decimals, and no minus before nothing but zeros. */
export function fixed(value: number, decimals: number): string {
  const text = value.toFixed(decimals);
  return Number(text) === 0 ? text.replace("-", "") : text;
}

/** With a true minus sign. */
export const minus = (text: string): string => text.replace("-", "−");

const superscript = (power: number): string =>
  [...String(power)].map((c) => (c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(c)])).join("");

/** A number with its unit. */
export const withUnit = (number: string, unit: string): string => (unit ? `${number}\u00a0${unit}` : number);
