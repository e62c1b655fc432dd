// The npm package's one function. SPDX-License-Identifier: MIT
'use strict';
const fs = require('fs');
const path = require('path');
const create = require('./program.js');
const run = require('./run.js');

const program = new WebAssembly.Module(fs.readFileSync(path.join(__dirname, 'program.wasm')));

/** Runs `touchstone ARGUMENTS` on files in memory; run.js says what it takes and gives. */
exports.run = (args, files, input) => run(create, program, args, files, input);
