// Colours by value: one map for sizes and one for values of either sign. Both are graded evenly for the eye and are
// told apart by the colour-blind.

import type { Codes } from "./codes";

/** How a range takes its colours: light at zero, and dark at its far end or at both; or by the kind of a code. */
export type Scheme = "rising" | "falling" | "diverging" | Codes;

/** The ends of the bar, in SI. */
export interface Range {
  low: number;
  high: number;
}

// magma (N. Smith and S. van der Walt, matplotlib, CC0), from light to dark and without its black end, as in the
// page's figures.
const MAGMA = [
  [252, 253, 191], [254, 207, 146], [254, 159, 109], [247, 112, 92], [222, 73, 104],
  [183, 55, 121], [140, 41, 129], [100, 26, 128], [59, 15, 112],
];

/** Lightness falls evenly from the middle to both ends, blue below and red above (OKLab hues 255 and 30 degrees). */
function diverging(t: number): number[] {
  const away = Math.abs(2 * t - 1);
  const hue = ((t < 0.5 ? 255 : 30) * Math.PI) / 180;
  const lightness = 0.97 - 0.57 * away;
  const chroma = 0.17 * Math.min(1, 1.25 * away) * (1 - 0.25 * away);
  return oklab(lightness, chroma * Math.cos(hue), chroma * Math.sin(hue));
}

/** sRGB of a colour in OKLab (B. Ottosson, 2020). */
function oklab(lightness: number, a: number, b: number): number[] {
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  const linear = [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ];
  return linear.map((x) => {
    const c = Math.min(1, Math.max(0, x));
    return 255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055);
  });
}

function magma(t: number): number[] {
  const at = t * (MAGMA.length - 1);
  const i = Math.min(Math.floor(at), MAGMA.length - 2);
  return MAGMA[i].map((c, k) => c + (at - i) * (MAGMA[i + 1][k] - c));
}

/** Values of both signs that matter stand out about zero; others by their size. */
export function schemeOf({ low, high }: Range): Scheme {
  if (low < 0 && high > 0 && Math.min(-low, high) > 0.04 * Math.max(-low, high)) return "diverging";
  return high > -low ? "rising" : "falling";
}

/** Where a value lies in the map, 0 to 1, as `scale * value + shift`. */
export function placing(scheme: Scheme, { low, high }: Range): { scale: number; shift: number } {
  if (scheme === "diverging") return { scale: 0.5 / Math.max(-low, high), shift: 0.5 };
  const scale = 1 / (high - low || 1);
  return scheme === "falling" ? { scale: -scale, shift: high * scale } : { scale, shift: -low * scale };
}

/** 256 colours of a map, red green blue alpha. */
export function table(scheme: Scheme): Uint8Array {
  const out = new Uint8Array(1024);
  for (let i = 0; i < 256; i++) {
    const colour = colourOf(scheme, i / 255);
    out.set([...colour.map(Math.round), 255], 4 * i);
  }
  return out;
}

function colourOf(scheme: Scheme, t: number): number[] {
  if (typeof scheme === "string") return scheme === "diverging" ? diverging(t) : magma(t);
  const code = Math.min(scheme.most, Math.floor(t * (scheme.most + 1)));
  return scheme.kinds[scheme.kind(code)].colour;
}
