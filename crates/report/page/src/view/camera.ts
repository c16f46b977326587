// The camera: what it looks at first, along the axes, and by the keyboard.
import { PerspectiveCamera, Spherical, Vector3 } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { FaceKind } from "./manifest";
import { type Box, FACES, type Part } from "./part";

/** Directions to look from. */
const FROM = {
  x: new Vector3(1, 0, 0),
  y: new Vector3(0, -1, 0),
  z: new Vector3(0, 0, 1),
} as const;
export type From = keyof typeof FROM | "oblique" | "whole";

/** Mostly along the caverns, a little from the side and from above. */
const OBLIQUE = [new Vector3(1, -0.42, 0.3), new Vector3(0.42, -1, 0.3)];

/** What matters first, relative to the model's centre: the linings, else openings, else everything. */
export function subject(parts: Part[], box: Box): { low: Vector3; high: Vector3 } {
  const low = new Vector3(Infinity, Infinity, Infinity);
  const high = low.clone().negate();
  const take = (part: Part, point: number) => {
    const at = new Vector3().fromArray(part.points, 3 * point);
    low.min(at);
    high.max(at);
  };
  for (const part of parts.filter((p) => p.held.kind === "lining")) {
    for (let i = 0; i < part.points.length / 3; i++) take(part, i);
  }
  if (low.x > high.x) {
    for (const part of parts.filter((p) => p.corners === 8)) {
      part.faces.forEach((entry, i) => {
        if (part.faceKinds[i] !== FaceKind.opening) return;
        for (const corner of FACES[entry % 6]) take(part, part.cells[corner * part.count + Math.floor(entry / 6)]);
      });
    }
  }
  if (low.x > high.x) {
    high.set(...box.high).sub(new Vector3(...box.centre));
    low.copy(high).negate();
  }
  return { low, high };
}

/** A camera above the canvas that tells when it moved. */
export function cameraOn(canvas: HTMLCanvasElement, box: Box, first: { low: Vector3; high: Vector3 }, along: 0 | 1, moved: () => void) {
  const camera = new PerspectiveCamera(28, 1, box.diagonal / 1e3, box.diagonal * 12);
  camera.up.set(0, 0, 1);
  const controls = new OrbitControls(camera, canvas);
  controls.addEventListener("change", moved);
  controls.minDistance = box.diagonal / 200;
  controls.maxDistance = box.diagonal * 6;
  // The wheel scrolls the page until the reader has turned to the model.
  controls.enableZoom = false;
  canvas.addEventListener("focus", () => (controls.enableZoom = true));
  canvas.addEventListener("blur", () => (controls.enableZoom = false));

  /** Half the angle that the shorter side of the picture spans. */
  const narrow = () => {
    const half = ((camera.fov / 2) * Math.PI) / 180;
    return Math.min(half, Math.atan(Math.tan(half) * camera.aspect));
  };
  /** Takes over how wide the picture is for its height, and still shows what it showed. */
  const aim = (aspect: number) => {
    if (aspect === camera.aspect) return;
    const before = narrow();
    camera.aspect = aspect;
    camera.updateProjectionMatrix();
    const nearer = Math.sin(before) / Math.sin(narrow());
    camera.position.sub(controls.target).multiplyScalar(nearer).add(controls.target);
    controls.update();
  };
  const far = new Vector3(...box.high).sub(new Vector3(...box.centre));
  /** Looks from a direction, so that the ball about what matters, or about everything, fits with a margin. */
  const look = (from: From) => {
    const [low, high] = from === "whole" ? [far.clone().negate(), far] : [first.low, first.high];
    const way = from === "whole" || from === "oblique" ? OBLIQUE[along] : FROM[from];
    const radius = (low.distanceTo(high) / 2) * (from === "whole" ? 0.95 : 0.98);
    controls.target.copy(low).add(high).divideScalar(2);
    camera.position.copy(way).normalize().multiplyScalar(radius / Math.sin(narrow())).add(controls.target);
    // Straight down, north would be undefined: a hair of tilt puts y upwards.
    if (from === "z") camera.position.y -= 1e-4 * radius;
    controls.update();
    moved();
  };
  const turn = (azimuth: number, polar: number, nearer: number) => {
    const arm = camera.position.clone().sub(controls.target);
    // OrbitControls' own spheres stand on y; here z is up.
    const ball = new Spherical().setFromCartesianCoords(arm.x, arm.z, -arm.y);
    ball.theta += azimuth;
    ball.phi += polar;
    ball.radius *= nearer;
    ball.makeSafe();
    const { x, y, z } = new Vector3().setFromSpherical(ball);
    camera.position.set(x, -z, y).add(controls.target);
    controls.update();
    moved();
  };
  const step = Math.PI / 24;
  const keys: Record<string, () => void> = {
    ArrowLeft: () => turn(-step, 0, 1),
    ArrowRight: () => turn(step, 0, 1),
    ArrowUp: () => turn(0, -step, 1),
    ArrowDown: () => turn(0, step, 1),
    "+": () => turn(0, 0, 1 / 1.15),
    "=": () => turn(0, 0, 1 / 1.15),
    "-": () => turn(0, 0, 1.15),
  };
  canvas.addEventListener("keydown", (event) => {
    const act = keys[event.key];
    if (!act || event.ctrlKey || event.metaKey || event.altKey) return;
    act();
    event.preventDefault();
  });
  return { camera, look, aim };
}
