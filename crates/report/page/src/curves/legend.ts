// The names of a panel's lines: buttons with the value at the cursor.
import type { Line, Value } from "./data";
import { shown } from "./format";
import { pen } from "./palette";
import { words } from "./words";

/** What a legend reports. */
export interface Answers {
  /** A name was chosen, alone or not. */
  toggled(name: string, alone: boolean): void;
  /** A name is pointed at, or none any more. */
  lifted(name: string | null): void;
}

/** A line's value at the cursor, and where it stands if not there. */
export interface Told {
  value: Value;
  elsewhere: string;
}

/** The legend of a panel. */
export class Legend {
  readonly element = document.createElement("div");
  private buttons: HTMLButtonElement[];
  private values: HTMLDataElement[] = [];

  constructor(private lines: Line[], colour: (line: Line) => string, answers: Answers) {
    this.element.className = "curves-legend";
    this.element.setAttribute("role", "group");
    this.buttons = lines.map((line, k) => this.entry(line, colour(line), k, answers));
    this.element.append(...this.buttons);
    this.element.addEventListener("keydown", (event) => this.moved(event));
  }

  private entry(line: Line, colour: string, k: number, answers: Answers): HTMLButtonElement {
    const button = document.createElement("button");
    button.type = "button";
    button.title = words.line(line.name);
    // One stop of the tab key a legend; arrows go on from there.
    button.tabIndex = k === 0 ? 0 : -1;
    const value = document.createElement("data");
    const name = document.createElement("span");
    name.textContent = line.name;
    button.append(swatch(line, colour), name, value);
    this.values.push(value);
    button.addEventListener("click", (event) => answers.toggled(line.name, event.shiftKey));
    for (const event of ["pointerenter", "focus"]) button.addEventListener(event, () => answers.lifted(line.name));
    for (const event of ["pointerleave", "blur"]) button.addEventListener(event, () => answers.lifted(null));
    return button;
  }

  private moved(event: KeyboardEvent): void {
    const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    const now = this.buttons.indexOf(document.activeElement as HTMLButtonElement);
    if (!step || now < 0) return;
    event.preventDefault();
    const next = this.buttons[(now + step + this.buttons.length) % this.buttons.length];
    for (const button of this.buttons) button.tabIndex = button === next ? 0 : -1;
    next.focus();
  }

  /** Says which lines are seen. */
  show(hidden: Set<string>): void {
    this.lines.forEach((line, k) => this.buttons[k].setAttribute("aria-pressed", String(!hidden.has(line.name))));
  }

  /** Writes the values at the cursor; blanks without one. */
  at(values: Told[] | null, digits: number): void {
    this.values.forEach((element, k) => {
      const { value, elsewhere } = values?.[k] ?? {};
      element.textContent = values ? shown(value, digits) + (elsewhere ? ` (${elsewhere})` : "") : "";
      element.value = value == null ? "" : String(Number(value.toPrecision(7)));
    });
  }
}

/** A piece of the line. */
function swatch(line: Line, colour: string): SVGSVGElement {
  const space = "http://www.w3.org/2000/svg";
  const drawing = document.createElementNS(space, "svg");
  drawing.setAttribute("viewBox", "0 0 18 8");
  drawing.setAttribute("aria-hidden", "true");
  const path = document.createElementNS(space, "path");
  const { width, dash } = pen(line.stroke, line.colour);
  // The class follows the page into the dark, as in the drawing.
  path.setAttribute("class", `s${line.colour % 7}`);
  path.setAttribute("stroke", colour);
  path.setAttribute("stroke-width", String(Math.max(width, 2.4)));
  if (dash) path.setAttribute("stroke-dasharray", dash.join(" "));
  path.setAttribute("d", "M0 4h18");
  drawing.append(path);
  return drawing;
}
