// A slider of time with marks, a play button, and the marks as buttons. SPDX-License-Identifier: MIT

const kSteps = 2000;

class Timeline {
  /** marks: {s, sort, text}; changed(s): called with each new time; more: {s, sort}, marks without a button. */
  constructor(parent, marks, changed, more = []) {
    this.marks = marks;
    this.all = more.concat(marks);
    this.changed = changed;
    this.low = 0;
    this.high = 1;
    this.s = 0;
    this.ticks = element('div', {class: 'ticks', 'aria-hidden': 'true'});
    this.slider = element('input', {
      type: 'range',
      min: 0,
      max: kSteps,
      step: 1,
      'aria-label': 'time',
      oninput: () => this.go(this.low + (this.high - this.low) * Number(this.slider.value) / kSteps)
    });
    this.play = element(
        'button', {type: 'button', class: 'play', 'aria-label': 'play', onclick: () => this.toggle()}, '\u25b6');
    this.chips = element('div', {class: 'chips', role: 'group', 'aria-label': 'marked times'});
    this.chipOf = marks.map((mark) => {
      const label = mark.text.split(':')[0];
      const chip = element(
          'button', {type: 'button', class: 'chip ' + mark.sort, title: mark.text, onclick: () => this.go(mark.s)},
          label);
      this.chips.append(chip);
      return chip;
    });
    parent.append(
        element('div', {class: 'timeline'}, this.play, element('div', {class: 'track'}, this.slider, this.ticks)),
        this.chips);
  }

  /** The range of times that the slider shows. */
  range(low, high) {
    this.low = low;
    this.high = high > low ? high : low;
    this.ticks.replaceChildren(...this.all.filter((mark) => mark.s >= low && mark.s <= high).map((mark) => {
      const tick = element('span', {class: 'tick ' + mark.sort});
      tick.style.left = this.fractionOf(mark.s) * 100 + '%';
      return tick;
    }));
    this.show();
  }

  fractionOf(s) { return this.high > this.low ? (s - this.low) / (this.high - this.low) : 0; }

  show() {
    const fraction = Math.max(0, Math.min(1, this.fractionOf(this.s)));
    this.slider.value = Math.round(fraction * kSteps);
    this.marks.forEach((mark, i) => this.chipOf[i].classList.toggle('here', mark.s === this.s));
  }

  go(s) {
    this.s = s;
    this.show();
    this.changed(s);
  }

  /** To the next mark, or the one before. */
  jump(direction) {
    const sorted = this.all.map((mark) => mark.s).sort((a, b) => a - b);
    const next = direction > 0 ? sorted.find((s) => s > this.s) : sorted.reverse().find((s) => s < this.s);
    if (next !== undefined) this.go(next);
  }

  step(steps) { this.go(Math.max(this.low, Math.min(this.high, this.s + (this.high - this.low) * steps / 100))); }

  /**
   * Opens at the time that is asked for. Otherwise it plays from the start to the meeting, and rests there; without a
   * meeting it plays to the end. Readers who prefer less motion see the meeting, or the start, at once.
   */
  open(asked, meeting) {
    if (asked !== undefined) return this.go(Math.max(this.low, Math.min(this.high, asked)));
    if (matchMedia('(prefers-reduced-motion: reduce)').matches || meeting <= this.low) {
      return this.go(meeting === undefined ? this.low : meeting);
    }
    this.go(this.low);
    this.toggle(meeting);
  }

  /** Plays, as far as a time if it begins before it, or pauses. */
  toggle(until = this.high) {
    this.playing = !this.playing;
    this.play.textContent = this.playing ? '\u275a\u275a' : '\u25b6';
    this.play.setAttribute('aria-label', this.playing ? 'pause' : 'play');
    if (!this.playing) return;
    let last = null;
    if (this.s >= this.high) this.s = this.low;
    const frame = (now) => {
      if (!this.playing) return;
      const passed = last === null ? 0 : (now - last) / 1000;
      last = now;
      const end = this.s < until ? Math.min(until, this.high) : this.high;
      const s = Math.min(end, this.s + passed * (this.high - this.low) / 5);
      this.go(s);
      if (s >= end) {
        this.toggle();
      } else {
        requestAnimationFrame(frame);
      }
    };
    requestAnimationFrame(frame);
  }
}
