// What the page holds of the model: the manifest beside its blocks of numbers.

/** Numbers of a block, or null where they were left out. */
export type Block = number | null;

/** A field of a part: low + (high - low) * q / 254 for a byte q; 255 where there is nothing. */
export interface FieldHeld {
  name: string;
  label: string;
  unit: string;
  low: number;
  high: number;
  at: "cells" | "points";
  blocks: Block[];
}

/** A part of the model: cells of one kind, their points, and the faces that bound it. */
export interface PartHeld {
  name: string;
  kind: "rock" | "lining" | "interface";
  groups: { name: string; block: number }[];
  points: { count: number; block: number };
  cells: { count: number; corners: 8 | 4; block: number };
  elements: number;
  faces: { count: number; block: number; kind: number };
  displacement: Block[];
  fields: FieldHeld[];
}

/** A plane wave that comes in during the earthquake. */
export interface WaveHeld {
  label: string;
  way: [number, number, number];
  polarisation: [number, number, number];
}

/** Flow lines of water, and how far behind a cut they are shown: x, y, z of the points of each, from where the water comes from, in m. */
export interface FlowHeld {
  beside: number;
  lines: number[][];
}

/** The whole model: coordinates are origin + step * u16, displacements mean + displacementStep * i16, in SI. */
export interface Manifest {
  version: 1;
  clock: "earthquake" | "stages";
  origin: [number, number, number];
  step: [number, number, number];
  times: { t: number; label: string }[];
  mean: [number, number, number][];
  displacementStep: number;
  /** The largest component of any displacement about the mean, m. */
  displacementLargest: number;
  parts: PartHeld[];
  /** Waves at angles: ways and what they move, of length 1. */
  waves: WaveHeld[];
  flows: FlowHeld[];
  /** By time, which of the flows is there. */
  flowAt: (number | null)[];
  notes: string[];
}

/** What lies beyond a face. */
export const FaceKind = { side: 0, against: 1, opening: 2 } as const;
