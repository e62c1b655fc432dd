// Runs the program in a page or in Node. SPDX-License-Identifier: MIT
'use strict';

/**
 * Runs `touchstone ARGUMENTS` in a folder of its own, in memory.
 *
 * @param create  the function that program.js defines
 * @param {WebAssembly.Module} module  the program, compiled
 * @param {string[]} args  the command and its arguments; `-` as a file is standard input
 * @param {Object<string, string|Uint8Array>} files  the files that it finds, by their paths in the folder
 * @param {string|Uint8Array} input  its standard input
 * @returns {Promise<{status: number, out: Uint8Array, err: string, files: Object<string, Uint8Array>}>}  its exit
 *   status, what it wrote to standard output and standard error, and the files that it made or changed
 */
async function runTouchstone(create, module, args, files = {}, input = '') {
  const bytes = (data) => (typeof data === 'string' ? new TextEncoder().encode(data) : data);
  const given = bytes(input);
  let read = 0;
  const out = [], err = [];
  const program = await create({
    instantiateWasm(imports, receive) {
      WebAssembly.instantiate(module, imports).then((instance) => receive(instance, module));
      return {};
    },
    preRun:
        [({FS}) => FS.init(() => (read < given.length ? given[read++] : null), (c) => out.push(c), (c) => err.push(c))],
    noInitialRun: true,
    quit(_, exit) {
      throw exit;  // and not the end of the process
    },
  });
  const {FS} = program;
  FS.mkdir('/run');
  FS.chdir('/run');
  for (const [name, data] of Object.entries(files)) {
    FS.mkdirTree(('/run/' + name).slice(0, ('/run/' + name).lastIndexOf('/')));
    FS.writeFile(name, bytes(data));
    FS.utime(name, 0, 0);  // a later time is that of a write
  }
  const status = program.callMain(args);
  const made = {};
  const collect = (folder) => {
    for (const name of FS.readdir('/run/' + folder)) {
      if (name === '.' || name === '..') continue;
      const path = folder + name;
      if (FS.isDir(FS.stat('/run/' + path).mode)) {
        collect(path + '/');
        continue;
      }
      if (FS.stat('/run/' + path).mtime.getTime() !== 0) made[path] = FS.readFile('/run/' + path);
    }
  };
  collect('');
  return {status, out: Uint8Array.from(out), err: new TextDecoder().decode(Uint8Array.from(err)), files: made};
}

if (typeof module === 'object' && typeof require === 'function') module.exports = runTouchstone;
