// The frames of an animation, decoded when they are looked at. SPDX-License-Identifier: MIT

/** The bytes of a script element in base64. */
function bytesOf(id) {
  const text = atob(document.getElementById(id).textContent);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes.buffer;
}

class Frames {
  constructor(data) {
    this.data = data;
    this.times = data.times;
    this.decoded = new Map();
  }

  get count() { return this.times.length; }

  /** The positions of a frame: steps of a lattice, whose spacing and origin are doubles. */
  at(i) {
    let frame = this.decoded.get(i);
    if (!frame) {
      if (this.decoded.size > 8) this.decoded.clear();
      frame = {
        steps: new Uint16Array(bytesOf('frame-' + i)),
        spacing: Math.pow(2, this.data.exponents[i]),
        origin: this.data.origins[i]
      };
      this.decoded.set(i, frame);
    }
    return frame;
  }

  /** The frame before a time, and the fraction of the way from it to the next one. */
  around(time) {
    let low = 0, high = this.count - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.times[middle] <= time) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    if (low === this.count - 1) return {frame: low, fraction: 0};
    return {frame: low, fraction: (time - this.times[low]) / (this.times[low + 1] - this.times[low])};
  }

  /** The frame whose marks belong to a time: the first one that is not before it. */
  ending(time) {
    const {frame, fraction} = this.around(time);
    return fraction > 0 ? frame + 1 : frame;
  }

  /** Where a vertex is drawn at a time. */
  place(vertex, {frame, fraction}) {
    const of = (i) => {
      const f = this.at(i);
      return [0, 1, 2].map((k) => f.origin[k] + f.spacing * f.steps[3 * vertex + k]);
    };
    const first = of(frame);
    if (!(fraction > 0)) return first;
    const second = of(frame + 1);
    return first.map((x, k) => x + fraction * (second[k] - x));
  }

  /** The exact coordinates of a vertex in a frame; nothing where the page has none. */
  exact(vertex, i) {
    if (!this.data.exact) return null;
    if (this.exactFrame !== i) {
      this.exactFrame = i;
      this.exactValues = new Float64Array(bytesOf('exact-' + i));
    }
    return Array.from(this.exactValues.subarray(3 * vertex, 3 * vertex + 3));
  }
}

/** The elements: corners by their numbers over all parts, and names by the numbers within a part. */
class Elements {
  constructor(data) {
    this.data = data;
    this.faces = new Uint32Array(bytesOf('faces'));
    this.edges = new Uint32Array(bytesOf('edges'));
    this.points = new Uint32Array(bytesOf('points'));
    this.faceNumbers = new Uint32Array(bytesOf('face-numbers'));
    this.bareEdges = Array.from(new Uint32Array(bytesOf('bare')));
    this.hues = new Uint8Array(bytesOf('hues'));
    this.radii = new Float32Array(bytesOf('radii'));
  }

  corners({sort, number}) {
    if (sort === 'face') return Array.from(this.faces.subarray(3 * number, 3 * number + 3));
    if (sort === 'edge') return Array.from(this.edges.subarray(2 * number, 2 * number + 2));
    return [number];
  }

  /** "edge 12 of body 2", or "edge 3-4" where edges have no numbers */
  name({sort, number}) {
    const data = this.data;
    const count = {vertex: 'vertices', edge: 'edges', face: 'faces'}[sort];
    let within = number, firstVertex = 0;
    for (const part of data.parts) {
      if (within >= part[count]) {
        within -= part[count];
        firstVertex += part.vertices;
        continue;
      }
      const of = part.name ? ` of ${part.name}` : '', first = part.firstNumber;
      if (sort === 'vertex') return `${data.vertexName} ${within + first}${of}`;
      if (sort === 'face') return `face ${data.facesHaveNumbers ? this.faceNumbers[number] : within + first}${of}`;
      if (data.edgesHaveNumbers) return `edge ${within}${of}`;
      return `edge ${this.corners({sort, number}).map((v) => v - firstVertex + first).join('-')}${of}`;
    }
    return '';
  }
}

const kElementSorts = ['vertex', 'edge', 'face'];
