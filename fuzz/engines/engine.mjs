// An engine in JavaScript that `touchstone audit` asks over pipes: the counterpart of engine.hpp.
// SPDX-License-Identifier: MIT
import { writeSync } from "node:fs";
import { createRequire } from "node:module";
import { createInterface } from "node:readline";

const require = createRequire(import.meta.url);
const CORNERS = { "edge-edge": 4, "vertex-face": 4, "point-edge": 3, "point-point": 2 };

/** A package of npm, beside this file or above it; ends the program with the reason where there is none. */
export async function engine(name) {
  try {
    return await import(name);
  } catch (error) {
    if (error.code !== "ERR_MODULE_NOT_FOUND") throw error;
    const folder = decodeURIComponent(new URL(".", import.meta.url).pathname);
    console.error(`the npm package ${name} is not installed: npm install --prefix ${folder}`);
    process.exit(3);
  }
}

/** "NAME VERSION (npm PACKAGE)". */
export function version_of(name, npm) {
  return `${name} ${require(`./node_modules/${npm}/package.json`).version} (npm ${npm})`;
}

export const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const length = (a) => Math.hypot(a[0], a[1], a[2]);
export const middle = (a, b) => [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2];

/** The unit quaternion [x, y, z, w] that turns the axis `from` along `to`, which need not be a unit vector. */
export function turn(from, to) {
  const size = length(to);
  const w = from[0] * to[0] + from[1] * to[1] + from[2] * to[2] + size;
  const cross = [from[1] * to[2] - from[2] * to[1], from[2] * to[0] - from[0] * to[2],
    from[0] * to[1] - from[1] * to[0]];
  if (w < 1e-12 * size) return from[0] === 0 ? [1, 0, 0, 0] : [0, 0, 1, 0];
  const norm = Math.hypot(...cross, w);
  return [cross[0] / norm, cross[1] / norm, cross[2] / norm, w / norm];
}

/** C's hexfloats are read exactly; JavaScript has no reader of them. */
function number(text) {
  const [, sign, head, tail = "", power] = /^(-?)0x([01])(?:\.([0-9a-f]+))?p([+-]\d+)$/.exec(text);
  let value = parseInt(head + tail, 16);  // at most 14 hexadecimal digits, of which the first is 0 or 1: exact
  for (let shift = Number(power) - 4 * tail.length; shift !== 0;) {
    const step = Math.max(-1000, Math.min(1000, shift));
    value *= 2 ** step;
    shift -= step;
  }
  return sign ? -value : value;
}

function read(line) {
  const [kind, ...numbers] = line.trim().split(" ");
  if (!(kind in CORNERS)) return { kind };
  const points = [];
  for (let i = 0; i < numbers.length; i += 3) points.push(numbers.slice(i, i + 3).map(number));
  return { kind, start: points.slice(0, CORNERS[kind]), end: points.slice(CORNERS[kind]),
    second: kind === "edge-edge" ? 2 : 1 };
}

/**
 * Answers queries until the input ends. A question has `name`, `lines` as docs/audit.md explains them, and
 * `ask(query)`: null where there is no contact, or its time, or undefined where the engine fails.
 */
export async function serve(questions) {
  const wanted = process.argv[2];
  if (wanted === "--describe") {
    for (const { name, lines } of questions) writeSync(1, `question ${name}\n${lines.trim().replace(/\n +/g, "\n")}\n`);
    process.exit(0);
  }
  const question = questions.find(({ name }) => name === wanted);
  if (question === undefined) {
    console.error(`usage: --describe, or one of the questions: ${questions.map(({ name }) => name).join(" ")}`);
    process.exit(2);
  }
  const kinds = / *kinds (.*)/.exec(question.lines)[1].split(" ");
  const separated = /^ *separation /m.test(question.lines);
  const answer = (line) => {
    if (line.startsWith("separation ")) return separated ? "ok" : "unsupported";
    const query = read(line);
    if (!kinds.includes(query.kind)) return "unsupported";
    const time = question.ask(query);
    if (time === undefined) return "unknown";
    return time === null ? "0" : `1 ${time}`;
  };
  for await (const line of createInterface({ input: process.stdin })) writeSync(1, answer(line) + "\n");
  process.exit(0);
}
