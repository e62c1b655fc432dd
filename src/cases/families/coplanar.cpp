// Queries whose coplanarity cubic vanishes identically, or whose elements are parallel or degenerate.
// SPDX-License-Identifier: MIT
#include "families/makers.hpp"

namespace touchstone::families::makers {
namespace {

Linear linear(Rng& rng, int reach) {
  const double start = small(rng, reach);
  return {start, small(rng, reach)};
}

Vec3 nonzero_point(Rng& rng, int reach) {
  Vec3 v = lattice_point(rng, reach);
  while (v.x == 0 && v.y == 0 && v.z == 0) v = lattice_point(rng, reach);
  return v;
}

}  // namespace

Query planar_axis(Kind kind, Rng& rng) {
  Query query = lattice(kind, rng, rng.between(2, 4));
  const auto axis = static_cast<std::size_t>(rng.between(0, 2));
  const double level = rng.one_in(2) ? 0.0 : small(rng, 4);
  return mapped_corners(query, [&](Vec3 corner) {
    coordinate(corner, axis) = level;
    return corner;
  });
}

// Every corner is origin + alpha e + beta f with e and f fixed integer vectors.
Query planar_general(Kind kind, Rng& rng) {
  const Vec3 origin = lattice_point(rng, 3);
  const Vec3 e = nonzero_point(rng, 3);
  const Vec3 f = nonzero_point(rng, 3);
  std::array<Moving, 4> corners{};
  for (auto& corner : corners) {
    const Linear alpha = linear(rng, 3);
    corner = fixed(origin) + alpha * e + linear(rng, 3) * f;
  }
  return query_of(kind, corners);
}

// The plane spanned by e(t) and f turns while the corners stay in it: origin(t) + alpha e(t) + beta(t) f.
Query moving_plane(Kind kind, Rng& rng) {
  const Moving origin = lattice_motion(rng, 2);
  const Moving e = lattice_motion(rng, 2);
  const Vec3 f = nonzero_point(rng, 2);
  std::array<Moving, 4> corners{};
  for (auto& corner : corners) {
    const double alpha = small(rng, 2);
    corner = origin + alpha * e + linear(rng, 2) * f;
  }
  return query_of(kind, corners);
}

Query collinear(Kind kind, Rng& rng) {
  const Moving origin = lattice_motion(rng, 3);
  const Vec3 e = nonzero_point(rng, 2);
  std::array<Moving, 4> corners{};
  for (auto& corner : corners) corner = origin + linear(rng, 4) * e;
  return query_of(kind, corners);
}

// The line itself turns: origin(t) + alpha e(t).
Query moving_line(Kind kind, Rng& rng) {
  const Moving origin = lattice_motion(rng, 2);
  const Moving e = lattice_motion(rng, 2);
  std::array<Moving, 4> corners{};
  for (auto& corner : corners) corner = origin + small(rng, 3) * e;
  return query_of(kind, corners);
}

// The same particle is a corner of both elements, as between neighbours in a chain or mesh.
Query shared_corner(Kind kind, Rng& rng) {
  Query query = lattice(kind, rng, 4);
  const ElementSizes sizes = element_sizes(kind);
  const auto i = static_cast<std::size_t>(rng.between(0, static_cast<int>(sizes.a) - 1));
  const std::size_t j = sizes.a + static_cast<std::size_t>(rng.between(0, static_cast<int>(sizes.b) - 1));
  query.start[j] = query.start[i];
  query.end[j] = query.end[i];
  return query;
}

// Edges with one direction, a vertex that moves parallel to its face, points with one displacement; half of the time
// in one line or plane.
Query parallel(Kind kind, Rng& rng) {
  const Moving a = lattice_motion(rng, 3);
  const bool turning = rng.one_in(2);
  const Moving u = turning ? lattice_motion(rng, 3) : fixed(lattice_point(rng, 3));
  const Vec3 off = rng.one_in(2) ? Vec3{} : lattice_point(rng, 2);
  switch (kind) {
    case Kind::edge_edge: {
      const Moving apart = rng.one_in(2) ? fixed(off) : Moving{off, Vec3{} - off};
      const Moving c = a + small(rng, 2) * u + apart;
      return query_of(kind, {a, a + u, c, c + small(rng, 2) * u});
    }
    case Kind::vertex_face: {
      const Vec3 e = u.start;
      const Vec3 f = lattice_point(rng, 3);
      const Linear alpha = linear(rng, 2);
      const Moving v = a + fixed(off) + alpha * e + linear(rng, 2) * f;
      return query_of(kind, {v, a, a + fixed(e), a + fixed(f)});
    }
    case Kind::point_edge: {
      const Moving p = a + fixed(off) + linear(rng, 2) * u.start;
      return query_of(kind, {p, a, a + fixed(u.start), Moving{}});
    }
    case Kind::point_point: return query_of(kind, {a, a + fixed(off), Moving{}, Moving{}});
  }
  return {};
}

// A corner of one element slides along the other, on or beyond its ends.
Query sliding(Kind kind, Rng& rng) {
  const Moving a = lattice_motion(rng, 3);
  const Vec3 u = nonzero_point(rng, 3);
  const Linear along{0.25 * small(rng, 8), 0.25 * small(rng, 8)};
  const Moving slider = a + along * u;
  switch (kind) {
    case Kind::edge_edge: {
      const Moving other = rng.one_in(3) ? slider + small(rng, 2) * fixed(u) : lattice_motion(rng, 3);
      if (rng.one_in(2)) return query_of(kind, {a, a + fixed(u), other, slider});
      return query_of(kind, {slider, other, a, a + fixed(u)});
    }
    case Kind::vertex_face: {
      const Vec3 f = lattice_point(rng, 3);
      const Linear second{0.25 * small(rng, 6), 0.25 * small(rng, 6)};
      const Moving v = rng.one_in(2) ? slider : slider + second * f;
      return query_of(kind, {v, a, a + fixed(u), a + fixed(f)});
    }
    case Kind::point_edge: return query_of(kind, {slider, a, a + fixed(u), Moving{}});
    case Kind::point_point: return query_of(kind, {a, slider, Moving{}, Moving{}});
  }
  return {};
}

// Zero-length edges and flat triangles: all the time, at one end, or for one instant.
Query flat(Kind kind, Rng& rng) {
  Query query = lattice(kind, rng, rng.between(1, 4));
  const ElementSizes sizes = element_sizes(kind);
  const auto collapse = [&](std::size_t i, std::size_t j) {  // corner j falls onto corner i
    const int when = rng.between(0, 3);
    if (when != 1) query.start[j] = query.start[i];
    if (when != 2) query.end[j] = query.end[i];
    if (when == 3) {  // at t = 1/2 only
      const Vec3 d = lattice_point(rng, 2);
      query.start[j] = query.start[i] + d;
      query.end[j] = query.end[i] - d;
    }
  };
  if (sizes.a == 2 && rng.one_in(2)) collapse(0, 1);
  if (sizes.b == 2 && (sizes.a == 1 || rng.one_in(2))) collapse(sizes.a, sizes.a + 1);
  if (sizes.b == 3) {
    switch (rng.between(0, 3)) {
      case 0: collapse(1, 2); break;
      case 1: collapse(3, 1); break;
      case 2:
        collapse(1, 2);
        collapse(1, 3);
        break;
      default: {  // three corners in one line
        const double fraction = 0.5 * small(rng, 4);
        query.start[3] = query.start[1] + fraction * (query.start[2] - query.start[1]);
        query.end[3] = query.end[1] + fraction * (query.end[2] - query.end[1]);
      }
    }
  }
  return query;
}

}  // namespace touchstone::families::makers
