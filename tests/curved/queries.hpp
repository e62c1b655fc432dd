// Seeded curved queries, random and degenerate, and their text.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <string>

#include <touchstone/curved_query.hpp>

#include "seeded/rng.hpp"
#include "support/query_text.hpp"

namespace touchstone::tests {

using seeded::Rng;

inline double small(Rng& rng, int size) { return rng.between(-size, size); }
inline Vec3 lattice(Rng& rng, int size) {
  const double x = small(rng, size), y = small(rng, size), z = small(rng, size);
  return {x, y, z};
}

inline std::array<double, 4> lattice_quaternion(Rng& rng, int size) {
  std::array<double, 4> q{};
  while (q == std::array<double, 4>{}) {
    for (double& c : q) c = small(rng, size);
  }
  return q;
}

/// Without a quaternion that vanishes on the way.
inline RigidMotion lattice_motion(Rng& rng, int size) {
  RigidMotion motion;
  motion.q0 = lattice_quaternion(rng, size);
  motion.q1 = rng.one_in(4) ? motion.q0 : lattice_quaternion(rng, size);
  double dot = 0;
  for (std::size_t i = 0; i < 4; ++i) dot += motion.q0[i] * motion.q1[i];
  if (dot < 0) {
    for (double& c : motion.q1) c = -c;
  }
  motion.p0 = lattice(rng, size);
  motion.p1 = rng.one_in(2) ? motion.p0 : lattice(rng, size);
  return motion;
}

inline CurvedCorner lattice_curve(Rng& rng, int size) {
  CurvedCorner corner;
  corner.control_points = rng.between(1, 4);
  for (Vec3& point : corner.points) point = lattice(rng, size);
  return corner;
}

/// Everything on small integers, where coincidences of every sort happen by chance.
inline CurvedQuery lattice_query(Kind kind, Rng& rng) {
  const int size = rng.between(1, 2);
  CurvedQuery query;
  query.kind = kind;
  for (RigidMotion& motion : query.motions) motion = lattice_motion(rng, size);
  if (rng.one_in(3)) query.motions[1] = query.motions[0];
  const int way = rng.between(0, 3);
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    const bool second = kind == Kind::edge_edge ? i >= 2 : i >= 1;
    const int motion = way == 3 ? rng.between(0, 2) : second ? 1 : 0;
    const bool on_curve = way == 0 || (way == 1 && second);
    query.corners[i] = on_curve ? lattice_curve(rng, size) : CurvedCorner::on_body(motion, lattice(rng, size));
  }
  return query;
}

/// All in the plane z = 0, turning about z: gears. V is identically zero.
inline CurvedQuery gear_query(Kind kind, Rng& rng) {
  CurvedQuery query;
  query.kind = kind;
  for (RigidMotion& motion : query.motions) {
    motion.q0 = {static_cast<double>(rng.between(1, 3)), 0, 0, small(rng, 2)};
    motion.q1 = {static_cast<double>(rng.between(0, 2)), 0, 0, static_cast<double>(rng.between(1, 3))};
    motion.p0 = {small(rng, 3), small(rng, 3), 0};
    motion.p1 = rng.one_in(2) ? motion.p0 : Vec3{small(rng, 3), small(rng, 3), 0};
  }
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    const bool second = kind == Kind::edge_edge ? i >= 2 : i >= 1;
    query.corners[i] = CurvedCorner::on_body(second ? 1 : 0, {small(rng, 4), small(rng, 4), 0});
  }
  return query;
}

/// A body that turns about z and moves along z, against one at rest or on the same screw.
inline CurvedQuery screw_query(Kind kind, Rng& rng) {
  CurvedQuery query = gear_query(kind, rng);
  for (std::size_t m = 0; m < 2; ++m) {
    query.motions[m].p0 = {0, 0, small(rng, 2)};
    query.motions[m].p1 = {0, 0, small(rng, 2)};
  }
  if (rng.one_in(2)) query.motions[1] = RigidMotion();
  if (rng.one_in(4)) query.motions[1] = query.motions[0];
  for (std::size_t i = 0; i < corner_count(kind); ++i) query.corners[i].points[0].z = small(rng, 1);
  return query;
}

/// A coin of radius 5 with its rim's points at multiples of pi / 2 and of the angle of (3, 4), that turns about its
/// axis y as it moves over the floor z = 0. It touches the floor with its lowest point, or passes just above it.
inline CurvedQuery coin_query(Kind kind, Rng& rng) {
  static constexpr std::array<Vec3, 8> kRim = {
      {{5, 0, 0}, {4, 0, 3}, {3, 0, 4}, {0, 0, 5}, {-3, 0, -4}, {0, 0, -5}, {4, 0, -3}, {3, 0, -4}}};
  CurvedQuery query;
  query.kind = kind;
  RigidMotion& coin = query.motions[0];
  coin.q0 = {static_cast<double>(rng.between(1, 3)), 0, small(rng, 1), 0};
  coin.q1 = {static_cast<double>(rng.between(0, 2)), 0, static_cast<double>(rng.between(1, 3)), 0};
  const double height = rng.one_in(4) ? std::nextafter(5, rng.one_in(2) ? 6 : 4) : 5;
  coin.p0 = {small(rng, 4), 0, height};
  coin.p1 = {small(rng, 4), small(rng, 1), rng.one_in(4) ? 4.0 : height};
  const Vec3 rim = rng.pick(kRim);
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    const bool second = kind == Kind::edge_edge ? i >= 2 : i >= 1;
    const Vec3 floor = {8 * small(rng, 2), 8 * small(rng, 2), 0};
    query.corners[i] =
        second ? CurvedCorner::on_curve({floor}) : CurvedCorner::on_body(0, i == 0 ? rim : rng.pick(kRim));
  }
  return query;
}

/// Bodies that turn about an axis by an angle of which cosine and sine are 3/5 and 4/5 at t = 1/2, when a corner, or
/// the middle of an edge, of each element meet; or nearly.
inline CurvedQuery meeting_query(Kind kind, Rng& rng) {
  CurvedQuery query;
  query.kind = kind;
  std::array<std::size_t, 2> axes{};
  std::array<double, 2> ways{};
  for (std::size_t m = 0; m < 2; ++m) {
    axes[m] = static_cast<std::size_t>(rng.between(0, 2));
    ways[m] = rng.between(-1, 1);
    query.motions[m].q1[1 + axes[m]] = ways[m];
  }
  std::array<Vec3, 4> at_half;
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    const std::size_t m = (kind == Kind::edge_edge ? i >= 2 : i >= 1) ? 1 : 0;
    const double x[3] = {5 * small(rng, 2), 5 * small(rng, 2), 5 * small(rng, 2)};
    query.corners[i] = CurvedCorner::on_body(static_cast<int>(m), {x[0], x[1], x[2]});
    const double cosine = ways[m] == 0 ? 1 : 0.6, sine = 0.8 * ways[m];
    const std::size_t k = axes[m], j = (k + 1) % 3, l = (k + 2) % 3;
    double y[3] = {x[0], x[1], x[2]};
    y[j] = std::round(cosine * x[j] - sine * x[l]);  // integers, but for the rounding of 0.6 and 0.8
    y[l] = std::round(sine * x[j] + cosine * x[l]);
    at_half[i] = {y[0], y[1], y[2]};
  }
  const auto place = [&](std::size_t first, std::size_t last) {
    const Vec3 &a = at_half[first], &b = at_half[last];
    return rng.one_in(2) ? a : Vec3{(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
  };
  const std::size_t second = kind == Kind::edge_edge ? 2 : 1;
  const Vec3 from = place(0, second - 1), to = place(second, corner_count(kind) - 1);
  const Vec3 way = lattice(rng, 4);
  query.motions[1].p0 = {from.x - to.x + way.x, from.y - to.y + way.y, from.z - to.z + way.z};
  query.motions[1].p1 = {from.x - to.x - way.x, from.y - to.y - way.y, from.z - to.z - way.z};
  if (rng.one_in(4)) query.motions[1].p1.z += (rng.one_in(2) ? 1 : -1) * 0x1p-45;
  return query;
}

/// Doubles of ordinary size with all their digits, built so that the elements often meet.
inline CurvedQuery random_query(Kind kind, Rng& rng) {
  CurvedQuery query;
  query.kind = kind;
  const auto vector = [&](double size) {
    const double x = size * rng.symmetric(), y = size * rng.symmetric(), z = size * rng.symmetric();
    return Vec3{x, y, z};
  };
  for (RigidMotion& motion : query.motions) {
    for (double& c : motion.q0) c = rng.symmetric();
    double dot = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      motion.q1[i] = rng.symmetric();
      dot += motion.q0[i] * motion.q1[i];
    }
    if (dot < 0) {
      for (double& c : motion.q1) c = -c;
    }
    motion.p0 = vector(0.5);
    motion.p1 = vector(0.5);
  }
  const bool curves = rng.one_in(3);
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    const bool second = kind == Kind::edge_edge ? i >= 2 : i >= 1;
    query.corners[i] = CurvedCorner::on_body(second ? 1 : 0, vector(2));
    if (!curves || !second) continue;
    query.corners[i].motion = CurvedCorner::kOnCurve;
    query.corners[i].control_points = rng.between(1, 4);
    for (Vec3& point : query.corners[i].points) point = vector(2);
  }
  return query;
}

inline std::string text_of(const CurvedQuery& query) { return curved_text(query); }

/// Makes a query of a kind.
using Maker = CurvedQuery (*)(Kind kind, Rng& rng);

}  // namespace touchstone::tests
