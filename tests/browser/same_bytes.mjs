// The package for Node says byte for byte what the native program says, about every bundled query. Certify's line of
// how long it took is left out.
// SPDX-License-Identifier: MIT
//
//   node same_bytes.mjs PACKAGE touchstone QUERIES
import { spawnSync } from "child_process";
import fs from "fs";
import { createRequire } from "module";
import path from "path";

const [folder, native, queries] = process.argv.slice(2);
const { run } = createRequire(import.meta.url)(path.resolve(folder));

let compared = 0, differences = 0;
async function compare(args, file) {
  const theirs = spawnSync(path.resolve(native), [...args, file], { cwd: queries, maxBuffer: 1 << 30 });
  const ours = await run([...args, file], { [file]: fs.readFileSync(path.join(queries, file)) });
  ++compared;
  const said = [theirs.stdout, ours.out].map((bytes) => Buffer.from(bytes).toString().replace(/^  time .*$/m, ""));
  const same = ours.status === theirs.status && said[0] === said[1] && ours.err === theirs.stderr.toString();
  if (same) return;
  if (++differences <= 10) {
    console.error(`${[...args, file].join(" ")}: status ${ours.status}, native ${theirs.status}\n` +
      `${ours.err}native: ${theirs.stderr}`);
  }
}

for (const kind of ["edge-edge", "point-edge", "point-point", "vertex-face"]) {
  for (const name of fs.readdirSync(path.join(queries, kind)).filter((each) => each.endsWith(".csv")).sort()) {
    const file = `${kind}/${name}`;
    await compare(["solve"], file);
    await compare(["solve", "--json"], file);
    await compare(["solve", "--separation", "0.125"], file);
    await compare(["prove"], file);
    await compare(["prove", "--separation", "1", "--metric", "max"], file);
    await compare(["certify"], file);
    await compare(["explain", "--query", "0"], file);
    await compare(["view", "--query", "0", "--out", "-"], file);
  }
}
console.log(`${compared} runs compared: ${differences} differences`);
process.exit(differences === 0 && compared > 800 ? 0 : 1);
