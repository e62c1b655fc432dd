// Queries that are built from the places of V's roots: double and triple, irrational and on a corner, beside 0 and 1,
// and where the elements are parallel.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <utility>

#include "families/makers.hpp"

namespace touchstone::families::makers {
namespace {

// Axes permuted and reflected: exact, and keeps every property of a query.
Query turned(Query query, Rng& rng) {
  std::array<std::size_t, 3> axes{0, 1, 2};
  std::swap(axes[0], axes[static_cast<std::size_t>(rng.between(0, 2))]);
  std::swap(axes[1], axes[static_cast<std::size_t>(rng.between(1, 2))]);
  const Vec3 signs{rng.one_in(2) ? 1.0 : -1.0, rng.one_in(2) ? 1.0 : -1.0, rng.one_in(2) ? 1.0 : -1.0};
  return mapped_corners(query, [&](const Vec3& corner) {
    Vec3 result;
    for (std::size_t i = 0; i < 3; ++i) {
      coordinate(result, i) = coordinate(signs, i) * coordinate(corner, axes[i]) + 0.0;  // + 0.0: no -0.0
    }
    return result;
  });
}

// Three integer vectors of determinant 1 or -1.
std::array<Vec3, 3> integer_basis(Rng& rng) {
  std::array<Vec3, 3> basis{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (int step = rng.between(0, 3); step > 0; --step) {
    const auto to = static_cast<std::size_t>(rng.between(0, 2));
    const std::size_t from = (to + static_cast<std::size_t>(rng.between(1, 2))) % 3;
    basis[to] = basis[to] + static_cast<double>(rng.between(-2, 2)) * basis[from];
  }
  return basis;
}

}  // namespace

// With s = k (t - time), u = (1, s, 0), w = (0, 1, s) and r = f u + g w + (c, 0, d):  V = (u x w) . r = c s^2 + d.
// A constant c gives a double root at s = 0 when d is zero, two roots just apart when c d < 0, none when c d > 0;
// c proportional to s with d = e s gives c' s^3 + e s, a triple root when e is zero.
// Point-edge: u = (1, s, 0) and r = (1/2 + h s, s/2 + d, 0) give (u x r)_z = d - h s^2 in the same way.
Sample grazing(Kind kind, Rng& rng, Graze graze) {
  const double time = rng.between(0, 8) / 8.0;
  const double direction = rng.one_in(2) ? 1.0 : -1.0;
  const double speed = std::ldexp(direction, rng.between(0, 3));
  const Linear s{-speed * time, speed * (1 - time)};
  const Vec3 ex{1, 0, 0}, ey{0, 1, 0}, ez{0, 0, 1};
  const bool extreme = rng.one_in(4);  // then the tiny number stands alone in its coordinate
  const double tiny = std::ldexp(1.0, extreme ? -rng.between(47, 1060) : -rng.between(4, 46));
  const double sign = rng.one_in(2) ? 1.0 : -1.0;
  const double curve = sign * 0.25;
  const double gap = graze == Graze::apart ? -sign * tiny : graze == Graze::gone ? sign * tiny : 0;
  Moving origin = lattice_motion(rng, 2);
  if (extreme) origin.start.z = origin.end.z = 0;

  const bool triple = graze == Graze::triple;
  const double split = rng.one_in(2) ? 0 : (rng.one_in(2) ? tiny : -tiny);
  const Moving bend = triple ? Linear{curve * s.start, curve * s.end} * ex + Linear{split * s.start, split * s.end} * ez
                             : fixed(curve * ex + gap * ez);
  const Moving u = fixed(ex) + s * ey;
  const Moving w = fixed(ey) + s * ez;
  const double g = extreme ? 0 : rng.between(1, 2) / 4.0;
  std::optional<double> touches_at;
  if (graze == Graze::merged || triple) touches_at = time;
  switch (kind) {
    case Kind::edge_edge: {
      const Moving c = origin + rng.between(1, 3) / 4.0 * u - g * w + bend;
      return {turned(query_of(kind, {origin, origin + u, c, c + w}), rng), touches_at};
    }
    case Kind::vertex_face: {
      const Moving v = origin + 0.25 * u + g * w + bend;
      return {turned(query_of(kind, {v, origin, origin + u, origin + w}), rng), touches_at};
    }
    case Kind::point_edge: {
      const Linear height{s.start / 2 - gap, s.end / 2 - gap};
      Moving p = origin + fixed(0.5 * ex) + Linear{curve * s.start, curve * s.end} * ex + height * ey;
      if (triple) p = p + Linear{split * s.start, split * s.end} * ez;
      return {turned(query_of(kind, {p, origin, origin + u, Moving{}}), rng), touches_at};
    }
    case Kind::point_point: {
      const Moving q = origin + s * ex + s * ey + fixed(gap * ey);
      return {turned(query_of(kind, {origin, q, Moving{}, Moving{}}), rng), touches_at};
    }
  }
  return {};
}

// Three corners move in one plane and the fourth does not: V is its height times the area of the three, whose roots,
// of a quadratic, put a corner on an edge at times that are irrational as a rule.
Query irrational_joint(Kind kind, Rng& rng) {
  const std::array<Vec3, 3> basis = integer_basis(rng);
  const auto off_plane = static_cast<std::size_t>(rng.between(0, 3));
  const Query flat = lattice(kind, rng, rng.between(2, 5));
  const Moving height = lattice_motion(rng, 3);
  std::array<Moving, 4> corners{};
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    corners[i] = Linear{flat.start[i].x, flat.end[i].x} * basis[0] + Linear{flat.start[i].y, flat.end[i].y} * basis[1];
    if (i == off_plane) corners[i] = corners[i] + Linear{height.start.x, height.end.x} * basis[2];
  }
  return query_of(kind, corners);
}

// The two elements move in parallel planes: V is the distance of the planes times n's only component, and at the roots
// of that one the edges are parallel or the face is flat.
Query layers(Kind kind, Rng& rng) {
  Query query = lattice(kind, rng, rng.between(2, 5));
  const Moving heights = lattice_motion(rng, rng.between(1, 4));
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    const bool in_a = i < element_sizes(kind).a;
    query.start[i].z = in_a ? heights.start.x : heights.start.y;
    query.end[i].z = in_a ? heights.end.x : heights.end.y;
  }
  return turned(query, rng);
}

// Elements in two parallel planes that meet so soon after 0, or so shortly before 1, that the time is no double, or a
// subnormal one.
Query extreme_time(Kind kind, Rng& rng) {
  Query query = lattice(kind, rng, rng.between(1, 3));
  // One call of rng a statement: compilers evaluate the arguments of a call in different orders.
  const int exponent = rng.one_in(2) ? -rng.between(50, 80) : -rng.between(1000, 1074);
  const double tiny = std::ldexp(rng.between(1, 7), exponent);
  const double fast = std::ldexp(1.0, rng.one_in(4) ? rng.between(0, 1000) : 0);
  const bool at_start = rng.one_in(2);
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    const bool moves = i >= element_sizes(kind).a;
    if (rng.one_in(2)) query.end[i] = query.start[i];
    query.start[i].z = !moves ? 0 : at_start ? -tiny : -fast;
    query.end[i].z = !moves ? 0 : at_start ? fast : tiny;
  }
  return turned(query, rng);
}

// Layers whose planes meet at 0, at 1 or at the double before or after one of them. That double is no difference of two
// doubles, so both elements move: b from -time to 1 and a from 0 to time, which makes their distance t - time.
Query beside_ends(Kind kind, Rng& rng) {
  static constexpr std::array<double, 6> times{0, 0x1p-1074, -0x1p-1074, 1, 1 - 0x1p-53, 1 + 0x1p-52};
  const double time = rng.pick(times);
  Query query = lattice(kind, rng, rng.between(1, 2));
  const bool standing = !rng.one_in(4);  // in the plane, so that the elements lie over each other at the root, or not
  const bool joined = rng.one_in(kind == Kind::point_point ? 2 : 4);
  const std::size_t first_of_b = element_sizes(kind).a;
  if (joined) query.start[first_of_b] = query.start[0];
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    if (standing) query.end[i] = query.start[i];
    query.start[i].z = i < first_of_b ? 0 : -time;
    query.end[i].z = i < first_of_b ? time : 1;
  }
  return turned(query, rng);
}

}  // namespace touchstone::families::makers
