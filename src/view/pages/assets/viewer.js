// The picture of one query: its stage, its controls and what they say. SPDX-License-Identifier: MIT

class Viewer {
  constructor(parent, picture, keepsState) {
    this.picture = picture;
    this.motion = new Motion(picture);
    this.zoom = 0;
    this.s = 0;
    this.coupled = true;
    this.build(parent);
    this.camera = new Camera(
        this.node, picture.basis, picture.planar, () => this.draw(), (steps) => this.zoomTo(this.zoom + steps));
    this.canvas = new ShapeCanvas(this.node);
    parent.classList.add('live');
    this.observer = new ResizeObserver(() => this.draw());
    this.observer.observe(this.node);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.draw());
    const state = keepsState ? stateOfAddress() : {from: []};
    this.camera.face(state.from);
    this.zoomTo(state.zoom || 0);
    this.timeline.open(state.t, 0);
    this.keepsState = keepsState;
  }

  /** Takes the picture away; the still one stays. */
  stop() {
    this.canvas.gl.getExtension('WEBGL_lose_context').loseContext();
    if (this.timeline.playing) this.timeline.toggle();
    this.observer.disconnect();
    this.canvas = null;
    removeControls(this.parent);
  }

  build(parent) {
    this.parent = parent;
    const stage = parent.querySelector('.stage');
    this.node = document.createElement('canvas');
    this.node.tabIndex = 0;
    this.node.setAttribute('role', 'img');
    this.node.setAttribute('aria-label', 'The two elements at the chosen time. Drag to turn, wheel or pinch to zoom.');
    this.labels = this.picture.names.map(
        (name, i) =>
            element('span', {class: 'label ' + (i < this.picture.first ? 'a' : 'b'), 'aria-hidden': 'true'}, name));
    this.legend = element('div', {class: 'legend'});
    this.bar = element('div', {class: 'bar'}, element('i', {}), element('span', {}));
    stage.append(this.node, ...this.labels, this.legend, this.bar);
    this.controls = element('div', {class: 'controls'});
    parent.append(this.controls);
    this.timeline = new Timeline(this.controls, this.picture.marks, (s) => {
      this.s = s;
      this.draw();
    });
    this.zoomSlider = element('input', {
      type: 'range',
      min: 0,
      max: this.picture.deepest,
      step: 0.25,
      'aria-label': 'zoom',
      oninput: () => this.zoomTo(Number(this.zoomSlider.value))
    });
    this.zoomText = element('output', {class: 'zoomtext'});
    const button = (text, title, action) => element('button', {type: 'button', title, onclick: action}, text);
    this.controls.append(element(
        'div', {class: 'row'}, element('label', {class: 'zoom'}, 'Zoom ', this.zoomSlider), this.zoomText,
        button('Whole step', 'Key 0', () => this.whole()), button('Meeting', 'Key M', () => this.meeting()),
        button('Save', 'A picture of what is seen, as PNG; key s', () => this.save())));
    this.readout = element('p', {class: 'readout', 'aria-live': 'polite'});
    this.controls.append(this.readout);
    this.node.addEventListener('keydown', (event) => this.key(event));
  }

  whole() {
    this.camera.reset();
    this.zoomTo(0);
  }

  save() {
    this.draw();
    savePicture(this.node);
  }

  /** To the time of the meeting, and as near as there is something to see. */
  meeting() {
    this.camera.reset();
    this.zoomTo(this.picture.apart ? this.picture.deepest - 3 : Math.min(60, this.picture.deepest));
    this.timeline.go(0);
  }

  key(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const turn = 0.1;
    const actions = {
      'ArrowLeft': () => event.shiftKey ? this.camera.turn(-turn, 0) : this.timeline.step(-1),
      'ArrowRight': () => event.shiftKey ? this.camera.turn(turn, 0) : this.timeline.step(1),
      'ArrowUp': () => event.shiftKey ? this.camera.turn(0, -turn) : this.zoomTo(this.zoom + 1),
      'ArrowDown': () => event.shiftKey ? this.camera.turn(0, turn) : this.zoomTo(this.zoom - 1),
      '+': () => this.zoomTo(this.zoom + 1),
      '-': () => this.zoomTo(this.zoom - 1),
      '0': () => this.whole(),
      'm': () => this.meeting(),
      's': () => this.save(),
      '[': () => this.timeline.jump(-1),
      ']': () => this.timeline.jump(1),
      ' ': () => this.timeline.toggle()
    };
    const action = actions[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!action) return;
    event.preventDefault();
    action();
  }

  /** The zoom, a power of two. The times go with it: the closest points pass through the view in the slider's range. */
  zoomTo(zoom) {
    this.zoom = Math.max(0, Math.min(this.picture.deepest, zoom));
    this.zoomSlider.value = this.zoom;
    this.zoomText.textContent = '2^' + this.zoom.toFixed(1).replace(/\.0$/, '');
    const speed = this.motion.speed(), reach = 2 * this.motion.radius * Math.pow(2, -this.zoom);
    const half = this.zoom < 1 || !(speed > 0) ? Infinity : reach / speed;
    const low = Math.max(this.motion.start, -half), high = Math.min(this.motion.end, half);
    this.s = Math.max(low, Math.min(high, this.s));
    this.timeline.s = this.s;
    this.timeline.range(low, high);
    this.draw();
  }

  /** The part of the first element's own motion that is shown: all of it, and nothing of it where the view is small. */
  share() { return Math.max(0, Math.min(1, 1 - this.zoom / 3)); }

  draw() {
    if (!this.canvas || !this.canvas.resize()) return;
    const canvas = this.canvas, motion = this.motion, s = this.s;
    const pixels = Math.min(canvas.width, canvas.height * 1.25) * 0.42 / motion.radius * Math.pow(2, this.zoom);
    const share = this.share();
    const shift = times(motion.middle, -share);
    const view = (p) => this.camera.seen(times(p, pixels));
    const offset = [this.camera.pan[0], this.camera.pan[1] + 10, 0];
    const place = (p) => added(view(p), offset);
    const footOf = (time) => added(times(motion.carrier(time), share), shift);
    const colours = {
      a: colourOf('--a'),
      b: colourOf('--b'),
      plane: colourOf('--plane'),
      ink: colourOf('--ink'),
      soft: colourOf('--soft')
    };
    canvas.begin();
    if (share > 0) {
      this.drawPaths(place, shift, share, colours);
      for (const time of [motion.start, motion.end])
        this.drawElements(view, place, footOf(time), time, 2, colours, 0.3);
    } else {
      this.drawPass(place, shift, colours);
    }
    const foot = footOf(s);
    this.drawPlane(place, foot, pixels, colours);
    this.drawElements(view, place, foot, s, 6, colours, 1);
    const gap = motion.gap(s), a = place(foot), b = place(added(foot, gap));
    canvas.line(a, b, 2, colours.ink, 1, 0.004);
    canvas.dot(a, 5, colours.ink, 1, 0.005);
    canvas.dot(b, 5, colours.ink, 1, 0.005);
    canvas.dot(a, 3, colours.a, 1, 0.006);
    canvas.dot(b, 3, colours.b, 1, 0.006);
    canvas.end();
    this.drawLabels(place, foot);
    this.say(gap, pixels);
    if (this.keepsState) keepInAddress(s, this.zoom, this.camera);
  }

  /** The second element has thinner lines, and lies before the first one: where they coincide, both are seen. */
  drawElements(view, place, foot, s, width, colours, alpha) {
    const first = this.picture.first, corners = this.picture.corners.map((_, i) => view(this.motion.corner(i, s)));
    const pen = penOf(width), thin = {...pen, width: 0.5 * width, lift: pen.lift + 4e-4};
    drawElement(this.canvas, place(foot), corners.slice(0, first), pen, colours.a, alpha);
    const b = place(added(foot, this.motion.gap(s)));
    drawElement(this.canvas, b, corners.slice(first), thin, colours.b, alpha);
  }

  drawPaths(place, shift, share, colours) {
    const motion = this.motion,
          straight = this.picture.denominator.length === 1 && this.picture.carrier.every((p) => p.length < 3);
    const steps = straight ? 1 : 40;
    let before = null;
    for (let i = 0; i <= steps; ++i) {
      const s = motion.start + (motion.end - motion.start) * i / steps;
      const foot = added(times(motion.carrier(s), share), shift);
      const now = motion.places(s).map((p) => place(added(p, foot)));
      if (before) now.forEach((p, k) => drawBorder(this.canvas, before[k], p, penOf(1.5), colours.soft, 0.9));
      before = now;
    }
  }

  /** The way of the second element's closest point past the first one's. */
  drawPass(place, shift, colours) {
    let before = null;
    for (let i = 0; i <= 24; ++i) {
      const s = this.timeline.low + (this.timeline.high - this.timeline.low) * i / 24;
      const now = place(added(this.motion.gap(s), shift));
      if (before) drawBorder(this.canvas, before, now, penOf(1.5), colours.soft, 0.9);
      before = now;
    }
  }

  drawPlane(place, foot, pixels, colours) {
    const plane = this.motion.plane(this.s);
    this.hasPlane = plane !== null;
    if (!plane) return;
    const size = Math.min(this.canvas.width, this.canvas.height) * 0.42 / pixels;
    // One side of the patch is along the screen, so that the patch looks alike from everywhere.
    let side = cross(plane.normal, this.camera.basis[2]);
    side = lengthOf(side) > 1e-6 ? unit(side) : this.camera.basis[0];
    const other = cross(plane.normal, side), middle = added(foot, plane.point);
    const corner = (x, y) => place(added(middle, added(times(side, x * size), times(other, y * size))));
    const patch = [corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)];
    this.canvas.triangle(patch[0], patch[1], patch[2], colours.plane, 0.2);
    this.canvas.triangle(patch[0], patch[2], patch[3], colours.plane, 0.2);
    patch.forEach((p, i) => this.canvas.line(p, patch[(i + 1) % 4], 1.5, colours.plane, 0.95));
  }

  /** The names stand beside their corners, and not on the edges. */
  drawLabels(place, foot) {
    const gap = this.motion.gap(this.s), first = this.picture.first, count = this.labels.length;
    const places = this.labels.map((_, i) => {
      const own = i < first ? foot : added(foot, gap);
      return place(added(own, this.motion.corner(i, this.s)));
    });
    const shown = [];
    this.labels.forEach((label, i) => {
      const p = places[i], own = i < first ? places.slice(0, first) : places.slice(first, count);
      const middle = [0, 1].map((k) => own.reduce((sum, q) => sum + q[k] / own.length, 0));
      const size = Math.hypot(p[0] - middle[0], p[1] - middle[1]);
      const out = size > 1e-3 ? [(p[0] - middle[0]) / size, (p[1] - middle[1]) / size] : [1, 0];
      // Across the edge: up for the first element, down for the second one.
      const up = (Math.abs(out[0]) > 1e-6 ? Math.sign(out[0]) : 1) * (i < first ? 1 : -1);
      const across = own.length > 2 ? [0, 0] : [-out[1] * up, out[0] * up];
      const far = own.length > 2 ? 20 : 12;
      let x = this.canvas.width / 2 + p[0] + far * out[0] + 15 * across[0];
      let y = this.canvas.height / 2 - p[1] - far * out[1] - 15 * across[1];
      while (shown.some((q) => Math.abs(q[0] - x) < 26 && Math.abs(q[1] - y) < 18)) y += 18;
      const visible = x > 12 && y > 12 && x < this.canvas.width - 12 && y < this.canvas.height - 12;
      label.style.display = visible ? '' : 'none';
      label.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px) translate(-50%, -50%)`;
      if (visible) shown.push([x, y]);
    });
  }

  say(gap, pixels) {
    const picture = this.picture, exponent = picture.exponent;
    const meeting = picture.contact ? 'the contact' : 'the closest approach';
    const since = this.s === 0 ? 'at ' + meeting :
                                 shortScaled(Math.abs(this.s), 0) + (this.s < 0 ? ' before ' : ' after ') + meeting;
    const distance = lengthOf(gap);
    const far = picture.contact && this.s === 0 && !picture.separation ?
        'the marked points meet' :
        `the marked points are ${shortScaled(distance, exponent)} apart`;
    this.readout.textContent = `t = ${(picture.t + this.s).toPrecision(12).replace(/\.?0+$/, '')}, ${since}; ${far}.`;
    const bar = 80;
    this.bar.firstChild.style.width = bar + 'px';
    this.bar.lastChild.textContent = shortScaled(bar / pixels, exponent);
    const entries =
        [['a', picture.names.slice(0, picture.first).join(' ')], ['b', picture.names.slice(picture.first).join(' ')]];
    if (this.hasPlane) entries.push(['plane', 'plane of the proof']);
    const text = entries.map((entry) => entry.join()).join();
    if (this.legend.dataset.text === text) return;
    this.legend.dataset.text = text;
    this.legend.replaceChildren(...entries.map(([sort, name]) => element('span', {class: sort}, name)));
  }
}

function removeControls(parent) {
  parent.classList.remove('live');
  parent.querySelectorAll('canvas, .label, .legend, .bar, .controls').forEach((node) => node.remove());
}

/** Makes the still pictures of the page live; they stay where there is no WebGL 2. */
function startViewer(parent, picture, keepsState = false) {
  try {
    return new Viewer(parent, picture, keepsState);
  } catch (error) {
    removeControls(parent);
    parent.append(element('p', {class: 'note'}, 'A still picture: ' + error.message + '.'));
    return null;
  }
}
