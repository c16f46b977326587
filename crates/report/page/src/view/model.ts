// The model on the page: from what the reader chose to a picture of it.
import { Color } from "three";
import { cameraOn, subject } from "./camera";
import { type Range, schemeOf } from "./colours";
import { codesOf, stepsOf } from "./codes";
import { AXES, controls, toolbar } from "./controls";
import { flowShown } from "./flow";
import { take, type Picked, type Show, type ViewHook } from "./hook";
import { el } from "./inputs";
import { drawnAt, layering } from "./layers";
import type { Manifest } from "./manifest";
import { drawOverlay, type Overlay } from "./overlay";
import { paints } from "./paint";
import { emptyPanel, fill, gather, type Panel } from "./panel";
import { groupsOf, loadPart, modelBox } from "./part";
import { type Hit, locate, pick } from "./pick";
import { keep, savePicture } from "./picture";
import { coloured, rangeNow, spanning } from "./span";
import type { Stage } from "./stage";
import { standings } from "./standing";
import { alongAxis, firstState, scalesOf } from "./start";
import { followPointer, hitLines, valueText } from "./tip";
import { minus, type Shown, suiting } from "./units";
import { choices, hasField } from "./values";
import { words } from "./words";

/** Loads the model, puts it into the page and draws it for the first time. */
export async function buildModel(held: Manifest, host: HTMLElement, stage: Stage, drawing: { again: () => void }): Promise<Omit<ViewHook, "ready">> {
  const box = modelBox(held);
  const parts = await Promise.all(held.parts.map((_, p) => loadPart(held, p, box)));
  const fields = choices(held);
  const first = subject(parts, box);
  const along = alongAxis(box, first);
  const scales = scalesOf(held, box);
  const state = firstState(held, box, fields, along);
  const paint = paints(box.diagonal);
  const layersOf = layering(parts, box);
  const stands = parts.map(standings);
  const spanOf = spanning(held, parts);
  const panels = [emptyPanel(), emptyPanel()];
  let range: Range = { low: 0, high: 1 };
  let seen: Range | null = null;
  let anyNothing = false;

  const field = () => fields.find((f) => f.name === state.field);
  const codes = () => codesOf(state.field);
  const shown = (): Shown => ({
    ...suiting(field()?.unit ?? "", Math.max(Math.abs(range.low), Math.abs(range.high))),
    says: codes()?.words,
  });
  const scheme = () => codes() ?? schemeOf(range);
  const timeOf = (panel: Panel) => state.times[panels.indexOf(panel)];
  const used = () => (state.beside ? panels : panels.slice(1));

  // --- from the state to the picture

  let asked = 0;
  /** Brings the picture to the state; of several asked for at once, the last one counts. */
  const refresh = async () => {
    const mine = ++asked;
    const standing = await Promise.all(used().map((panel) => Promise.all(stands.map((of) => of(timeOf(panel))))));
    if (mine !== asked) return;
    const layers = layersOf(state, standing);
    const needed = parts.map((part) => layers.flat().some((layer) => layer.sheet.part === part && layer.opacity > 0));
    const outlined = needed.map((is, p) => is || held.parts[p].kind === "rock");
    const got = await Promise.all(
      used().map((panel) => gather(held, parts, needed, outlined, state.field, timeOf(panel), state.scale > 0)),
    );
    if (mine !== asked) return;
    const colours = coloured(parts, state);
    used().forEach((panel, i) => fill(panel, layers[i], got[i], colours, paint));
    const coded = codes();
    const span = coded ? stepsOf(coded) : await spanOf(state, used());
    if (mine !== asked) return;
    range = span ?? { low: 0, high: 1 };
    if (!(range.high > range.low)) range = { low: range.low, high: range.low + (Math.abs(range.low) || 1) * 1e-6 };
    seen = rangeNow(used(), colours, state);
    anyNothing = used().some((panel) => panel.drawn.some(({ layer, level }) => layer.opacity > 0 && colours.includes(layer.sheet.part) && level.some((known, i) => i % 2 === 1 && !known)));
    paint.colours(scheme(), range);
    paint.shared.deform.value = state.scale;
    state.cuts.forEach(({ on, keep: side }, axis) => {
      paint.planes.cutAt.value.setComponent(axis, drawnAt(state, box, axis));
      paint.planes.cutKeep.value.setComponent(axis, on ? side : 0);
    });
    const { factor, unit } = shown();
    filled = true;
    form.tell({ low: range.low * factor, high: range.high * factor, unit, coded: coded !== null });
    render();
  };

  const overlay = (): Overlay => {
    const style = getComputedStyle(host);
    const colour = (name: string) => style.getPropertyValue(name).trim() || "#808080";
    const size = stage.size();
    const unit = shown();
    const slack = (range.high - range.low) / 500;
    return {
      width: size.width,
      height: size.height,
      ink: colour("--ink"),
      muted: colour("--muted"),
      paper: colour("--paper"),
      nothing: `#${new Color(colour("--paper")).lerp(new Color(colour("--ink")), 0.32).getHexString()}`,
      bar: field() && {
        range,
        scheme: scheme(),
        shown: unit,
        beyond: { below: !!seen && seen.low < range.low - slack, above: !!seen && seen.high > range.high + slack },
        nothing: anyNothing,
      } || null,
      panels: stage.places(used().length).map((place, i) => ({
        ...place,
        lines: captionOf(used()[i].time),
        flow: flowShown(held, box, state, used()[i].time),
      })),
      camera: eye.camera,
      waves: held.waves,
    };
  };
  const captionOf = (time: number): string[] => {
    const lines = [field()?.label ?? "", held.times[time].label];
    if (codes() && held.parts.some((part) => part.fields.some((f) => f.name === state.field && f.at === "points"))) lines.push(words.worstOfFace);
    if (state.scale > 0) lines.push(words.deformedBy(String(state.scale)));
    held.parts.forEach((part, p) => {
      const drawn = state.shown[p] && hasField(parts[p], state.field);
      const block = part.fields.find((f) => f.name === state.field)?.blocks[time];
      if (drawn && block === null) lines.push(words.leftOut(part.name));
      if (state.shown[p] && state.scale > 0 && part.displacement[time] === null) lines.push(words.notMoved(part.name));
    });
    return lines;
  };

  const aim = () => {
    const { width, height } = stage.places(used().length)[0];
    eye.aim(width / height);
  };
  let waiting = 0;
  let filled = false;
  const render = () => {
    cancelAnimationFrame(waiting);
    waiting = 0;
    if (!filled) return;
    const size = stage.size();
    aim();
    const over = overlay();
    paint.shared.ink.value.set(over.ink);
    paint.shared.nothing.value.set(over.nothing);
    paint.shared.plainColour.value.set(over.paper).lerp(paint.shared.ink.value, 0.13);
    stage.render(used().map((panel) => panel.scene), eye.camera, over.paper);
    const pen = stage.over.getContext("2d")!;
    pen.setTransform(size.fine, 0, 0, size.fine, 0, 0);
    pen.clearRect(0, 0, size.width, size.height);
    drawOverlay(pen, over);
  };
  const renderSoon = () => {
    if (!waiting) waiting = requestAnimationFrame(render);
  };

  // --- what lies where

  const panelAt = (x: number, y: number) => {
    const places = stage.places(used().length);
    const i = places.findIndex((p) => x >= p.left && x < p.left + p.width && y >= p.top && y < p.top + p.height);
    if (i < 0) return null;
    const { left, top, width, height } = places[i];
    return { panel: used()[i], x: (2 * (x - left)) / width - 1, y: 1 - (2 * (y - top)) / height };
  };
  const hitAt = (x: number, y: number): Hit | null => {
    const at = panelAt(x, y);
    return at && pick(at.panel, eye.camera, paint, at.x, at.y);
  };
  const linesAt = (x: number, y: number): string[] | null => {
    const hit = hitAt(x, y);
    return hit && hitLines(hit, field()?.label ?? "", shown(), box);
  };

  // --- the page

  const changed = () => {
    tip.hide();
    stage.fit(state.beside);
    refresh().catch(() => (says.textContent = words.unreadable));
  };
  const picture = () => {
    render();
    return savePicture(stage.canvas, overlay(), pictureCaption());
  };
  const pictureCaption = (): string[] => {
    const cuts = state.cuts.flatMap(({ on, at }, axis) => (on ? [words.cutNamed(AXES[axis], minus(at.toFixed(2)))] : []));
    const names = held.parts.filter((_, p) => state.shown[p]).map((part) => part.name);
    return [document.title, [field()?.label ?? "", ...used().map((p) => held.times[p.time].label), ...cuts].join(" · "), names.join(", ")];
  };
  const acts = {
    changed,
    look: (from: Parameters<typeof eye.look>[0]) => eye.look(from),
    picture: () => void picture().then((blob) => blob && keep(blob)),
    factor: () => shown().factor,
  };
  const form = controls(held, box, state, fields, scales, acts);
  const says = el("p", { class: "view-says", "aria-live": "polite" }, words.hint);
  const notes = [words.halfLevelNote, ...held.notes].map((note) => el("p", { class: "note" }, note));
  const about = el("details", { class: "view-about" }, el("summary", {}, words.about), ...notes);
  host.replaceChildren(toolbar(acts), stage.element, says, form.element, about);
  const eye = cameraOn(stage.canvas, box, first, along, renderSoon);
  const tip = followPointer(stage, says, linesAt);
  stage.fit(state.beside);
  aim();
  eye.look("oblique");
  drawing.again = renderSoon;
  new ResizeObserver(() => {
    stage.fit(state.beside);
    renderSoon();
  }).observe(stage.element);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", renderSoon);
  await refresh();

  // --- what tests ask

  const picked = (hit: Hit): Picked => ({
    part: hit.part.held.name,
    element: hit.part.elements[hit.cell],
    groups: groupsOf(hit.part, hit.cell),
    field: state.field,
    value: Number.isNaN(hit.value) ? null : hit.value,
    unit: field()?.unit ?? "",
    halfLevel: hit.half,
    text: valueText(hit, shown()),
  });
  return {
    pick: (x, y) => {
      const hit = hitAt(x, y);
      return hit && picked(hit);
    },
    show: async (what: Show) => {
      take(state, what, held.parts.map((part) => part.name));
      stage.fit(state.beside);
      if (what.look) eye.look(what.look);
      await refresh();
    },
    locate: (element) => {
      const places = stage.places(used().length);
      const { left, top, width, height } = places[places.length - 1];
      const at = locate(panels[1], eye.camera, paint, element);
      return at && { x: left + ((at[0] + 1) / 2) * width, y: top + ((1 - at[1]) / 2) * height };
    },
    fields: () => fields.map((f) => f.name),
    times: () => held.times.map((time) => time.label),
    picture,
  };
}
