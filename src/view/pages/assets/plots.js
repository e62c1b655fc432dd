// Plots over time that follow the slider, and set it. SPDX-License-Identifier: MIT

class Plots {
  /** changed(time): called when the reader points at a time. */
  constructor(parent, data, changed) {
    this.data = data;
    this.boxes = [...parent.querySelectorAll('.plotbox')].map((box) => {
      const svg = box.querySelector('svg');
      const cursor = document.createElementNS('http://www.w3.org/2000/svg', 'line');
      for (const [name, value] of [
               ['class', 'cursor'], ['y1', -3], ['y2', 103], ['vector-effect', 'non-scaling-stroke']])
        cursor.setAttribute(name, value);
      svg.append(cursor);
      const go = (event) => {
        const area = svg.getBoundingClientRect(), times = data.times, last = times[times.length - 1];
        const fraction = Math.max(0, Math.min(1, (event.clientX - area.left) / area.width));
        changed(times[0] + fraction * (last - times[0]));
      };
      svg.addEventListener('pointerdown', (event) => {
        svg.setPointerCapture(event.pointerId);
        go(event);
      });
      svg.addEventListener('pointermove', (event) => {
        if (event.buttons) go(event);
      });
      return {cursor, outputs: [...box.querySelectorAll('output')], series: data.plots[Number(box.dataset.plot)]};
    });
  }

  show(time, frame) {
    const times = this.data.times, length = times[times.length - 1] - times[0];
    const x = length > 0 ? 1000 * (time - times[0]) / length : 500;
    for (const {cursor, outputs, series} of this.boxes) {
      cursor.setAttribute('x1', x);
      cursor.setAttribute('x2', x);
      outputs.forEach((output, i) => output.textContent = shortScaled(series[i][frame], 0));
    }
  }
}
