// One picture of the model: its layers with the values of one time.
import { Scene } from "three";
import type { Manifest } from "./manifest";
import { draw, type Drawn, drop, type Layer, type Paints, setMoved, setPlain, setValues } from "./paint";
import type { Part } from "./part";
import { relativeDisplacement, type Values, valuesOf } from "./values";

export interface Panel {
  scene: Scene;
  drawn: Drawn[];
  time: number;
  /** Values by part, as shown now. */
  values: (Values | null)[];
  /** Displacements by part. */
  moved: (Float32Array | null)[];
}

export const emptyPanel = (): Panel => ({ scene: new Scene(), drawn: [], time: 0, values: [], moved: [] });

/** What a panel needs of a time before it can be shown. */
export async function gather(held: Manifest, parts: Part[], needed: boolean[], moving: boolean[], field: string, time: number, deformed: boolean) {
  const [values, moved] = await Promise.all([
    Promise.all(parts.map((part, p) => (needed[p] ? valuesOf(held, part, field, time) : null))),
    Promise.all(parts.map((part, p) => (moving[p] && deformed ? relativeDisplacement(held, part, time) : null))),
  ]);
  return { time, values, moved };
}

/** Puts layers and values into the panel, keeping what it has of them. */
export function fill(panel: Panel, layers: Layer[], of: Awaited<ReturnType<typeof gather>>, colours: Part[], paint: Paints) {
  const had = new Map(panel.drawn.map((drawn) => [drawn.layer.key, drawn]));
  panel.drawn = layers.map((layer) => {
    const found = had.get(layer.key);
    if (found?.layer.sheet === layer.sheet) {
      had.delete(layer.key);
      return found;
    }
    const made = draw(layer, paint);
    panel.scene.add(made.fill, made.lines);
    return made;
  });
  for (const old of had.values()) {
    panel.scene.remove(old.fill, old.lines);
    drop(old);
  }
  Object.assign(panel, of);
  for (const drawn of panel.drawn) {
    const p = drawn.layer.sheet.part.index;
    setValues(drawn, of.values[p]);
    setPlain(drawn, !colours.includes(drawn.layer.sheet.part));
    setMoved(drawn, of.moved[p]);
  }
}
