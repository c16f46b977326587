// The colours of figures: those of the drawings, which the page's style changes in the dark.

/** As in the drawings' own files; lines by Okabe and Ito (2008). */
const PAPER: Record<string, string> = {
  s0: "#0072B2", s1: "#D55E00", s2: "#009E73", s3: "#333333", s4: "#CC79A7", s5: "#E69F00", s6: "#56B4E9",
  ink: "#1f2933", muted: "#5b6773", grid: "#e2e6ea", axis: "#8b95a1", paper: "#ffffff",
};

/** Colours of a figure. */
export class Palette {
  /** As the drawing's own file has them, on white, whatever the screen. */
  onPaper = false;
  private known = new Map<string, string>();
  /** Elements of the drawings' classes, of which the page's style can be asked. */
  readonly probe = document.createElementNS("http://www.w3.org/2000/svg", "svg");

  constructor() {
    this.probe.setAttribute("class", "curves-probe");
    for (const [name, colour] of Object.entries(PAPER)) {
      const path = document.createElementNS(this.probe.namespaceURI, "path") as SVGPathElement;
      path.setAttribute("class", name);
      path.setAttribute("stroke", colour);
      path.setAttribute("fill", colour);
      this.probe.append(path);
    }
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.known.clear());
  }

  private of(what: string, property: "stroke" | "fill"): string {
    const key = `${what} ${property} ${this.onPaper}`;
    let colour = this.known.get(key);
    if (colour === undefined) {
      const element = this.probe.querySelector(`.${what}`);
      // Only what stands in the page has a style.
      colour = this.onPaper || !element?.isConnected ? PAPER[what] : getComputedStyle(element)[property];
      if (element?.isConnected || this.onPaper) this.known.set(key, colour);
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
