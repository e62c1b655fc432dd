// The page of an animation: its stage, its controls and what they say. SPDX-License-Identifier: MIT

const kMostTicks = 400;

class AnimationViewer {
  constructor(parent, data) {
    this.data = data;
    this.frames = new Frames(data);
    this.elements = new Elements(data);
    this.marks = new Marks(this.frames);
    this.zoom = 0;
    this.s = data.times[0];
    this.chosen = [];
    this.centre = data.centre;
    this.reach = data.reach;
    this.build(parent);
    this.canvas = new ShapeCanvas(this.node);
    this.mesh = new MeshCanvas(this.canvas, this.elements, data);
    this.camera = new Camera(
        this.node, data.basis, data.planar, () => this.drawSoon(), (steps) => this.zoomTo(this.zoom + steps));
    this.panel = new ElementPanel(document.querySelector('.picked'), this);
    this.plots = new Plots(parent, data, (time) => this.timeline.go(time));
    this.watchClicks();
    parent.classList.add('live');
    new ResizeObserver(() => this.draw()).observe(this.node);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.draw());
    this.timeline.range(data.times[0], data.times[data.times.length - 1]);
    this.open();
  }

  /** The page opens where its address says. Otherwise it plays to the first contact or crossing. */
  open() {
    const state = stateOfAddress();
    const found = ['contact', 'crossing'].map((sort) => this.marks.firstTime(sort)).filter((s) => s !== undefined);
    this.zoomTo(state.zoom || 0);
    if (found.length > 0) this.faceMeeting(Math.min(...found));
    this.camera.face(state.from);
    this.timeline.open(state.t, found.length > 0 ? Math.min(...found) : undefined);
    this.opened = true;
  }

  /** The first view is that of the first side, by eighths of a turn, that hides the fewest marks of this time. */
  faceMeeting(time) {
    const most = Math.ceil(1e6 / (this.elements.faces.length + 1));  // each asks about all faces
    const all = [...this.marks.times.keys()].filter((i) => this.marks.times[i] === time).slice(0, Math.min(50, most));
    if (this.camera.flat || !this.canvas.resize()) return;
    const now = this.frames.around(time), eighth = Math.PI / 4;
    let best = 0, fewest = Infinity;
    for (let side = 0; side < 8 && fewest > 0; ++side) {
      const view = this.view(), seen = seenVertices(this.frames, this.elements, now, view);
      const hidden = all.filter((i) => {
        const [x, y, z] = this.camera.seen(this.marks.point(i).map((at, k) => (at - view.centre[k]) * view.pixels));
        return frontFace(this.elements, seen, x, y).front > z + 1;
      });
      if (hidden.length < fewest) [best, fewest] = [side, hidden.length];
      this.camera.turnUpright(eighth);
    }
    this.camera.reset();
    if (best === 0) return;
    this.camera.turnUpright(best * eighth);
    this.camera.first = this.camera.basis;
    this.camera.reset();
    // As far as the vertices are from the centre in all frames, or many. What is cut off, as a floor, is farther.
    const view = this.view(), every = Math.ceil(this.frames.count * this.data.vertices / 2e6), reach = [0, 0];
    for (let i = 0; i < this.frames.count; i += every) {
      const {px, py} = seenVertices(this.frames, this.elements, this.frames.around(this.data.times[i]), view);
      [px, py].forEach((seen, k) => reach[k] = seen.reduce((far, x) => Math.max(far, Math.abs(x)), reach[k]));
    }
    this.reach = reach.map((far) => Math.min(1, far / view.pixels / this.data.radius));
  }

  save() {
    this.draw();
    savePicture(this.node);
  }

  build(parent) {
    this.node = element('canvas', {
      tabindex: 0,
      role: 'img',
      'aria-label':
          'The elements at the chosen time. Drag to turn, wheel or pinch to zoom, click an element to choose it.'
    });
    this.node.addEventListener('keydown', (event) => this.key(event));
    parent.querySelector('.stage').append(this.node);
    this.controls = element('div', {class: 'controls'});
    parent.insertBefore(this.controls, parent.querySelector('.plots'));
    this.timeline = new Timeline(this.controls, this.chips(), (s) => this.goTo(s), this.ticks());
    const button = (text, title, action) => element('button', {type: 'button', title, onclick: action}, text);
    this.readout = element('span', {class: 'readout', 'aria-live': 'polite'});
    this.marksButton = button('Marks', 'Shows marks or hides them, key x', () => this.switchMarks());
    this.marksButton.setAttribute('aria-pressed', 'true');
    this.controls.append(element(
        'div', {class: 'row'}, this.readout, button('\u2212', 'Zoom out, key \u2212', () => this.zoomTo(this.zoom - 1)),
        button('+', 'Zoom in, key +', () => this.zoomTo(this.zoom + 1)), button('Whole', 'Key 0', () => this.whole()),
        this.marksButton, button('Save', 'A picture of what is seen, as PNG; key s', () => this.save())));
  }

  switchMarks() {
    this.marksButton.setAttribute('aria-pressed', String(this.marksButton.getAttribute('aria-pressed') !== 'true'));
    this.draw();
  }

  /** The word for a sort of marks. */
  word(sort) { return sort === 'crossing' ? this.data.crossing : sort; }

  /** Times with a button of their own. */
  chips() {
    const times = this.data.times, chips = [{s: times[0], sort: 'start', text: 'start'}];
    const first = (sort) => {
      const s = this.marks.firstTime(sort);
      if (s !== undefined) chips.push({s, sort, text: `first ${this.word(sort)}`});
    };
    first('contact');
    first('crossing');
    chips.push({s: times[times.length - 1], sort: 'end', text: 'end'});
    return chips;
  }

  /** Marks on the slider: of the frames with crossings, and of those with contacts. */
  ticks() {
    const ticks = [];
    for (const sort of ['contact', 'crossing']) {
      const number = kMarkSorts.indexOf(sort);
      const found = this.marks.byFrame.map((list) => list.find((i) => this.marks.sorts[i] === number))
                        .filter((i) => i !== undefined);
      const every = Math.ceil(found.length / kMostTicks);
      found.filter((_, i) => i % every === 0).forEach((i) => ticks.push({s: this.marks.times[i], sort}));
    }
    return ticks;
  }

  watchClicks() {
    let down = null;
    this.node.addEventListener('pointerdown', (event) => down = [event.clientX, event.clientY]);
    this.node.addEventListener('pointerup', (event) => {
      if (!down || Math.hypot(event.clientX - down[0], event.clientY - down[1]) > 4) return;
      const box = this.node.getBoundingClientRect();
      this.pick(event.clientX - box.left - box.width / 2, box.height / 2 - (event.clientY - box.top));
    });
  }

  pick(x, y) {
    const found = pickElement(this.frames, this.elements, this.frames.around(this.s), this.view(), x, y);
    if (found) {
      this.choose([found]);
      this.panel.showElement(found);
    } else {
      this.choose([]);
      this.panel.clear();
    }
  }

  /** One element, or the two of a pair. */
  choose(chosen, pair) {
    this.chosen = chosen;
    this.pair = pair;
    this.draw();
  }

  goToStory(i) {
    const story = this.data.stories[i];
    this.goToPair(story.pair, story.time, story.point);
  }
  goToMark(i) { this.goToPair(this.marks.pairs[i], this.marks.times[i], this.marks.point(i)); }
  goToPair(pair, time, point) {
    this.centre = point;
    this.camera.pan = [0, 0];
    this.chosen = this.marks.pairElements(pair);
    this.pair = pair;
    if (this.zoom < 3) this.zoomTo(3);
    this.timeline.go(time);
  }

  goTo(s) {
    this.s = s;
    if (this.pair !== undefined) {
      this.panel.showPair(this.pair);
    } else if (this.chosen.length === 1) {
      this.panel.showElement(this.chosen[0]);
    }
    this.draw();
  }

  whole() {
    this.camera.reset();
    this.centre = this.data.centre;
    this.zoomTo(0);
  }

  /** The zoom, a power of two, about the middle of the view. */
  zoomTo(zoom) {
    const before = this.zoom;
    this.zoom = Math.max(-2, Math.min(16, zoom));
    this.camera.pan = this.camera.pan.map((x) => x * Math.pow(2, this.zoom - before));
    this.draw();
  }

  /** To the next frame, or the one before. */
  step(frames) {
    const now = this.frames.around(this.s), start = now.fraction > 0 && frames < 0 ? now.frame + 1 : now.frame;
    this.timeline.go(this.data.times[Math.max(0, Math.min(this.frames.count - 1, start + frames))]);
  }

  key(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const turn = 0.1, page = Math.max(1, Math.round(this.frames.count / 10));
    const last = this.data.times[this.frames.count - 1];
    const actions = {
      'ArrowLeft': () => event.shiftKey ? this.camera.turn(-turn, 0) : this.step(-1),
      'ArrowRight': () => event.shiftKey ? this.camera.turn(turn, 0) : this.step(1),
      'ArrowUp': () => event.shiftKey ? this.camera.turn(0, -turn) : this.zoomTo(this.zoom + 0.5),
      'ArrowDown': () => event.shiftKey ? this.camera.turn(0, turn) : this.zoomTo(this.zoom - 0.5),
      'PageUp': () => this.step(-page),
      'PageDown': () => this.step(page),
      'Home': () => this.timeline.go(this.data.times[0]),
      'End': () => this.timeline.go(last),
      '+': () => this.zoomTo(this.zoom + 1),
      '-': () => this.zoomTo(this.zoom - 1),
      '0': () => this.whole(),
      '[': () => this.timeline.jump(-1),
      ']': () => this.timeline.jump(1),
      's': () => this.save(),
      'x': () => this.switchMarks(),
      'Enter': () => this.pick(0, 0),
      'Escape': () => {
        this.choose([]);
        this.panel.clear();
      },
      ' ': () => this.timeline.toggle()
    };
    const action = actions[event.key];
    if (!action) return;
    event.preventDefault();
    action();
  }

  view() {
    const [right, up] = this.reach.map((reach) => Math.max(reach, 0.1));
    const size = Math.min(this.canvas.width / right, this.canvas.height / up) * 0.46;
    return {
      pixels: size / this.data.radius * Math.pow(2, this.zoom),
      centre: this.centre,
      basis: this.camera.basis,
      pan: this.camera.pan
    };
  }

  /** Draws once for all the changes until the next picture of the screen. */
  drawSoon() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.draw();
    });
  }

  draw() {
    if (!this.mesh || !this.canvas.resize()) return;
    const view = this.view(), now = this.frames.around(this.s), frame = this.frames.ending(this.s);
    const names = {ink: '--ink', a: '--a', b: '--b', mark: '--mark', paper: '--paper', rest: '--rest'};
    const colours = Object.fromEntries(Object.entries(names).map(([key, name]) => [key, colourOf(name)]));
    const place = (p) =>
        added(this.camera.seen(p.map((x, k) => (x - view.centre[k]) * view.pixels)), [view.pan[0], view.pan[1], 0]);
    this.mesh.draw(this.frames, now, view, colours);
    this.canvas.begin();
    this.chosen.forEach((chosen, i) => {
      const corners = this.elements.corners(chosen).map((v) => place(this.frames.place(v, now)));
      const colour = i === 0 ? colours.a : colours.b;
      if (corners.length === 3) this.canvas.triangle(...corners, colour, 0.98, 0.001);
      corners.forEach((p, k) => {
        const q = corners[(k + 1) % corners.length];
        this.canvas.line(p, q, 4, colour, 1, 0.3);
        this.canvas.dot(p, 5, colour, 1, 0.31);
      });
    });
    const list = this.marks.near(this.frames, this.s);
    if (this.marksButton.getAttribute('aria-pressed') === 'true') {
      drawMarks(this.canvas, this.marks, list, place, colours);
    }
    this.canvas.end(false);
    this.plots.show(this.s, frame);
    this.panel.markStories(frame);
    this.say(frame, list);
    if (this.opened) keepInAddress(this.s, this.zoom, this.camera);
  }

  say(frame, list) {
    const {data, marks} = this;
    const counts = ['close', 'contact', 'crossing'].map((sort) => {
      const number = kMarkSorts.indexOf(sort);
      return [list.filter((i) => marks.sorts[i] === number).length, sort];
    });
    const told = counts.filter(([n]) => n > 0).map(([n, sort]) => `${this.word(sort)} ${n}`).join(', ');
    const time =
        data.unit ? `, ${Number(this.s.toPrecision(6))} ${data.unit}` : `, t = ${Number(this.s.toPrecision(9))}`;
    const near = this.frames.around(this.s).fraction > 0 ? 'Marks near this time' : 'Marks';
    const label = data.labels[frame] ? ` (${data.labels[frame]})` : '';
    this.readout.textContent = `${data.number} ${data.numbers[frame]}${label}${time}. ${near}: ${told || 'none'}.`;
  }
}

(() => {
  const parent = document.querySelector('.viewer');
  try {
    window.touchstoneAnimation = new AnimationViewer(parent, dataOf('animation'));
  } catch (error) {
    parent.classList.remove('live');
    parent.querySelectorAll('canvas, .controls').forEach((node) => node.remove());
    parent.append(element('p', {class: 'note'}, `A still picture: ${error.message}.`));
  }
})();
