// The controls of the view: they change the state and say so.
import type { From } from "./camera";
import { button, check, choice, el, fold, number, slider } from "./inputs";
import type { Manifest } from "./manifest";
import type { Box } from "./part";
import { suggestedOf } from "./start";
import type { RangeKind, RockStyle, State } from "./state";
import type { Choice } from "./values";
import { words } from "./words";

export const AXES = ["x", "y", "z"] as const;

/** What the controls ask the view to do. */
export interface Acts {
  changed(): void;
  look(from: From): void;
  picture(): void;
  /** The unit's factor of the field shown, to read limits that are typed. */
  factor(): number;
}

/** Stages rather than times are called so. */
const timeWords = (held: Manifest) =>
  held.clock === "stages"
    ? { one: words.stage, left: words.stageLeft, right: words.stageRight }
    : { one: words.time, left: words.timeLeft, right: words.timeRight };

/** Buttons over the picture. */
export function toolbar(acts: Acts): HTMLElement {
  const looks = (Object.keys(words.lookFrom) as (keyof typeof words.lookFrom)[]).map((from) => button(words.lookFrom[from], () => acts.look(from)));
  return el(
    "div",
    { class: "view-tools", role: "toolbar", "aria-label": words.viewButtons },
    ...looks,
    button(words.whole, () => acts.look("whole")),
    button(words.picture, () => acts.picture()),
  );
}

/** All others, below the picture. */
export function controls(held: Manifest, box: Box, state: State, fields: Choice[], scales: number[], acts: Acts) {
  const wide = matchMedia("(min-width: 700px)").matches;
  const { changed } = acts;

  const field = choice(words.field, fields.map((f) => [f.name, f.label]), state.field, (name) => {
    state.field = name;
    changed();
  });
  const range = choice(words.range, Object.entries(words.ranges), state.range, (kind) => {
    state.range = kind as RangeKind;
    changed();
  });
  const limit = (label: string, end: "low" | "high") =>
    number(label, (value) => {
      state.own = { ...state.own, [end]: value / acts.factor() };
      state.range = range.input.value = "own";
      changed();
    });
  const low = limit(words.lowest, "low");
  const high = limit(words.highest, "high");
  const unit = el("span", { class: "view-unit" });
  const rock = check(words.colourRock, state.colourRock, (on) => {
    state.colourRock = on;
    changed();
  });

  const names = timeWords(held);
  const times = [0, 1].map((side) =>
    slider(names.one, held.times.length - 1, state.times[side], (at) => held.times[at].label, (at) => {
      state.times[side] = at;
      changed();
    }),
  );
  const asBeside = () => {
    times[0].row.hidden = !state.beside;
    times[0].row.firstElementChild!.textContent = names.left;
    times[1].row.firstElementChild!.textContent = state.beside ? names.right : names.one;
  };
  asBeside();
  const beside = check(words.beside, state.beside, (on) => {
    state.beside = on;
    asBeside();
    changed();
  });
  let playing = 0;
  const play = button(words.play, () => {
    if (playing) {
      clearInterval(playing);
      playing = 0;
    } else {
      playing = window.setInterval(() => {
        state.times[1] = (state.times[1] + 1) % held.times.length;
        times[1].set(state.times[1]);
        changed();
      }, 500);
    }
    play.textContent = playing ? words.stop : words.play;
  });
  const both = held.parts.some((part) => part.kind === "rock") && held.parts.some((part) => part.kind !== "rock");
  const many = held.times.length > 1;

  const scale = slider(words.deformation, scales.length - 1, scales.indexOf(state.scale), (at) => `×\u00a0${scales[at]}`, (at) => {
    state.scale = scales[at];
    changed();
  });

  const seen = suggestedOf(scales, held, box);
  const easily = seen === null ? null : button(words.suggested(String(seen)), () => {
    state.scale = seen;
    scale.set(scales.indexOf(seen));
    changed();
  }, words.suggestedHint);

  const limits = el("div", { class: "view-row view-limits" }, el("span", {}, words.lowest), low, el("span", {}, words.highest), high, unit);
  const cuts = cutControls(box, state, changed);
  const shown = shownControls(held, state, changed);
  return {
    element: el(
      "form",
      { class: "view-controls" },
      fold(words.field, true, field.row, range.row, limits, both ? rock.row : null),
      fold(
        names.one,
        true,
        ...(many ? [times[0].row, times[1].row, el("div", { class: "view-row" }, play), beside.row] : []),
        held.displacementStep > 0 ? scale.row : null,
        held.displacementStep > 0 && easily ? el("div", { class: "view-row view-indented" }, easily) : null,
        held.displacementStep > 0 ? el("p", { class: "note" }, words.deformationNote) : null,
      ),
      fold(words.cuts, wide, ...cuts.rows),
      fold(words.shown, wide, ...shown.rows),
    ),
    /** Shows what the state has become, and the limits of the bar in its unit. */
    tell(bar: { low: number; high: number; unit: string; coded: boolean }) {
      // Codes have their colours once and for all.
      range.row.hidden = limits.hidden = bar.coded;
      field.input.value = state.field;
      shown.tell();
      range.input.value = state.range;
      beside.input.checked = state.beside;
      rock.input.checked = state.colourRock;
      asBeside();
      times.forEach((time, side) => time.set(state.times[side]));
      cuts.tell();
      scale.set(scales.indexOf(state.scale));
      for (const [input, value] of [[low, bar.low], [high, bar.high]] as const) {
        if (document.activeElement !== input) input.value = rounded(value, bar.high - bar.low);
      }
      unit.textContent = bar.unit;
    },
  };
}

/** A limit to a thousandth of the span. */
const rounded = (value: number, span: number): string =>
  String(Number(value.toFixed(Math.min(12, Math.max(0, 3 - Math.floor(Math.log10(span)))))));

function cutControls(box: Box, state: State, changed: () => void) {
  const steps = 240;
  const tells: (() => void)[] = [];
  const rows = AXES.map((axis, k) => {
    const cut = state.cuts[k];
    const span = box.high[k] - box.low[k];
    const on = check(axis, cut.on, (is) => {
      cut.on = is;
      changed();
    });
    on.input.setAttribute("aria-label", words.cutAxis(axis));
    const place = el("input", { type: "range", min: "0", max: String(steps), step: "1", "aria-label": words.cutAt(axis) });
    const exact = number(words.cutAt(axis), (value) => set(Math.min(box.high[k], Math.max(box.low[k], value))));
    const show = () => {
      place.value = String(((cut.at - box.low[k]) / (span || 1)) * steps);
      place.setAttribute("aria-valuetext", `${cut.at.toFixed(1)} m`);
      exact.value = String(Number(cut.at.toFixed(2)));
      on.input.checked = cut.on;
    };
    const set = (at: number) => {
      cut.at = at;
      cut.on = true;
      show();
      changed();
    };
    place.addEventListener("input", () => set(box.low[k] + (span * Number(place.value)) / steps));
    show();
    tells.push(show);
    const turn = button("⇄", () => {
      cut.keep = cut.keep > 0 ? -1 : 1;
      changed();
    }, words.turnCut(axis));
    return el("div", { class: "view-row view-cut" }, on.row, place, exact, el("span", {}, "m"), turn);
  });
  const all = check(words.cutAll, state.cutAll, (on) => {
    state.cutAll = on;
    changed();
  });
  tells.push(() => (all.input.checked = state.cutAll));
  return { rows: [...rows, all.row], tell: () => tells.forEach((show) => show()) };
}

function shownControls(held: Manifest, state: State, changed: () => void) {
  const tells: (() => void)[] = [];
  const parts = held.parts.map((part, p) => {
    const shown = check(part.name, state.shown[p], (on) => {
      state.shown[p] = on;
      changed();
    });
    tells.push(() => (shown.input.checked = state.shown[p]));
    if (part.groups.length < 2) return shown.row;
    const groups = part.groups.map(({ name }) =>
      check(name, true, (on) => {
        if (on) state.hidden[p].delete(name);
        else state.hidden[p].add(name);
        changed();
      }),
    );
    return el(
      "div",
      { class: "view-part" },
      shown.row,
      fold(words.groups(part.name), false, el("p", { class: "note" }, words.groupsNote), ...groups.map((group) => group.row)),
    );
  });
  const style = choice(words.rockStyle, Object.entries(words.rockStyles), state.rock, (value) => {
    state.rock = value as RockStyle;
    changed();
  });
  const openings = check(words.openings, state.openings, (on) => {
    state.openings = on;
    changed();
  });
  const edges = check(words.edges, state.edges, (on) => {
    state.edges = on;
    changed();
  });
  const flow = check(words.flow, state.flow, (on) => {
    state.flow = on;
    changed();
  });
  const rock = held.parts.some((part) => part.kind === "rock");
  tells.push(() => (style.input.value = state.rock), () => (flow.input.checked = state.flow));
  return { rows: [...parts, ...(rock ? [style.row] : []), openings.row, edges.row, ...(held.flows.length ? [flow.row] : [])], tell: () => tells.forEach((show) => show()) };
}
