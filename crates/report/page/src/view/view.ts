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

/** A section behind the page's head, where the page has none for the view. */
function ownPlace(): HTMLElement {
  const host = el("div", { id: "view" });
  const section = el("section", { id: "model-view" }, el("h2", {}, words.view), host);
  const head = document.querySelector("header");
  if (head) head.after(section);
  else document.body.prepend(section);
  return host;
}

/** Shows the model in three dimensions where the page holds it. */
export function showView(): void {
  const held = manifest<Manifest>("view-data");
  if (!held) return;
  const host = document.getElementById("view") ?? ownPlace();
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
