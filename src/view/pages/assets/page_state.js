// What the address of a page keeps, and pictures of what is seen. SPDX-License-Identifier: MIT

let waitingToKeep = 0;

/** The time, the zoom and the directions of the screen's right and of the reader; undefined where there is no number. */
function stateOfAddress() {
  const state = new URLSearchParams(location.hash.slice(1));
  const number = (name) => {
    const x = state.has(name) ? Number(state.get(name)) : NaN;
    return Number.isFinite(x) ? x : undefined;
  };
  return {t: number('t'), zoom: number('zoom'), from: (state.get('from') || '').split(',').map(Number)};
}

/** Keeps the last one of many states: browsers refuse an address that changes with each picture. */
function keepInAddress(s, zoom, camera) {
  clearTimeout(waitingToKeep);
  waitingToKeep = setTimeout(() => {
    const round = (x) => String(Number(x.toPrecision(9))), {basis} = camera;
    const state = {t: String(s), zoom: round(zoom), from: [...basis[0], ...basis[2]].map(round).join()};
    history.replaceState(null, '', '#' + new URLSearchParams(state));
  }, 200);
}

/** Saves what a canvas shows as PNG, with the words that lie over it. */
function savePicture(canvas) {
  const paper = element('canvas', {width: canvas.width, height: canvas.height});
  const context = paper.getContext('2d'), box = canvas.getBoundingClientRect(), ratio = canvas.width / box.width;
  context.fillStyle = getComputedStyle(document.body).backgroundColor;
  context.fillRect(0, 0, paper.width, paper.height);
  context.drawImage(canvas, 0, 0);
  context.scale(ratio, ratio);
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  for (const word of canvas.parentNode.querySelectorAll('.label, .legend span, .bar span')) {
    const at = word.getBoundingClientRect(), style = getComputedStyle(word);
    if (at.width === 0) continue;
    context.font = style.font;
    context.fillStyle = style.color;
    context.fillText(word.textContent, at.left - box.left + at.width / 2, at.top - box.top + at.height / 2);
  }
  for (const line of canvas.parentNode.querySelectorAll('.bar i')) {
    const at = line.getBoundingClientRect();
    context.fillRect(at.left - box.left, at.bottom - box.top - 2, at.width, 2);
  }
  element('a', {href: paper.toDataURL('image/png'), download: document.title.replace(/[^\w.-]+/g, '-') + '.png'})
      .click();
}
