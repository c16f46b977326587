// Fields whose values are codes: their words, and a colour for each kind of them.
import { words } from "./words";

/** What the codes of a field are. */
export interface Codes {
  /** The largest code. */
  most: number;
  /** Name and colour of each kind, as the bar lists them. */
  kinds: { name: string; colour: [number, number, number] }[];
  /** Which kind a code is of. */
  kind(code: number): number;
  /** A code in words. */
  words(code: number): string;
}

/** Of pairs of an interface, from sound to bad. */
const PAIRS: Codes = {
  most: 3,
  kinds: (
    [[221, 225, 230], [146, 190, 222], [240, 162, 62], [178, 34, 44]] as [number, number, number][]
  ).map((colour, k) => ({ name: words.pairs[k], colour })),
  kind: (code) => code,
  words: (code) => words.pairs[code] ?? String(code),
};

/** Flags of all points of an element: 1 and 2 yield now in shear and in tension, 4 and 8 did before. Colours as in the figures. */
const PLASTIC: Codes = {
  most: 15,
  kinds: (
    [[221, 225, 230], [229, 138, 74], [74, 144, 200], [142, 74, 158]] as [number, number, number][]
  ).map((colour, k) => ({ name: words.plasticKinds[k], colour })),
  kind: (flags) => (flags & 5 ? 1 : 0) + (flags & 10 ? 2 : 0),
  words: (flags) => {
    const said = words.plasticFlags.filter((_, bit) => flags & (1 << bit));
    return said.length ? said.join(words.and) : words.plasticKinds[0];
  },
};

/** Which way the widest crack of an element runs: those across bars in two blues, one parallel to the wall in red. */
const CRACKS: Codes = {
  most: 4,
  kinds: (
    [[221, 225, 230], [31, 101, 168], [120, 178, 214], [200, 60, 50], [150, 150, 110]] as [number, number, number][]
  ).map((colour, k) => ({ name: words.cracks[k], colour })),
  kind: (code) => code,
  words: (code) => words.cracks[code] ?? String(code),
};

/** The codes of a field; nothing where it holds sizes. */
export function codesOf(field: string): Codes | null {
  if (field === "plastic_state") return PLASTIC;
  if (field === "crack_direction") return CRACKS;
  return field === "state" ? PAIRS : null;
}

/** The range that gives each code a step of equal width. */
export const stepsOf = ({ most }: Codes) => ({ low: -0.5, high: most + 0.5 });
