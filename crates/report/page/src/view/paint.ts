// How sheets are painted: colours by value, cut away before the planes, moved by the displacement.
import {
  BufferAttribute, BufferGeometry, Color, DataTexture, DoubleSide, LinearFilter, LineSegments, Mesh, ShaderMaterial, Vector3,
} from "three";
import { placing, type Range, type Scheme, table } from "./colours";
import { type Sheet, spread } from "./sheet";
import type { Values } from "./values";

const VERTEX = `
attribute vec3 moved;
attribute vec2 level;
uniform float deform;
varying vec3 vPlace;
varying vec3 vView;
varying vec2 vLevel;
void main() {
  vPlace = position;
  vLevel = level;
  vec4 seen = modelViewMatrix * vec4(position + deform * moved, 1.0);
  vView = seen.xyz;
  gl_Position = projectionMatrix * seen;
}`;

// Planes cut where the points were at rest, so that the same elements are seen at all times.
const CUT = `
uniform vec3 cutAt;
uniform vec3 cutKeep;
uniform float cutGap;
varying vec3 vPlace;
void cut() {
  if (any(lessThan(cutKeep * (vPlace - cutAt), vec3(-cutGap)))) discard;
}`;

const FILL = `${CUT}
uniform sampler2D map;
uniform float placeScale;
uniform float placeShift;
uniform vec3 nothing;
uniform vec3 plainColour;
uniform float plain;
uniform float lit;
uniform float opacity;
varying vec3 vView;
varying vec2 vLevel;
void main() {
  cut();
  float place = clamp(placeScale * vLevel.x + placeShift, 0.0, 1.0);
  vec3 colour = vLevel.y > 0.999 ? texture2D(map, vec2((255.0 * place + 0.5) / 256.0, 0.5)).rgb : nothing;
  colour = mix(colour, plainColour, plain);
  vec3 normal = normalize(cross(dFdx(vView), dFdy(vView)));
  float light = mix(1.0, 0.84 + 0.16 * abs(normal.z), lit);
  gl_FragColor = vec4(colour * light, opacity);
}`;

const LINE = `${CUT}
uniform vec3 ink;
uniform float opacity;
void main() {
  cut();
  gl_FragColor = vec4(ink, opacity);
}`;

/** What all sheets share; a value set here shows with the next picture. */
export function paints(diagonal: number) {
  const map = new DataTexture(table("rising"), 256, 1);
  map.magFilter = map.minFilter = LinearFilter;
  const shared = {
    map: { value: map },
    placeScale: { value: 1 },
    placeShift: { value: 0 },
    deform: { value: 0 },
    nothing: { value: new Color() },
    ink: { value: new Color() },
    plainColour: { value: new Color() },
    cutGap: { value: 1e-5 * diagonal },
  };
  const planes = { cutAt: { value: new Vector3() }, cutKeep: { value: new Vector3() } };
  const none = { cutAt: { value: new Vector3() }, cutKeep: { value: new Vector3() } };
  let scheme: Scheme = "rising";
  return {
    shared,
    planes,
    colours(next: Scheme, range: Range) {
      if (next !== scheme) {
        scheme = next;
        map.image.data!.set(table(scheme));
      }
      map.needsUpdate = true;
      const { scale, shift } = placing(scheme, range);
      shared.placeScale.value = scale;
      shared.placeShift.value = shift;
    },
    fill: (cut: boolean, flat: boolean, opacity: number, behind: boolean) =>
      new ShaderMaterial({
        uniforms: { ...shared, ...(cut ? planes : none), lit: { value: flat ? 0 : 1 }, plain: { value: 0 }, opacity: { value: opacity } },
        vertexShader: VERTEX,
        fragmentShader: FILL,
        side: DoubleSide,
        transparent: opacity < 1,
        depthWrite: opacity === 1,
        // Room for the lines in front; and the rock's walls lie behind the lining that leans on them.
        polygonOffset: true,
        polygonOffsetFactor: behind ? 2 : 1,
        polygonOffsetUnits: behind ? 2 : 1,
      }),
    lines: (cut: boolean, opacity: number) =>
      new ShaderMaterial({
        uniforms: { ...shared, ...(cut ? planes : none), opacity: { value: opacity } },
        vertexShader: VERTEX,
        fragmentShader: LINE,
        transparent: true,
        depthWrite: false,
      }),
  };
}

export type Paints = ReturnType<typeof paints>;

/** How a sheet is to be drawn. */
export interface Layer {
  key: string;
  sheet: Sheet;
  cut: boolean;
  /** 0 draws the lines alone. */
  opacity: number;
  lines: number;
}

/** A sheet in the scene, with the arrays that its values go to. */
export interface Drawn {
  layer: Layer;
  place: Float32Array;
  moved: Float32Array;
  level: Float32Array;
  fill: Mesh;
  lines: LineSegments;
}

/** Makes a layer ready to be drawn. */
export function draw(layer: Layer, paint: Paints): Drawn {
  const { sheet, cut, opacity } = layer;
  const place = spread(sheet, sheet.part.points);
  const moved = new Float32Array(place.length);
  const level = new Float32Array((2 * place.length) / 3);
  const attributes = {
    position: new BufferAttribute(place, 3),
    moved: new BufferAttribute(moved, 3),
    level: new BufferAttribute(level, 2),
  };
  const geometry = (index: Uint32Array) => {
    const made = new BufferGeometry();
    for (const [name, attribute] of Object.entries(attributes)) made.setAttribute(name, attribute);
    made.setIndex(new BufferAttribute(index, 1));
    return made;
  };
  const fill = new Mesh(geometry(sheet.triangles), paint.fill(cut, sheet.flat, opacity, sheet.part.held.kind === "rock"));
  const lines = new LineSegments(geometry(sheet.lines), paint.lines(cut, layer.lines));
  // Nothing is out of sight as a whole that is worth the test, and displacements move what the test would measure.
  fill.frustumCulled = lines.frustumCulled = false;
  fill.visible = opacity > 0;
  fill.renderOrder = opacity < 1 ? 2 : 0;
  lines.renderOrder = 1;
  return { layer, place, moved, level, fill, lines };
}

/** Gives back what the layer holds of the graphics memory. */
export function drop(drawn: Drawn) {
  for (const object of [drawn.fill, drawn.lines]) {
    object.geometry.dispose();
    (object.material as ShaderMaterial).dispose();
  }
}

/** Sets the values that a layer shows. */
export function setValues({ layer: { sheet }, level, fill }: Drawn, values: Values | null) {
  for (let i = 0; i < sheet.cell.length; i++) {
    let value = NaN;
    if (values?.at === "cells") value = values.array[sheet.cell[i]];
    else if (values) value = values.array[sheet.a[i]] + sheet.s[i] * (values.array[sheet.b[i]] - values.array[sheet.a[i]]);
    const known = !Number.isNaN(value);
    level[2 * i] = known ? value : 0;
    level[2 * i + 1] = known ? 1 : 0;
  }
  fill.geometry.attributes.level.needsUpdate = true;
}

/** Sets whether a layer stays without the colours of its values. */
export function setPlain({ fill }: Drawn, plain: boolean) {
  (fill.material as ShaderMaterial).uniforms.plain.value = plain ? 1 : 0;
}

/** Sets the displacement of a layer, in m. */
export function setMoved({ layer: { sheet }, moved, fill }: Drawn, displacement: Float32Array | null) {
  if (displacement) moved.set(spread(sheet, displacement));
  else moved.fill(0);
  fill.geometry.attributes.moved.needsUpdate = true;
}
