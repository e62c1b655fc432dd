// What is told about a clicked element: its number, its exact coordinates, and the stories of its pairs.
// SPDX-License-Identifier: MIT

const kMostPairsShown = 50;

class ElementPanel {
  /** shown: called with an element, or with a pair and a time, that the reader chooses in the panel. */
  constructor(node, viewer) {
    this.node = node;
    this.viewer = viewer;
    this.list = [...document.querySelectorAll('.events button')];
    this.list.forEach((button, i) => button.addEventListener('click', () => viewer.goToStory(i)));
  }

  timeText(time) {
    const {unit} = this.viewer.data;
    return Number(time.toPrecision(9)) + (unit ? ' ' + unit : '');
  }

  /** The coordinates of corners in the frame at the slider: exact ones where the page has them. */
  coordinates(corners) {
    const {frames, data} = this.viewer, i = frames.ending(this.viewer.s);
    const isFrame = frames.times[i] === this.viewer.s;
    const rows = corners.map((v) => {
      const exact = frames.exact(v, i);
      const text = exact ?
          exact.map(hexfloat).join(' ') :
          frames.place(v, {frame: i, fraction: 0}).map((x) => '~' + Number(x.toPrecision(6))).join(' ');
      return element(
          'tr', {}, element('th', {scope: 'row'}, this.viewer.elements.name({sort: 'vertex', number: v})),
          element('td', {}, element('code', {}, text)));
    });
    const heading = (data.exact ? 'Exact coordinates at ' : 'Rounded coordinates at ') + data.number + ' ' +
        data.numbers[i] + (isFrame ? '' : ', the end of this move');
    return [element('h3', {}, heading), element('table', {class: 'coordinates'}, ...rows)];
  }

  pairName(pair) { return this.viewer.marks.pairElements(pair).map((e) => this.viewer.elements.name(e)).join(' and '); }

  /** A line that leads to the first mark of a pair. */
  pairLine({pair, marks}) {
    const all = this.viewer.marks, count = (sort) => marks.filter((i) => all.sort(i) === sort).length;
    const counts = [['crossing', this.viewer.word('crossing') + 's'], ['contact', 'contacts'], ['close', 'times close']]
                       .map(([sort, words]) => [count(sort), words])
                       .filter(([n]) => n > 0)
                       .map(([n, words]) => `${n} ${words}`);
    const best = marks.find((i) => all.sort(i) !== 'close');
    const first = best === undefined ? marks[0] : best;
    return element(
        'button', {type: 'button', class: 'link', onclick: () => this.viewer.goToMark(first)},
        `${this.pairName(pair)}: ${counts.join(', ')}, first at ${this.timeText(all.times[first])}`);
  }

  showElement(chosen) {
    const {elements, marks} = this.viewer, corners = elements.corners(chosen);
    const pairs = marks.of(chosen);
    this.show(
        elements.name(chosen), ...this.coordinates(corners),
        element('h3', {}, pairs.length === 0 ? 'It is in no marked pair.' : `Marked pairs: ${pairs.length}`),
        ...pairs.slice(0, kMostPairsShown).map((pair) => this.pairLine(pair)),
        ...(pairs.length > kMostPairsShown ? [element('p', {}, `${pairs.length - kMostPairsShown} more pairs`)] : []));
  }

  showPair(pair) {
    const {marks, elements} = this.viewer, both = marks.pairElements(pair), found = marks.ofPair(pair);
    const times = found.slice(0, kMostPairsShown)
                      .map(
                          (i) => element(
                              'button', {type: 'button', class: 'link', onclick: () => this.viewer.goToMark(i)},
                              `${this.viewer.word(marks.sort(i))} at ${this.timeText(marks.times[i])}`));
    const story = this.viewer.data.stories.findIndex((s) => s.pair === pair);
    const told = story < 0 ? null : this.list[story].parentNode.querySelector('details').cloneNode(true);
    if (told) told.open = true;
    this.show(
        this.pairName(pair), ...this.coordinates(both.flatMap((e) => elements.corners(e))),
        element('h3', {}, 'Marks of this pair'), ...times,
        ...(found.length > kMostPairsShown ? [element('p', {}, `${found.length - kMostPairsShown} more marks`)] : []),
        ...(told ? [told] : []));
  }

  show(heading, ...content) {
    this.node.hidden = false;
    this.node.replaceChildren(element('h2', {}, heading), ...content);
  }

  clear() {
    this.node.hidden = true;
    this.node.replaceChildren();
  }

  markStories(frame) {
    const {frames, data} = this.viewer;
    this.list.forEach((button, i) => button.classList.toggle('here', frames.ending(data.stories[i].time) === frame));
  }
}
