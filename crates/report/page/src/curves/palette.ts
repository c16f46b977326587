// The colours of the drawing that stands in the page: one place says what they are, for paper, light and dark.

/** Colours of a figure, taken from its drawing. */
export class Palette {
  /** As the drawing's own file has them, on white, whatever the screen. */
  onPaper = false;
  private known = new Map<string, string>();

  constructor(private drawing: SVGSVGElement) {
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.known.clear());
  }

  private of(what: string, property: "stroke" | "fill"): string {
    const key = `${what} ${property} ${this.onPaper}`;
    let colour = this.known.get(key);
    if (colour === undefined) {
      const element = this.drawing.querySelector(`.${what}`);
      const own = element?.getAttribute(property) ?? "#333333";
      colour = this.onPaper || !element ? own : getComputedStyle(element)[property];
      this.known.set(key, colour);
    }
    return colour;
  }

  line = (colour: number): string => this.of(`s${colour % 7}`, "stroke");
  ink = (): string => this.of("ink", "fill");
  muted = (): string => this.of("muted", "fill");
  grid = (): string => this.of("grid", "stroke");
  axis = (): string => this.of("axis", "stroke");
  paper = (): string => this.of("paper", "fill");
}

/** Width and dashes of a stroke; from the eighth colour on dashes tell colours apart. */
export function pen(stroke: "thin" | "broad" | "dashed", colour: number): { width: number; dash?: number[] } {
  const width = stroke === "broad" ? 4.2 : 1.4;
  return stroke === "dashed" || colour >= 7 ? { width, dash: [6, 3] } : { width };
}
