// Rapier (its WebAssembly package, in single precision): rays and shape casts.
// SPDX-License-Identifier: MIT
import { engine, length, middle, minus, serve, turn, version_of } from "./engine.mjs";

const { default: RAPIER } = await engine("@dimforge/rapier3d-compat");
await RAPIER.init();

const RADIUS = 0.125;
const ZERO = { x: 0, y: 0, z: 0 };
const UNTURNED = { x: 0, y: 0, z: 0, w: 1 };
const vector = (p) => ({ x: p[0], y: p[1], z: p[2] });

const triangle = (q) => new RAPIER.Triangle(...q.start.slice(1).map((p) => vector(minus(p, q.start[1]))));

function ray(q) {
  const direction = minus(q.end[0], q.start[0]);
  const shape = triangle(q);
  const time = shape.castRay(new RAPIER.Ray(vector(q.start[0]), vector(direction)), vector(q.start[1]), UNTURNED, 1,
    true);
  return time < 0 || time > 1 ? null : time;
}

/** Casts two shapes that are placed as [shape, position, rotation, velocity]. */
function cast([a, at_a, turn_a, move_a], [b, at_b, turn_b, move_b]) {
  const hit = a.castShape(at_a, turn_a, move_a, b, at_b, turn_b, move_b, 0, 1, true);
  return hit === null ? null : hit.time_of_impact;
}

function segment(q, i) {
  return [new RAPIER.Segment(ZERO, vector(minus(q.start[i + 1], q.start[i]))), vector(q.start[i]), UNTURNED,
    vector(minus(q.end[i], q.start[i]))];
}

function capsule(q, i) {
  const along = minus(q.start[i + 1], q.start[i]);
  const [x, y, z, w] = turn([0, 1, 0], along);
  return [new RAPIER.Capsule(length(along) / 2, RADIUS), vector(middle(q.start[i], q.start[i + 1])), { x, y, z, w },
    vector(minus(q.end[i], q.start[i]))];
}

const ball = (q, radius) => [new RAPIER.Ball(radius), vector(q.start[0]), UNTURNED,
  vector(minus(q.end[0], q.start[0]))];
const face = (q) => [triangle(q), vector(q.start[1]), UNTURNED, vector(minus(q.end[1], q.start[1]))];

const common = `engine ${version_of("Rapier", "@dimforge/rapier3d-compat")}
  numbers float
  elements 0.001
  sizes 0.5 8`;
await serve([
  { name: "ray", ask: ray, lines: `${common}
    asks castRay of a Triangle
    kinds vertex-face
    motion cast
    tolerance-relative 1e-6` },
  { name: "cast", ask: (q) => cast(segment(q, 0), segment(q, 2)), lines: `${common}
    asks castShape of two Segments, target distance 0
    kinds edge-edge
    motion translations
    tolerance-relative 1e-5
    note its iterations end at ten times the epsilon of single precision; a tolerance of 1e-5 of the size is given` },
  { name: "round", lines: `${common}
    asks castShape of two Capsules of radius 0.125, and of a Ball of radius 0.25 and a Triangle
    kinds edge-edge vertex-face
    motion translations
    separation 0.25
    tolerance-relative 1e-5`,
    ask: (q) => q.kind === "edge-edge" ? cast(capsule(q, 0), capsule(q, 2)) : cast(ball(q, 2 * RADIUS), face(q)) },
]);
