// Labelled inputs, as plain elements.

type Child = Node | string | null;

/** An element with attributes and children. */
export function el<K extends keyof HTMLElementTagNameMap>(tag: K, attributes: Record<string, string> = {}, ...children: Child[]): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children.filter((child) => child !== null));
  return made;
}

/** A box to tick. */
export function check(label: string, on: boolean, act: (on: boolean) => void) {
  const input = el("input", { type: "checkbox" });
  input.checked = on;
  input.addEventListener("change", () => act(input.checked));
  return { row: el("label", { class: "view-check" }, input, el("span", {}, label)), input };
}

/** One of several. */
export function choice(label: string, options: [string, string][], now: string, act: (value: string) => void) {
  const input = el("select", {}, ...options.map(([value, text]) => el("option", { value }, text)));
  input.value = now;
  input.addEventListener("change", () => act(input.value));
  return { row: el("label", { class: "view-row" }, el("span", {}, label), input), input };
}

/** A slider over whole numbers, with what its place means. */
export function slider(label: string, most: number, now: number, say: (at: number) => string, act: (at: number) => void) {
  const input = el("input", { type: "range", min: "0", max: String(most), step: "1" });
  const output = el("output", {}, say(now));
  input.value = String(now);
  const tell = () => {
    output.textContent = say(Number(input.value));
    input.setAttribute("aria-valuetext", output.textContent);
  };
  tell();
  input.addEventListener("input", () => {
    tell();
    act(Number(input.value));
  });
  const set = (at: number) => {
    input.value = String(at);
    tell();
  };
  return { row: el("label", { class: "view-row view-slide" }, el("span", {}, label), input, output), input, set };
}

/** A number to type. */
export function number(label: string, act: (value: number) => void) {
  const input = el("input", { type: "number", step: "any", "aria-label": label });
  input.addEventListener("change", () => {
    if (Number.isFinite(input.valueAsNumber)) act(input.valueAsNumber);
  });
  return input;
}

export function button(label: string, act: () => void, title = "") {
  const made = el("button", { type: "button", ...(title ? { title, "aria-label": title } : {}) }, label);
  made.addEventListener("click", act);
  return made;
}

/** A group of controls that folds. */
export const fold = (title: string, open: boolean, ...children: Child[]) =>
  el("details", open ? { open: "" } : {}, el("summary", {}, title), ...children);
