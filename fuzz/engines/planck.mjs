// Planck: Box2D in JavaScript, with its time of impact in the plane.
// SPDX-License-Identifier: MIT
import { engine, minus, serve, version_of } from "./engine.mjs";

const { Settings, TOIInput, TOIOutput, TimeOfImpact, TOIOutputState } = await engine("planck");

const point = ([x, y]) => ({ x, y });

/** The corners [from, to) about the first of them, and the sweep of that one. */
function set_element(q, from, to, proxy, sweep) {
  proxy.setVertices(q.start.slice(from, to).map((p) => point(minus(p, q.start[from]))), to - from, 0);
  sweep.c0.set(q.start[from][0], q.start[from][1]);
  sweep.c.set(q.end[from][0], q.end[from][1]);
}

function toi(q) {
  const input = new TOIInput(), output = new TOIOutput();
  set_element(q, 0, q.second, input.proxyA, input.sweepA);
  set_element(q, q.second, q.start.length, input.proxyB, input.sweepB);
  input.tMax = 1;
  TimeOfImpact(output, input);
  if (output.state === TOIOutputState.e_separated) return null;
  const met = output.state === TOIOutputState.e_touching || output.state === TOIOutputState.e_overlapped;
  return met ? output.t : undefined;
}

const slop = Settings.linearSlop;
await serve([
  { name: "toi", ask: toi, lines: `engine ${version_of("Planck", "planck")}
    asks TimeOfImpact of points and segments without a radius
    kinds edge-edge point-edge point-point
    motion translations
    space 2
    numbers double
    elements 0.001
    sizes 0.1 10
    separation ${slop}
    tolerance-length ${slop / 4}
    note its target is the distance linearSlop, ${slop}, within a quarter of it
    note it says, as Box2D, that it may miss some intermediate, non-tunneling collisions` },
]);
