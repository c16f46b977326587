// Numbers as the page writes them.

/** To so many figures, with a true minus; a dash where there is none. */
export function shown(value: number | null | undefined, digits = 4): string {
  if (value == null) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  const sign = value < 0 ? "−" : "";
  if (size >= 1e6 || size < 1e-4) return sign + powered(size, digits);
  const decimals = Math.max(0, digits - 1 - Math.floor(Math.log10(size)));
  return sign + size.toFixed(decimals);
}

function powered(size: number, digits: number): string {
  const [mantissa, power] = size.toExponential(digits - 1).split("e");
  return `${mantissa} × 10${raised(Number(power))}`;
}

function raised(power: number): string {
  const digits = [...String(Math.abs(power))].map((d) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(d)]).join("");
  return (power < 0 ? "⁻" : "") + digits;
}

/** Ticks of an axis: as many decimals as tell neighbours apart; powers of ten on a logarithmic axis that goes far. */
export function ticks(values: (number | null)[], log: boolean): string[] {
  const there = values.filter((x): x is number => x != null);
  const step = there.length > 1 ? Math.min(...there.slice(1).map((x, k) => Math.abs(x - there[k]))) : Math.abs(there[0] ?? 1);
  const decimals = decimalsOf(step || 1);
  const far = log && there.some((x) => x < 0.99e-3 || x > 1.01e5);
  const plain = (x: number): string => {
    if (x === 0) return "0";
    const size = Math.abs(x);
    const sign = x < 0 ? "−" : "";
    if (size !== 1 && (far || size >= 1e6 || size < 1e-4)) return sign + powered(size, 2).replace(/\.0(?= )/, "").replace(/^1 × /, "");
    return sign + (log ? String(Number(size.toPrecision(6))) : size.toFixed(decimals));
  };
  return values.map((x) => (x == null ? "" : plain(x)));
}

/** With how many decimals a step and its multiples are written: 2.5 has one. */
function decimalsOf(step: number): number {
  const most = 12;
  for (let decimals = 0; decimals < most; decimals++) {
    const scaled = step * 10 ** decimals;
    if (scaled > 0.99 && Math.abs(scaled - Math.round(scaled)) < 1e-6 * scaled) return decimals;
  }
  return most;
}
