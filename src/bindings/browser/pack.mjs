// Puts the program into one page, and into a folder for npm. SPDX-License-Identifier: MIT
//
//   node pack.mjs VERSION PROGRAM.js PROGRAM.wasm SOURCES PAGE.html NPM_FOLDER
import fs from "fs";
import path from "path";
import zlib from "zlib";

const [version, script, wasm, sources, page, npm] = process.argv.slice(2);
const here = path.join(sources, "src/bindings/browser");
const assets = path.join(sources, "src/view/pages/assets");
const read = (...names) => fs.readFileSync(path.join(...names), "utf8");

// The first one is short enough to be changed by hand.
const FALLING = `# Two edges: the first one falls through the second one.
# a0 a1 b0 b1 at t = 0:
-1,0,1
1,0,1
0,-1,0
0,1,0
# and at t = 1:
-1,0,-0.5
1,0,-0.5
0,-1,0
0,1,0
`;
const EXAMPLES = [
  ["Two edges, one ulp short of contact, and one ulp past it", "edge-edge", "one_ulp.csv"],
  ["A vertex and a face: false alarms that were published", "vertex-face", "published_false_alarm.csv"],
  ["Edges of a spinning coin", "edge-edge", "curved_coin.csv"],
  ["A tip that spins", "vertex-face", "curved_spinning_tip.csv"],
  ["Two points that meet at rational times", "point-point", "rational_times.csv"],
];

const PARTS = {
  "colours.css": () => read(assets, "colours.css"),
  "style.css": () => read(assets, "style.css"),
  "page.css": () => read(here, "page.css"),
  "page.js": () => read(here, "page.js"),
  "run.js": () => read(here, "run.js"),
  "program.js": () => fs.readFileSync(script, "utf8"),
  "program.wasm": () => zlib.gzipSync(fs.readFileSync(wasm), { level: 9 }).toString("base64"),
  examples: () =>
    JSON.stringify([
      { name: "An edge falls through an edge", kind: "edge-edge", text: FALLING },
      ...EXAMPLES.map(([name, kind, file]) => ({ name, kind, text: read(sources, "src/cli/queries", kind, file) })),
    ]),
};
const escaped = (text) => text.replace(/<\/script/gi, "<\\/script").replace(/<!--/g, "<\\!--");
const text = read(here, "page.html").replace(/\{\{([\w.]+)\}\}/g, (_, name) => escaped(PARTS[name]()));
fs.writeFileSync(page, text);

fs.mkdirSync(npm, { recursive: true });
fs.copyFileSync(script, path.join(npm, "program.js"));
fs.copyFileSync(wasm, path.join(npm, "program.wasm"));
for (const name of ["index.js", "index.d.ts", "run.js"]) fs.copyFileSync(path.join(here, name), path.join(npm, name));
fs.copyFileSync(path.join(here, "npm.md"), path.join(npm, "README.md"));
fs.copyFileSync(path.join(sources, "LICENSE"), path.join(npm, "LICENSE"));
const about = {
  name: "touchstone-ccd",
  version,
  description: "Exact continuous collision detection: do two moving elements ever touch, and when first?",
  license: "MIT",
  main: "index.js",
  types: "index.d.ts",
  engines: { node: ">=16" },
};
fs.writeFileSync(path.join(npm, "package.json"), JSON.stringify(about, null, 2) + "\n");
