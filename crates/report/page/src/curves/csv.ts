// The numbers of a figure as comma-separated values.
import { acrossName, type Entry, type Numbers, type Value } from "./data";

/** `name [unit]`, as in the result files; in quotes where it must be. */
function header(name: string, unit: string): string {
  const text = unit ? `${name} [${unit}]` : name;
  return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/** Curves hold five digits, their abscissa seven. */
function number(value: Value): string {
  return value == null ? "" : String(Number(value.toPrecision(7)));
}

/** All rows of a figure, in its units. */
export function csv(entry: Entry, { across, panels }: Numbers): string {
  const several = entry.panels.length > 1;
  const heads = entry.panels.flatMap((panel) =>
    panel.lines.map((line) => header(several && line.name ? `${panel.title}: ${line.name}` : line.name || panel.title, panel.unit)),
  );
  const columns = panels.flat();
  const rows = across.map((x, row) => [number(x), ...columns.map((column) => number(column[row]))].join(","));
  return [[header(acrossName(entry), entry.across.unit), ...heads].join(","), ...rows, ""].join("\n");
}
