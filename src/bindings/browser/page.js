// The page: text to answers, pictures and proofs. SPDX-License-Identifier: MIT
'use strict';
const byId = (id) => document.getElementById(id);
const ROWS = {
  'edge-edge': 'a0 a1 b0 b1',
  'vertex-face': 'v f0 f1 f2',
  'point-edge': 'p e0 e1',
  'point-point': 'p q',
};

const program = (async () => {
  const packed = Uint8Array.from(atob(PROGRAM), (c) => c.charCodeAt(0));
  const unpacked = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return WebAssembly.compile(await new Response(unpacked).arrayBuffer());
})();

let opened = null;  // the bytes of a file that is no text

/** What the page asks about now. */
function form() {
  const kind = byId('kind').value;
  return {
    kind,
    name: kind + '/queries.csv',
    separation: byId('separation').value.trim(),
    given: opened ?? byId('text').value
  };
}

/** Runs a command about queries; `line` is what one types for it. */
async function run(asked, command, ...args) {
  const words = [command, ...(asked.separation ? ['--separation', asked.separation] : []), ...args, asked.name];
  const result = await runTouchstone(createTouchstone, await program, words, {[asked.name]: asked.given});
  return {...result, line: ['touchstone', ...words].join(' ')};
}

function say(text, isWrong = false) {
  byId('said').textContent = text.trim();
  byId('said').classList.toggle('wrong', isWrong);
}

const text = (bytes) => new TextDecoder().decode(bytes);

function row(cells, tag) {
  const line = document.createElement('tr');
  for (const cell of cells) line.appendChild(document.createElement(tag)).textContent = cell;
  return line;
}

let answered = null;  // the queries in the table, and what was said of them
let latestPicture = 0;

async function show(index) {
  const asked = answered, mine = ++latestPicture;
  const lines = [...byId('answers').querySelectorAll('tbody tr')];
  lines.forEach((line, i) => line.setAttribute('aria-selected', i === index));
  const result = await run(asked, 'view', '--query', String(index), '--out', 'page.html');
  if (asked !== answered || mine !== latestPicture) return;
  const picture = byId('picture');
  picture.hidden = result.status !== 0;
  byId('command').textContent = asked.line + '\n' + result.line;
  if (result.status !== 0) return say(result.err, true);
  picture.srcdoc = text(result.files['page.html']);
  say(asked.summary);
}

/** Asks, and fills the table. A run that was overtaken by a later one shows nothing. */
let latest = 0;
async function solve() {
  const mine = ++latest, asked = form();
  const result = await run(asked, 'solve');
  if (mine !== latest) return;
  const table = byId('answers');
  table.textContent = '';
  byId('picture').hidden = true;
  byId('command').textContent = result.line;
  answered = {...asked, line: result.line};
  if (result.status !== 0) return say(result.err, true);
  const [head, ...rows] = text(result.out).trimEnd().split('\n').map((line) => line.split(',').slice(1));
  const touching = rows.filter((cells) => cells[1] === '1').length;
  answered.summary =
      `${rows.length} ${rows.length === 1 ? 'query' : 'queries'}: ${touching} with contact. A click on one shows it.`;
  say(answered.summary);
  table.createTHead().append(row(head, 'th'));
  const body = table.createTBody();
  rows.forEach((cells, i) => {
    const line = row(cells, 'td');
    line.tabIndex = 0;
    line.onclick = () => show(i);
    line.onkeydown = (event) => event.key === 'Enter' && show(i);
    body.append(line);
  });
  if (rows.length > 0) await show(0);
}

async function prove() {
  const asked = form();
  const result = await run(asked, 'prove', '--out', 'proofs.txt');
  byId('command').textContent = result.line;
  if (result.status !== 0) return say(result.err, true);
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([result.files['proofs.txt']], {type: 'text/plain'}));
  link.download = 'proofs.txt';
  link.click();
  URL.revokeObjectURL(link.href);
  say(`proofs.txt is saved. touchstone-check proofs.txt ${asked.name} checks it.`);
}

function name_corners() {
  byId('form').textContent = `A query of straight motion has a row for each of ${
                                 ROWS[byId('kind').value]} at t = 0, and then at t = 1: x,y,z ` +
      'as decimals, or x_num,x_den,y_num,y_den,z_num,z_den as integers. Curved motion has rows of its own, as an ' +
      'example has. Lines that start with # are skipped.';
}

/** Puts queries into the form: text, or bytes that are none. */
function give(queries, name = '') {
  opened = typeof queries === 'string' ? null : queries;
  byId('text').value = opened === null ? queries : `${name}: ${opened.length} bytes that are no text`;
}

for (const example of EXAMPLES) byId('example').append(new Option(example.name));
byId('example').onchange = () => {
  const example = EXAMPLES[byId('example').selectedIndex];
  byId('kind').value = example.kind;
  give(example.text);
  byId('separation').value = '';
  name_corners();
  solve();
};
byId('kind').onchange = name_corners;
byId('text').oninput = () => {
  opened = null;
};
byId('solve').onclick = solve;
byId('prove').onclick = prove;
byId('open').onclick = () => byId('file').click();
byId('file').onchange = async () => {
  const file = byId('file').files[0];
  const bytes = new Uint8Array(await file.arrayBuffer());
  try {
    give(new TextDecoder('utf-8', {fatal: true}).decode(bytes));
  } catch {
    give(bytes, file.name);
  }
  byId('file').value = '';  // so that the same file can be opened again
  solve();
};
byId('example').onchange();
