// Elements cut to what is near the view. Positions are in view coordinates. SPDX-License-Identifier: MIT
//
// A shape is given by one point of it, which is in or near the view, and by its corners relative to that point. At a
// deep zoom the corners are 2^100 views away. So whatever is near the view is computed from the point, and never as
// the difference of two large numbers.

const kReach = 4000;  // pixels

/** The largest fraction of the way from a point along an offset that stays near the view. */
function reachOf(from, offset) {
  let most = 1;
  for (let k = 0; k < 3; ++k) {
    if (offset[k] === 0) continue;
    const limit = ((offset[k] > 0 ? kReach : -kReach) - from[k]) / offset[k];
    if (limit < most) most = limit;
  }
  return most;
}

/** How lines and corners of an element are drawn: what is drawn wide lies before what is drawn thin. */
function penOf(width) { return {width, corner: 1.3 * width, lift: 4e-4 * width}; }

/** Draws the segment from a point to its end, relative to the point, as far as it is near the view. */
function drawRay(canvas, from, offset, pen, colour, alpha) {
  if (from.some((x) => Math.abs(x) > kReach)) return;
  canvas.line(from, added(from, times(offset, reachOf(from, offset))), pen.width, colour, alpha, pen.lift);
}

/** The polygon without its part beyond the limit of a coordinate. */
function cutPolygon(polygon, k, sign) {
  const result = [];
  polygon.forEach((p, i) => {
    const q = polygon[(i + 1) % polygon.length];
    const inP = sign * p[k] <= kReach, inQ = sign * q[k] <= kReach;
    if (inP) result.push(p);
    if (inP !== inQ) {
      const [near, far] = inP ? [p, q] : [q, p];
      const x = (sign * kReach - near[k]) / (far[k] - near[k]);
      result.push(near.map((c, j) => c + x * (far[j] - c)));
    }
  });
  return result;
}

/** Draws a triangle of one point of a face and two of its corners, relative to the point. */
function drawPart(canvas, from, a, b, colour, alpha) {
  let polygon = [from, added(from, a), added(from, b)];
  for (let k = 0; k < 3; ++k) polygon = cutPolygon(cutPolygon(polygon, k, 1), k, -1);
  for (let i = 2; i < polygon.length; ++i) canvas.triangle(polygon[0], polygon[i - 1], polygon[i], colour, alpha);
}

/**
 * Draws a point, an edge or a face. foot: a point of it. corners: relative to the foot. pen: the width of its lines,
 * the size of its corners, both in pixels, and the lift of both, as of canvas.line.
 */
function drawElement(canvas, foot, corners, pen, colour, alpha) {
  const reachable = foot.every((x) => Math.abs(x) <= kReach);
  if (corners.length === 2) {
    for (const corner of corners) drawRay(canvas, foot, corner, pen, colour, alpha);
  } else if (corners.length === 3) {
    corners.forEach((corner, i) => {
      const next = corners[(i + 1) % 3];
      if (reachable) drawPart(canvas, foot, corner, next, colour, 0.25 * alpha);
      const a = added(foot, corner), b = added(foot, next);
      drawBorder(canvas, a, b, pen, colour, alpha);
    });
  }
  corners.forEach((corner) => {
    const p = added(foot, corner);
    if (p.every((x) => Math.abs(x) <= kReach)) canvas.dot(p, pen.corner, colour, alpha, pen.lift + 1e-3);
  });
}

/** Draws a segment between two points, as far as it is near the view. */
function drawBorder(canvas, a, b, pen, colour, alpha) {
  let polygon = [a, b, b];
  for (let k = 0; k < 3; ++k) polygon = cutPolygon(cutPolygon(polygon, k, 1), k, -1);
  if (polygon.length < 2) return;
  let [p, q] = [polygon[0], polygon[0]];
  for (const r of polygon) {
    if (Math.hypot(r[0] - p[0], r[1] - p[1]) > Math.hypot(q[0] - p[0], q[1] - p[1])) q = r;
  }
  canvas.line(p, q, pen.width, colour, alpha, pen.lift);
}
