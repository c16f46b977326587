// Tables of comma-separated numbers.

/** Column by name; units in square brackets are left out of names, and kept beside. */
export function table(text) {
  const [head, ...rows] = text.trim().split("\n");
  const heads = [...head.matchAll(/("(?:[^"]|"")*"|[^,]*)(?:,|$)/g)].map(([, name]) => name.replace(/^"|"$/g, "").replaceAll('""', '"'));
  const numbers = rows.map((row) => row.split(",").map(Number));
  const columns = new Map();
  heads.slice(0, numbers[0].length).forEach((name, k) => {
    const [, bare, unit] = name.match(/^(.*?)(?: \[(.*)\])?$/);
    columns.set(bare, { unit: unit ?? "", values: numbers.map((row) => row[k]) });
  });
  return columns;
}

/** What a display unit is in SI. */
export const SI = { m: 1, mm: 1e-3, "µm": 1e-6, "m/s": 1, "mm/s": 1e-3, "m/s²": 1, MPa: 1e6, kPa: 1e3, Pa: 1, J: 1, kJ: 1e3, MJ: 1e6, s: 1 };

/** Whether two numbers agree to the five digits that curves hold. */
export const agree = (a, b) => Math.abs(a - b) <= 1e-5 * Math.max(Math.abs(a), Math.abs(b)) + 1e-30;
