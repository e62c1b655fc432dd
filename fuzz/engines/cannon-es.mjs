// cannon-es: rays against a triangle mesh.
// SPDX-License-Identifier: MIT
import { engine, length, minus, serve, version_of } from "./engine.mjs";

const { Body, Ray, RaycastResult, Trimesh, Vec3 } = await engine("cannon-es");

function ray(q) {
  const mesh = new Trimesh(q.start.slice(1).flatMap((p) => minus(p, q.start[1])), [0, 1, 2]);
  const body = new Body({ mass: 0, shape: mesh, position: new Vec3(...q.start[1]) });
  const line = new Ray(new Vec3(...q.start[0]), new Vec3(...q.end[0]));
  line.mode = Ray.CLOSEST;
  line.skipBackfaces = false;
  const result = new RaycastResult();
  line.intersectBody(body, result);
  return result.hasHit ? result.distance / length(minus(q.end[0], q.start[0])) : null;
}

await serve([
  { name: "ray", ask: ray, lines: `engine ${version_of("cannon-es", "cannon-es")}
    asks Ray.intersectBody of a Trimesh of one triangle, closest hit, both sides
    kinds vertex-face
    motion cast
    numbers float
    elements 0.001
    sizes 0.5 8
    tolerance-relative 1e-6
    note corners are stored in single precision, and the arithmetic is in doubles` },
]);
