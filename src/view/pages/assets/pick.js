// Which element lies under a point of the picture. SPDX-License-Identifier: MIT

const kPickReach = 6;  // pixels, from edges and points

/** The distance of a point from a segment in the plane, and where along the segment it is nearest. */
function distanceToSegment(x, y, ax, ay, bx, by) {
  const dx = bx - ax, dy = by - ay, square = dx * dx + dy * dy;
  const t = square > 0 ? Math.max(0, Math.min(1, ((x - ax) * dx + (y - ay) * dy) / square)) : 0;
  return {t, distance: Math.hypot(ax + t * dx - x, ay + t * dy - y)};
}

/** Where the vertices are on the screen: pixels to the right, up and towards the reader. */
function seenVertices(frames, elements, now, view) {
  const count = elements.data.vertices;
  const a = frames.at(now.frame), b = now.fraction > 0 ? frames.at(now.frame + 1) : a, f = now.fraction;
  const px = new Float64Array(count), py = new Float64Array(count), pz = new Float64Array(count);
  const [r, u, t] = view.basis;
  for (let i = 0; i < count; ++i) {
    const p = [0, 0, 0];
    for (let k = 0; k < 3; ++k) {
      const from = a.origin[k] + a.spacing * a.steps[3 * i + k], to = b.origin[k] + b.spacing * b.steps[3 * i + k];
      p[k] = (from + f * (to - from) - view.centre[k]) * view.pixels;
    }
    px[i] = p[0] * r[0] + p[1] * r[1] + p[2] * r[2] + view.pan[0];
    py[i] = p[0] * u[0] + p[1] * u[1] + p[2] * u[2] + view.pan[1];
    pz[i] = p[0] * t[0] + p[1] * t[1] + p[2] * t[2];
  }
  return {px, py, pz};
}

/** The face nearest to the reader at (x, y), in pixels from the middle, y up, and how near: {face, front}. */
function frontFace(elements, {px, py, pz}, x, y) {
  let face = null, front = -Infinity;
  for (let i = 0; i < elements.faces.length; i += 3) {
    const [p, q, s] = [elements.faces[i], elements.faces[i + 1], elements.faces[i + 2]];
    const area = (px[q] - px[p]) * (py[s] - py[p]) - (px[s] - px[p]) * (py[q] - py[p]);
    if (area === 0) continue;
    const wq = ((x - px[p]) * (py[s] - py[p]) - (px[s] - px[p]) * (y - py[p])) / area;
    const ws = ((px[q] - px[p]) * (y - py[p]) - (x - px[p]) * (py[q] - py[p])) / area;
    if (wq < 0 || ws < 0 || wq + ws > 1) continue;
    const z = pz[p] + wq * (pz[q] - pz[p]) + ws * (pz[s] - pz[p]);
    if (z > front) {
      front = z;
      face = {sort: 'face', number: i / 3};
    }
  }
  return {face, front};
}

/**
 * The element nearest to the reader at (x, y), in pixels from the middle, y up: {sort, number, point}; or null.
 * Points come before edges, and edges without a face or near the pointer before faces, where they are not hidden.
 */
function pickElement(frames, elements, now, view, x, y) {
  const seen = seenVertices(frames, elements, now, view), {px, py, pz} = seen;
  const {face, front} = frontFace(elements, seen, x, y);
  let best = null, least = kPickReach;
  const consider = (sort, number, distance, z) => {
    if (distance < least && z > front - kPickReach) {
      least = distance;
      best = {sort, number};
    }
  };
  for (const v of elements.points) consider('vertex', v, Math.hypot(px[v] - x, py[v] - y), pz[v]);
  if (best) return best;
  const isThin = elements.bareEdges.length * 2 === elements.edges.length;
  if (!isThin) least = kPickReach / 2;
  for (let i = 0; i < elements.edges.length; i += 2) {
    const [p, q] = [elements.edges[i], elements.edges[i + 1]];
    const {t: along, distance} = distanceToSegment(x, y, px[p], py[p], px[q], py[q]);
    consider('edge', i / 2, distance, pz[p] + along * (pz[q] - pz[p]));
  }
  return best || face;
}
