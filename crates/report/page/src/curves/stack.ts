// A figure's panels one above the other, with one cursor, one stretch of the abscissa and one choice of lines.
import type uPlot from "uplot";
import { save } from "../save";
import { csv } from "./csv";
import { acrossName, type Entry, type Line, labelled, type Numbers, ownRow, type Value } from "./data";
import { shown } from "./format";
import { Legend, type Told } from "./legend";
import { Palette } from "./palette";
import { picture } from "./picture";
import { place, plot } from "./plot";
import { words } from "./words";

/** One panel on the page. */
interface Pane {
  element: HTMLElement;
  plot: uPlot;
  legend: Legend;
}

/** The panels of a figure. */
export class Stack {
  readonly element = div("curves");
  private panes: Pane[] = [];
  private hidden = new Set<string>();
  private grid = div("curves-grid");
  /** The names of all panels, where they stand once. */
  private names?: Legend;
  private range: [number, number];
  private palette: Palette;
  private readout = document.createElement("output");
  private whole = button(words.whole, words.wholeHint, () => this.enlarge(...this.ends));
  /** Whether it is on the screen; what is not need not follow the cursor. */
  private seen = true;

  constructor(private file: string, private entry: Entry, private numbers: Numbers, private drawing: SVGSVGElement) {
    this.palette = new Palette();
    this.range = this.ends;
    this.grid.style.setProperty("--abreast", String(entry.abreast));
    this.grid.classList.toggle("abreast", entry.abreast > 1);
    this.element.append(this.palette.probe, this.bar(), this.heading(), this.grid);
    entry.panels.forEach((_, k) => this.panes.push(this.pane(k)));
    this.grid.append(...this.panes.map(({ element }) => element));
    this.element.append(this.below());
    this.element.setAttribute("role", "group");
    this.element.setAttribute("aria-label", drawing.querySelector("title")?.textContent ?? entry.title);
    this.follow();
    this.choose();
  }

  private get ends(): [number, number] {
    const { across } = this.numbers;
    return [across[0], across[across.length - 1]];
  }

  private bar(): HTMLElement {
    const hint = document.createElement("span");
    hint.className = "curves-hint";
    hint.textContent = words.hint;
    this.whole.disabled = true;
    const name = this.file.replace(/\.svg$/, "");
    const numbers = button("CSV", words.csv, () => {
      save(`${name}.csv`, new Blob(["\ufeff", csv(this.entry, this.numbers)], { type: "text/csv" }));
    });
    const image = button("PNG", words.png, async () => {
      const { entry, numbers, palette, hidden, range } = this;
      const content = await picture({ entry, numbers, palette, hidden, range });
      if (content) save(`${name}.png`, content);
    });
    const bar = div("curves-bar");
    bar.append(this.readout, hint, this.whole, numbers, image);
    return bar;
  }

  private heading(): HTMLElement {
    const heading = div("curves-heading");
    const title = document.createElement("b");
    title.textContent = this.entry.heading;
    heading.append(title);
    heading.hidden = !this.entry.heading;
    // Panels beside each other have the same names, which stand above them once; below each are its values alone.
    if (this.entry.abreast > 1) {
      this.names = this.legend(this.entry.panels[0].lines);
      heading.append(this.names.element);
    }
    return heading;
  }

  private legend(lines: Line[]): Legend {
    const { palette } = this;
    palette.onPaper = true;
    const legend = new Legend(lines, (line) => palette.line(line.colour), {
      toggled: (name, alone) => this.toggle(name, alone),
      lifted: (name) => this.lift(name),
    });
    palette.onPaper = false;
    return legend;
  }

  private pane(k: number): Pane {
    const { entry, numbers, palette } = this;
    const panel = entry.panels[k];
    const values = numbers.panels[k];
    const legend = this.legend(panel.lines);
    const made = plot({
      panel,
      palette,
      values,
      ...place(entry, k),
      across: numbers.across,
      logAcross: entry.across.log,
      rules: entry.rules,
      width: this.width / entry.abreast,
      magnified: 1,
      shared: { key: `curves ${entry.across.name} ${entry.across.unit}`, listens: () => this.seen },
      onCursor: (row) => {
        legend.at(row == null ? null : values.map((line) => this.told(line, row)), entry.abreast > 1 ? 3 : 4);
        if (k === 0) this.read(row);
      },
      onRange: (min, max) => this.enlarge(min, max),
    });
    if (k === 0) this.keys(made);
    const heading = div("curves-heading");
    const title = document.createElement("b");
    title.textContent = labelled(panel.title, panel.unit);
    const remark = document.createElement("span");
    remark.textContent = panel.remark;
    heading.append(title, remark);
    const element = div("curves-panel");
    element.append(heading, legend.element, made.root);
    return { element, plot: made, legend };
  }

  private below(): HTMLElement {
    const { entry } = this;
    const below = div("curves-below");
    const count = (n: number): string => String(n).replace(/\B(?=(\d{3})+$)/g, "\u202f");
    if (entry.of_rows > entry.rows) below.append(words.thinned(count(entry.rows), count(entry.of_rows)));
    const name = document.createElement("span");
    name.textContent = labelled(acrossName(entry), entry.across.unit);
    below.append(name);
    return below;
  }

  /** What stands at the cursor along the abscissa. */
  private read(row: number | null): void {
    const { across } = this.entry;
    const at = row == null ? "" : `${acrossName(this.entry)} ${shown(this.numbers.across[row])}\u00a0${across.unit}`;
    this.readout.textContent = at;
  }

  /** What a line has at a row; of a row of other lines alone, its nearest own with its place. */
  private told(line: Value[], row: number): Told {
    const own = ownRow(line, row);
    const place = `${shown(this.numbers.across[own])}\u00a0${this.entry.across.unit}`.trim();
    return { value: line[own], elsewhere: own === row ? "" : place };
  }

  private toggle(name: string, alone: boolean): void {
    const names = new Set(this.entry.panels.flatMap((panel) => panel.lines.map((line) => line.name)));
    const others = [...names].filter((other) => other !== name);
    if (alone) {
      const already = !this.hidden.has(name) && others.every((other) => this.hidden.has(other));
      this.hidden = new Set(already ? [] : others);
    } else if (!this.hidden.delete(name)) {
      this.hidden.add(name);
    }
    this.choose();
  }

  private choose(): void {
    this.names?.show(this.hidden);
    this.panes.forEach(({ plot, legend }, k) => {
      this.entry.panels[k].lines.forEach((line, i) => {
        const show = !this.hidden.has(line.name);
        if (plot.series[i + 1].show !== show) plot.setSeries(i + 1, { show });
      });
      legend.show(this.hidden);
    });
  }

  private lift(name: string | null): void {
    this.panes.forEach(({ plot }, k) => {
      const line = this.entry.panels[k].lines.findIndex((line) => line.name === name && !this.hidden.has(line.name));
      plot.setSeries(line < 0 ? null : line + 1, { focus: line >= 0 });
    });
  }

  /** Shows a stretch of the abscissa in all panels. */
  private enlarge(min: number, max: number): void {
    this.range = [min, max];
    const [first, last] = this.ends;
    this.whole.disabled = min <= first && max >= last;
    for (const { plot } of this.panes) {
      if (plot.scales.x.min !== min || plot.scales.x.max !== max) plot.setScale("x", { min, max });
    }
  }

  /** The cursor and the stretch by the keyboard, from the first panel. */
  private keys(plot: uPlot): void {
    const { across } = this.numbers;
    plot.over.tabIndex = 0;
    plot.over.setAttribute("role", "slider");
    plot.over.setAttribute("aria-label", words.axes(this.entry.title));
    plot.over.setAttribute("aria-valuemin", String(across[0]));
    plot.over.setAttribute("aria-valuemax", String(across[across.length - 1]));
    plot.over.setAttribute("aria-valuenow", String(across[0]));
    plot.over.addEventListener("keydown", (event) => {
      const far = event.shiftKey ? 20 : 1;
      const row = Math.min(across.length - 1, Math.max(0, plot.cursor.idx ?? 0));
      const [min, max] = this.range;
      const half = { "+": (max - min) / 4, "=": (max - min) / 4, "-": max - min }[event.key];
      if (event.key === "ArrowLeft" || event.key === "ArrowRight") {
        const next = Math.min(across.length - 1, Math.max(0, row + (event.key === "ArrowLeft" ? -far : far)));
        this.point(next);
      } else if (half !== undefined) {
        const [first, last] = this.ends;
        const middle = plot.cursor.idx == null ? (min + max) / 2 : across[row];
        this.enlarge(Math.max(first, middle - half), Math.min(last, middle + half));
        this.point(row);
      } else if (event.key === "Escape") {
        this.enlarge(...this.ends);
      } else return;
      event.preventDefault();
    });
  }

  private point(row: number): void {
    const x = this.numbers.across[row];
    for (const { plot } of this.panes) plot.setCursor({ left: plot.valToPos(x, "x"), top: 0 });
    this.panes[0].plot.over.setAttribute("aria-valuenow", String(x));
    this.panes[0].plot.over.setAttribute("aria-valuetext", this.readout.textContent ?? "");
  }

  private get width(): number {
    return this.element.clientWidth || this.drawing.parentElement?.clientWidth || 940;
  }

  /** Follows the window, the light, and whether it is on the screen. */
  private follow(): void {
    new ResizeObserver(() => {
      // Nothing is as wide as nothing while the page is printed.
      if (!this.element.clientWidth) return;
      for (const { plot, element } of this.panes) {
        const width = element.clientWidth;
        if (plot.width !== width) plot.setSize({ width, height: plot.height });
      }
    }).observe(this.element);
    new IntersectionObserver((entries) => {
      this.seen = entries[entries.length - 1].isIntersecting;
    }).observe(this.element);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
      for (const { plot } of this.panes) plot.redraw(false, true);
    });
  }
}

function div(name: string): HTMLDivElement {
  const element = document.createElement("div");
  element.className = name;
  return element;
}

function button(text: string, title: string, act: () => void): HTMLButtonElement {
  const element = document.createElement("button");
  element.type = "button";
  element.textContent = text;
  element.title = title;
  element.setAttribute("aria-label", title);
  element.addEventListener("click", act);
  return element;
}
