// Points that are told when the pointer is on them, and tables that sort. SPDX-License-Identifier: MIT

/** What a row sorts by in a column: a number, or text; nothing for an empty cell. */
function sortKey(row, column) {
  const cell = row.children[column];
  if (cell.dataset.value !== undefined) return Number(cell.dataset.value);
  return cell.textContent === '' ? null : cell.textContent;
}

function compareKeys(a, b) {
  return typeof a === 'number' && typeof b === 'number' ? a - b : String(a).localeCompare(String(b));
}

/** Sorts by a column; again: the other way round. Rows without a value come last. */
function sortTable(table, column) {
  const heads = [...table.tHead.rows[0].cells], head = heads[column];
  const falls = head.getAttribute('aria-sort') === 'ascending';
  heads.forEach((other) => other.removeAttribute('aria-sort'));
  head.setAttribute('aria-sort', falls ? 'descending' : 'ascending');
  const rows = [...table.tBodies[0].rows].map((row) => [sortKey(row, column), row]);
  rows.sort(([a], [b]) => {
    if (a === null || b === null) return (a === null ? 1 : 0) - (b === null ? 1 : 0);
    return falls ? compareKeys(b, a) : compareKeys(a, b);
  });
  table.tBodies[0].append(...rows.map(([, row]) => row));
}

for (const table of document.querySelectorAll('table.sorts')) {
  [...table.tHead.rows[0].cells].forEach(
      (cell, column) => cell.querySelector('button').addEventListener('click', () => sortTable(table, column)));
}

for (const set of document.querySelectorAll('.set')) {
  const told = set.querySelector('.told'), dots = [...set.querySelectorAll('.dot')];
  const show = (id, text) => {
    dots.forEach((dot) => dot.classList.toggle('here', dot.dataset.row === id));
    set.querySelectorAll('tbody tr').forEach((row) => row.classList.toggle('here', row.id === id));
    told.textContent = text;
  };
  for (const dot of dots) {
    const text = dot.querySelector('title').textContent;
    for (const event of ['pointerenter', 'pointerdown', 'focus']) {
      dot.addEventListener(event, () => show(dot.dataset.row, text));
    }
  }
  for (const row of set.querySelectorAll('tbody tr')) {
    row.addEventListener('pointerenter', () => {
      const own = dots.filter((dot) => dot.dataset.row === row.id);
      show(row.id, own.map((dot) => dot.querySelector('title').textContent).join('; '));
    });
  }
}
