// Figures with curves answer to the pointer on the screen; their drawings stay for paper.
import sheet from "uplot/dist/uPlot.min.css";
import { manifest } from "../blocks";
import own from "./curves.css";
import { type Entry, numbers } from "./data";
import { Stack } from "./stack";

/** How far outside the window a figure is made ready. */
const AHEAD = "600px";

/** Makes the figures with curves answer to the pointer, each as the reader comes near. */
export function enhanceCurves(): void {
  const entries = manifest<Record<string, Entry>>("curves-data");
  if (!entries) return;
  const style = document.createElement("style");
  style.textContent = sheet + own;
  document.head.append(style);
  const near = new IntersectionObserver(
    (changes) => {
      for (const change of changes.filter((change) => change.isIntersecting)) {
        near.unobserve(change.target);
        void enhance(change.target as HTMLElement, entries);
      }
    },
    { rootMargin: AHEAD },
  );
  for (const figure of document.querySelectorAll("figure[data-curves]")) near.observe(figure);
}

async function enhance(figure: HTMLElement, entries: Record<string, Entry>): Promise<void> {
  const file = figure.dataset.curves ?? "";
  const drawing = figure.querySelector<SVGSVGElement>(":scope > svg");
  const entry = entries[file];
  if (!entry || !drawing || entry.rows < 2) return;
  try {
    const stack = new Stack(file, entry, await numbers(entry), drawing);
    figure.classList.add("answers");
    drawing.after(stack.element);
  } catch {
    // A browser that cannot unpack the numbers keeps the drawing.
  }
}
