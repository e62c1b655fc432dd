// three-mesh-bvh: rays against a mesh of three.js.
// SPDX-License-Identifier: MIT
import { engine, length, minus, serve, version_of } from "./engine.mjs";

const { BufferAttribute, BufferGeometry, DoubleSide, Ray, Vector3 } = await engine("three");
const { MeshBVH } = await engine("three-mesh-bvh");

function ray(q) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(q.start.slice(1).flat()), 3));
  geometry.setIndex(new BufferAttribute(new Uint16Array([0, 1, 2]), 1));
  const motion = minus(q.end[0], q.start[0]), size = length(motion);
  const line = new Ray(new Vector3(...q.start[0]), new Vector3(...motion).divideScalar(size));
  const hit = new MeshBVH(geometry).raycastFirst(line, DoubleSide, 0, size);
  return hit === null ? null : hit.distance / size;
}

await serve([
  { name: "ray", ask: ray, lines: `engine ${version_of("three-mesh-bvh", "three-mesh-bvh")}
    asks MeshBVH.raycastFirst, both sides, near 0, far the length of the motion
    kinds vertex-face
    motion cast
    numbers float
    elements 0.001
    sizes 0.5 8
    tolerance-relative 1e-12
    note corners are stored in single precision, and the arithmetic is in doubles` },
]);
