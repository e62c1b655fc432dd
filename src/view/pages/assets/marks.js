// The marks of an animation: pairs of elements that are close, touch or cross at a time. SPDX-License-Identifier: MIT

const kMarkSorts = ['close', 'contact', 'crossing'];

class Marks {
  constructor(frames) {
    this.times = new Float64Array(bytesOf('mark-times'));
    this.points = new Float64Array(bytesOf('mark-points'));
    this.pairs = new Uint32Array(bytesOf('mark-pairs'));
    this.sorts = new Uint8Array(bytesOf('mark-sorts'));
    this.elements = new Uint32Array(bytesOf('pairs'));
    // By frame: the marks since the frame before.
    this.byFrame = Array.from({length: frames.count}, () => []);
    this.times.forEach((time, i) => this.byFrame[frames.ending(time)].push(i));
  }

  get count() { return this.times.length; }

  pair(i) { return this.pairElements(this.pairs[i]); }

  pairElements(pair) {
    return [0, 2].map(
        (at) => ({sort: kElementSorts[this.elements[4 * pair + at]], number: this.elements[4 * pair + at + 1]}));
  }

  firstTime(sort) {
    const number = kMarkSorts.indexOf(sort);
    return this.times.reduce((least, s, i) => this.sorts[i] === number && !(s >= least) ? s : least, undefined);
  }

  /**
   * The marks to show at a time: at a frame those since the frame before, in between those within a tenth of the step.
   */
  near(frames, time) {
    const {frame, fraction} = frames.around(time);
    const list = this.byFrame[frames.ending(time)];
    if (fraction === 0) return list;
    const reach = (frames.times[frame + 1] - frames.times[frame]) / 10;
    return list.filter((i) => Math.abs(this.times[i] - time) <= reach);
  }

  point(i) { return Array.from(this.points.subarray(3 * i, 3 * i + 3)); }

  sort(i) { return kMarkSorts[this.sorts[i]]; }

  /** The marks of an element, by pair: [{pair, marks}], in the order of time. */
  of(element) {
    const sort = kElementSorts.indexOf(element.sort), found = new Map();
    for (let i = 0; i < this.count; ++i) {
      const at = 4 * this.pairs[i], e = this.elements;
      if (!((e[at] === sort && e[at + 1] === element.number) || (e[at + 2] === sort && e[at + 3] === element.number)))
        continue;
      if (!found.has(this.pairs[i])) found.set(this.pairs[i], []);
      found.get(this.pairs[i]).push(i);
    }
    return [...found.entries()].map(([pair, marks]) => ({pair, marks}));
  }

  ofPair(pair) {
    const found = [];
    for (let i = 0; i < this.count; ++i) {
      if (this.pairs[i] === pair) found.push(i);
    }
    return found;
  }
}

/** Draws marks over the picture. place: the pixels of a point. */
function drawMarks(canvas, marks, list, place, colours) {
  const most = 3000, front = 0.003;  // faces before a mark hide it
  list.slice(0, most).forEach((i) => {
    const p = place(marks.point(i)), sort = marks.sort(i);
    if (sort === 'crossing') {
      const r = 8;
      for (const [width, colour, lift] of [[6, colours.paper, 0], [3, colours.b, 0.0004]]) {
        canvas.line([p[0] - r, p[1] - r, p[2]], [p[0] + r, p[1] + r, p[2]], width, colour, 1, front + lift);
        canvas.line([p[0] - r, p[1] + r, p[2]], [p[0] + r, p[1] - r, p[2]], width, colour, 1, front + lift);
      }
    } else {
      canvas.dot(p, sort === 'contact' ? 5 : 4, colours.paper, 1, front);
      canvas.dot(p, sort === 'contact' ? 4 : 3, colours.mark, 1, front + 0.0002);
      if (sort === 'close') canvas.dot(p, 1.6, colours.paper, 1, front + 0.0004);
    }
  });
}
