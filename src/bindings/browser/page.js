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

/** Runs a command about the queries of the page. */
async function run(command, ...args) {
  const kind = byId('kind').value, separation = byId('separation').value.trim();
  const name = kind + '/queries.csv';
  const words = [command, ...(separation ? ['--separation', separation] : []), ...args];
  byId('command').textContent = ['touchstone', ...words, name].join(' ');
  return runTouchstone(createTouchstone, await program, [...words, name], {[name]: byId('text').value});
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

async function show(index) {
  const lines = [...byId('answers').querySelectorAll('tbody tr')];
  lines.forEach((line, i) => line.setAttribute('aria-selected', i === index));
  const result = await run('view', '--query', String(index), '--out', 'page.html');
  const picture = byId('picture');
  picture.hidden = result.status !== 0;
  if (result.status !== 0)
    say(result.err, true);
  else
    picture.srcdoc = text(result.files['page.html']);
}

/** Asks, and fills the table. A run that was overtaken by a later one shows nothing. */
let latest = 0;
async function solve() {
  const mine = ++latest;
  const result = await run('solve');
  if (mine !== latest) return;
  const table = byId('answers');
  table.textContent = '';
  byId('picture').hidden = true;
  if (result.status !== 0) return say(result.err, true);
  const [head, ...rows] = text(result.out).trimEnd().split('\n').map((line) => line.split(',').slice(1));
  const touching = rows.filter((cells) => cells[1] === '1').length;
  say(`${rows.length} ${rows.length === 1 ? 'query' : 'queries'}: ${touching} with contact. A click on one shows it.`);
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
  const result = await run('prove', '--out', 'proofs.txt');
  if (result.status !== 0) return say(result.err, true);
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([result.files['proofs.txt']], {type: 'text/plain'}));
  link.download = 'proofs.txt';
  link.click();
  URL.revokeObjectURL(link.href);
  say('proofs.txt is saved. touchstone-check proofs.txt ' + byId('kind').value + '/queries.csv checks it.');
}

function name_corners() {
  byId('form').textContent =
      `A query has a row for each of ${ROWS[byId('kind').value]} at t = 0, and then at t = 1: x,y,z as decimals, or ` +
      'x_num,x_den,y_num,y_den,z_num,z_den as integers. Lines that start with # are skipped.';
}

for (const example of EXAMPLES) byId('example').append(new Option(example.name));
byId('example').onchange = () => {
  const example = EXAMPLES[byId('example').selectedIndex];
  byId('kind').value = example.kind;
  byId('text').value = example.text;
  byId('separation').value = '';
  name_corners();
  solve();
};
byId('kind').onchange = name_corners;
byId('solve').onclick = solve;
byId('prove').onclick = prove;
byId('open').onclick = () => byId('file').click();
byId('file').onchange = async () => {
  byId('text').value = await byId('file').files[0].text();
  solve();
};
byId('example').onchange();
