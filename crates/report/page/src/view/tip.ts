// The value under the pointer.
import { el } from "./inputs";
import { groupsOf, type Box } from "./part";
import type { Hit } from "./pick";
import type { Stage } from "./stage";
import { figures, fixed, minus, type Shown, withUnit } from "./units";
import { words } from "./words";

/** A value with half the step of what the page holds, to the decimals that this step leaves. */
export function valueText(hit: Hit, shown: Shown): string {
  if (Number.isNaN(hit.value)) return words.noValueHere;
  if (shown.says) return shown.says(Math.round(hit.value));
  const half = hit.half * shown.factor;
  const value = hit.value * shown.factor;
  if (!(half > 0)) return withUnit(figures(value, 4), shown.unit);
  const decimals = Math.max(0, 1 - Math.floor(Math.log10(half)));
  const text = decimals > 8 || Math.abs(value) >= 1e6 ? figures(value, 4) : minus(fixed(value, decimals));
  return withUnit(words.halfLevel(text, figures(half, 2)), shown.unit);
}

/** Lines about a hit: the value, the element, its groups, where it is. */
export function hitLines(hit: Hit, label: string, shown: Shown, box: Box): string[] {
  const at = hit.place.map((x, k) => minus(fixed(x + box.centre[k], 2))).join(", ");
  const groups = groupsOf(hit.part, hit.cell);
  return [
    valueText(hit, shown),
    label,
    words.element(String(hit.part.elements[hit.cell])),
    groups.length ? groups.join(", ") : hit.part.held.name,
    `(${at}) m`,
  ];
}

/** Follows the pointer with a note, and says on a click what lies there. */
export function followPointer(stage: Stage, says: HTMLElement, linesAt: (x: number, y: number) => string[] | null) {
  const tip = el("div", { class: "view-tip", hidden: "" });
  stage.element.append(tip);
  let waiting = 0;
  const show = (x: number, y: number): string[] | null => {
    const lines = linesAt(x, y);
    tip.hidden = !lines;
    stage.canvas.style.cursor = lines ? "crosshair" : "grab";
    if (!lines) return null;
    tip.replaceChildren(el("b", {}, lines[0]), ...lines.slice(1).map((line) => el("span", {}, line)));
    const { width, height } = stage.size();
    tip.style.left = `${Math.max(4, x + 16 + tip.offsetWidth > width ? x - tip.offsetWidth - 12 : x + 16)}px`;
    tip.style.top = `${Math.max(4, Math.min(y + 14, height - tip.offsetHeight - 4))}px`;
    return lines;
  };
  const say = (x: number, y: number) => {
    const lines = show(x, y);
    if (lines) says.textContent = lines.join(" · ");
  };
  const hide = () => {
    cancelAnimationFrame(waiting);
    tip.hidden = true;
  };
  const { canvas } = stage;
  canvas.addEventListener("pointermove", (event) => {
    cancelAnimationFrame(waiting);
    if (event.buttons || event.pointerType === "touch") return hide();
    const { offsetX, offsetY } = event;
    waiting = requestAnimationFrame(() => show(offsetX, offsetY));
  });
  canvas.addEventListener("pointerleave", hide);
  canvas.addEventListener("blur", hide);
  let down = { x: 0, y: 0 };
  canvas.addEventListener("pointerdown", ({ offsetX, offsetY }) => {
    down = { x: offsetX, y: offsetY };
    canvas.focus({ preventScroll: true });
  });
  // A click that ends a turn asks for nothing.
  canvas.addEventListener("click", ({ offsetX, offsetY }) => {
    if (Math.hypot(offsetX - down.x, offsetY - down.y) < 5) say(offsetX, offsetY);
  });
  canvas.addEventListener("keydown", (event) => {
    if (event.key === "Escape") hide();
    if (event.key !== "Enter") return;
    const place = stage.places(1)[0];
    say(place.width / 2, place.height / 2);
  });
  return { hide };
}
