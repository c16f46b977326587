// The view of the model, where the page holds one and the browser can draw it.
import { manifest } from "../blocks";
import { offer, type ViewHook } from "./hook";
import { el } from "./inputs";
import type { Manifest } from "./manifest";
import { buildModel } from "./model";
import { makeStage } from "./stage";
import css from "./view.css";
import { words } from "./words";

const NOTHING: Omit<ViewHook, "ready"> = {
  pick: () => null,
  locate: () => null,
  fields: () => [],
  times: () => [],
  show: async () => {},
  picture: async () => null,
};

/** Shows the model in three dimensions where the page holds it. */
export function showView(): void {
  const host = document.getElementById("view");
  const held = manifest<Manifest>("view-data");
  if (!host || !held) return;
  document.head.append(el("style", {}, css));
  host.classList.add("view");
  const tell = (text: string) => host.replaceChildren(el("p", { class: "view-message", role: "status" }, text));
  const drawing = { again: () => {} };
  const stage = makeStage(() => drawing.again());
  if (!stage || typeof DecompressionStream === "undefined") {
    tell(words.noGraphics);
    offer({ ...NOTHING, ready: Promise.resolve(false) });
    return;
  }
  tell(words.loading);
  const made = buildModel(held, host, stage, drawing);
  const ready = made.then(
    (view) => {
      offer({ ...view, ready });
      return true;
    },
    () => {
      tell(words.unreadable);
      return false;
    },
  );
  offer({ ...NOTHING, ready });
}
