// The canvas, its renderer, and how panels share it.
import { Color, setConsoleFunction, WebGLRenderer, type PerspectiveCamera } from "three";
import type { Scene } from "three";
import { el } from "./inputs";
import { words } from "./words";

export interface Place {
  left: number;
  top: number;
  width: number;
  height: number;
}

/** The stage in the page; nothing where the browser has no graphics for it. */
export function makeStage(drawAgain: () => void) {
  const canvas = el("canvas", { tabindex: "0", role: "img", "aria-label": words.canvas });
  const context = canvas.getContext("webgl2", { antialias: true, alpha: false, powerPreference: "high-performance" });
  if (!context) return null;
  // The page's console stays empty: what goes wrong is told on the page.
  setConsoleFunction(() => {});
  const renderer = new WebGLRenderer({ canvas, context });
  renderer.autoClear = false;
  const over = el("canvas", { class: "view-over", "aria-hidden": "true" });
  const element = el("div", { class: "view-stage" }, canvas, over);
  const lost = el("p", { class: "view-message", role: "status" }, words.lost);
  canvas.addEventListener("webglcontextlost", (event) => {
    event.preventDefault();
    element.before(lost);
  });
  canvas.addEventListener("webglcontextrestored", () => {
    lost.remove();
    drawAgain();
  });

  let size = { width: 0, height: 0, fine: 1 };
  const stacked = () => size.width < 640;
  return {
    canvas,
    over,
    element,
    /** Fits the canvas to the page. */
    fit(beside: boolean) {
      const width = element.clientWidth || 600;
      const single = width < 640 ? Math.min(width, 0.7 * innerHeight) : Math.min(0.64 * width, 0.8 * innerHeight);
      const height = Math.round(Math.max(280, single) * (beside && width < 640 ? 2 : 1));
      const fine = Math.min(2, devicePixelRatio || 1);
      if (width === size.width && height === size.height && fine === size.fine) return;
      size = { width, height, fine };
      renderer.setPixelRatio(fine);
      renderer.setSize(width, height, false);
      canvas.style.height = over.style.height = `${height}px`;
      over.style.width = `${width}px`;
      over.width = Math.round(width * fine);
      over.height = Math.round(height * fine);
    },
    size: () => size,
    /** Where each panel is, in CSS pixels: beside each other, or below where the page is narrow. */
    places(count: number): Place[] {
      const { width, height } = size;
      return Array.from({ length: count }, (_, i) =>
        stacked()
          ? { left: 0, top: (i * height) / count, width, height: height / count }
          : { left: (i * width) / count, top: 0, width: width / count, height },
      );
    },
    render(scenes: Scene[], camera: PerspectiveCamera, ground: string) {
      const places = this.places(scenes.length);
      renderer.setScissorTest(true);
      renderer.setClearColor(new Color(ground));
      scenes.forEach((scene, i) => {
        const { left, top, width, height } = places[i];
        const bottom = size.height - top - height;
        renderer.setViewport(left, bottom, width, height);
        renderer.setScissor(left, bottom, width, height);
        renderer.clear();
        renderer.render(scene, camera);
      });
    },
  };
}

export type Stage = NonNullable<ReturnType<typeof makeStage>>;
