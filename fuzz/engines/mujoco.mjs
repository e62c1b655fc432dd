// MuJoCo (its WebAssembly package): rays against a capsule, and the distance of two capsules that stand still.
// SPDX-License-Identifier: MIT
import { engine, length, middle, minus, serve, turn } from "./engine.mjs";

const { default: load } = await engine("mujoco-js");
const mujoco = await load();
const RADIUS = 0.125;

mujoco.FS.writeFile("/capsules.xml", `<mujoco><worldbody>
  <geom type="capsule" size="1 1"/><geom type="capsule" size="1 1"/></worldbody></mujoco>`);
const model = mujoco.MjModel.loadFromXML("/capsules.xml");
const data = new mujoco.MjData(model);
mujoco.mj_forward(model, data);

/** The rotation matrix, by rows, that turns z along `to`. */
function rotation(to) {
  const [x, y, z, w] = turn([0, 0, 1], to);
  return [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),
    2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
    2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)];
}

function ray(q) {
  const along = minus(q.start[2], q.start[1]);
  const time = mujoco.mju_rayGeom(middle(q.start[1], q.start[2]), rotation(along),
    [2 * RADIUS, length(along) / 2, 0], q.start[0], minus(q.end[0], q.start[0]), mujoco.mjtGeom.mjGEOM_CAPSULE.value);
  return time < 0 || time > 1 ? null : time;
}

function pose(q, geom, i) {
  const along = minus(q.start[i + 1], q.start[i]);
  model.geom_size.set([RADIUS, length(along) / 2, 0], 3 * geom);
  model.geom_rbound[geom] = RADIUS + length(along) / 2;
  data.geom_xpos.set(middle(q.start[i], q.start[i + 1]), 3 * geom);
  data.geom_xmat.set(rotation(along), 9 * geom);
}

function still(q) {
  pose(q, 0, 0);
  pose(q, 1, 2);
  return mujoco.mj_geomDistance(model, data, 0, 1, 1, null) <= 0 ? 0 : null;
}

const common = `engine MuJoCo ${mujoco.mj_versionString()} (npm mujoco-js)
  elements 0.001
  sizes 0.5 8
  separation 0.25
  tolerance-relative 1e-12`;
await serve([
  { name: "ray", ask: ray, lines: `${common}
    asks mju_rayGeom of a capsule of radius 0.25, from outside
    kinds point-edge
    motion cast
    starts apart` },
  { name: "still", ask: still, lines: `${common}
    asks mj_geomDistance of two capsules of radius 0.125
    kinds edge-edge
    motion still` },
]);
