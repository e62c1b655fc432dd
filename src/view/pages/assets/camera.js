// An orthographic camera that is turned, moved and zoomed by mouse, touch and keys. SPDX-License-Identifier: MIT

class Camera {
  /**
   * basis: right, up and towards the reader. flat: the picture lies in a plane, so dragging moves it.
   * changed: called after every change. zoomBy: called with the steps (powers of two) of a wheel or a pinch.
   */
  constructor(canvas, basis, flat, changed, zoomBy) {
    this.first = basis;
    this.flat = flat;
    this.changed = changed;
    this.reset();
    this.pointers = new Map();
    canvas.addEventListener('pointerdown', (event) => {
      canvas.setPointerCapture(event.pointerId);
      this.pointers.set(event.pointerId, [event.clientX, event.clientY]);
    });
    canvas.addEventListener('pointermove', (event) => this.moved(event, zoomBy));
    for (const name of ['pointerup', 'pointercancel']) {
      canvas.addEventListener(name, (event) => this.pointers.delete(event.pointerId));
    }
    canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      zoomBy(-Math.sign(event.deltaY) * Math.min(1, Math.abs(event.deltaY) / 100) * 0.5);
    }, {passive: false});
  }

  reset() {
    this.basis = this.first.map((row) => row.slice());
    this.pan = [0, 0];
  }

  moved(event, zoomBy) {
    const before = this.pointers.get(event.pointerId);
    if (!before) return;
    const now = [event.clientX, event.clientY];
    const others = [...this.pointers.entries()].filter(([id]) => id !== event.pointerId).map(([, p]) => p);
    this.pointers.set(event.pointerId, now);
    const dx = now[0] - before[0], dy = now[1] - before[1];
    if (others.length > 0) {
      const span = (p) => Math.hypot(p[0] - others[0][0], p[1] - others[0][1]);
      this.panBy(dx / 2, dy / 2);
      if (span(before) > 0 && span(now) > 0) zoomBy(Math.log2(span(now) / span(before)));
    } else if (this.flat || event.shiftKey || event.buttons === 4) {
      this.panBy(dx, dy);
    } else {
      this.turn(dx * 0.01, dy * 0.01);
    }
  }

  panBy(dx, dy) {
    this.pan[0] += dx;
    this.pan[1] -= dy;
    this.changed();
  }

  /** Turns the picture about the screen's vertical and horizontal axes, in radians. */
  turn(about_y, about_x) {
    if (this.flat) return;
    let [right, up, towards] = this.basis;
    const mix = (a, b, angle) =>
        [added(times(a, Math.cos(angle)), times(b, Math.sin(angle))),
         added(times(b, Math.cos(angle)), times(a, -Math.sin(angle)))];
    [right, towards] = mix(right, towards, about_y);
    [up, towards] = mix(up, towards, -about_x);
    towards = unit(towards);
    right = unit(added(right, times(towards, -dot(right, towards))));
    this.basis = [right, cross(towards, right), towards];
    this.changed();
  }

  /** Turns the picture about z, which stays as far up as it is. */
  turnUpright(angle) {
    const turned =
        ([x, y, z]) => [x * Math.cos(angle) - y * Math.sin(angle), x * Math.sin(angle) + y * Math.cos(angle), z];
    this.basis = this.basis.map(turned);
  }

  /** Turns to the directions of the screen's right and of the reader: six numbers, or nothing that is used. */
  face(numbers) {
    if (this.flat || numbers.length !== 6 || !numbers.every((x) => Math.abs(x) <= 1)) return;
    const right = numbers.slice(0, 3), towards = numbers.slice(3), up = cross(towards, right);
    if (Math.hypot(...up) < 0.5) return;
    this.basis = [unit(cross(up, towards)), unit(up), unit(towards)];
  }

  /** A vector in pixels, turned into the screen's axes. */
  seen(p) { return [dot(p, this.basis[0]), dot(p, this.basis[1]), dot(p, this.basis[2])]; }
}
