// The motion of a query's picture: positions in the time s since the meeting. SPDX-License-Identifier: MIT

class Motion {
  constructor(picture) {
    this.picture = picture;
    const marks = picture.marks;
    this.start = marks[0].s;
    this.end = marks[marks.length - 1].s;
    // The world: what all corners ever touch, relative to the place of the meeting.
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i <= 32; ++i) {
      const s = this.start + (this.end - this.start) * i / 32;
      const carrier = this.carrier(s);
      for (const p of this.places(s)) {
        added(p, carrier).forEach((x, k) => {
          low[k] = Math.min(low[k], x);
          high[k] = Math.max(high[k], x);
        });
      }
    }
    this.middle = times(added(low, high), 0.5);
    this.radius = Math.max(lengthOf(added(high, times(low, -1))) / 2, 1e-9);
  }

  over(vector, s) { return times(vectorOf(vector, s), 1 / valueOf(this.picture.denominator, s)); }

  /** The first element's closest point relative to its place at the meeting. */
  carrier(s) { return this.over(this.picture.carrier, s); }

  /** The second element's closest point relative to the first one's. */
  gap(s) { return this.over(this.picture.gap, s); }

  /** A corner relative to the closest point of its own element. */
  corner(i, s) { return this.over(this.picture.corners[i], s); }

  /** All corners relative to the first element's closest point. */
  places(s) {
    const gap = this.gap(s);
    return this.picture.corners.map((_, i) => {
      const corner = this.corner(i, s);
      return i < this.picture.first ? corner : added(corner, gap);
    });
  }

  /** How fast the closest points pass each other at the meeting. */
  speed() {
    const g = this.picture.gap;
    return Math.hypot(...g.map((p) => p[1] || 0));
  }

  /** The plane of the proof at a time: its unit normal and a point of it; nothing where there is none. */
  plane(s) {
    const piece = this.picture.planes.find((p) => s < p.untilS || (s === p.untilS && !this.picture.contact));
    if (!piece) return null;
    const normal = vectorOf(piece.normal, s), size = lengthOf(normal);
    if (!(size > 0)) return null;
    const w = valueOf(this.picture.denominator, s);
    const heights = piece.offsets.map((p) => valueOf(p, s) / w / size);
    const first = heights.slice(0, this.picture.first), second = heights.slice(this.picture.first);
    const below = Math.max(...first) <= Math.min(...second);
    const height =
        below ? (Math.max(...first) + Math.min(...second)) / 2 : (Math.min(...first) + Math.max(...second)) / 2;
    const direction = times(normal, 1 / size), half = times(this.gap(s), 0.5);
    return {normal: direction, point: added(half, times(direction, height - dot(direction, half)))};
  }
}
