// SPDX-License-Identifier: MIT
#include "families/curved_parts.hpp"

namespace touchstone::families {
namespace {

/// Whether q1 is q0 times a negative number, or cannot be told from it in doubles.
bool seem_opposite(const Quaternion& q0, const Quaternion& q1) {
  for (std::size_t i = 0; i < 4; ++i) {
    if (q0[i] < 0 ? !(q1[i] > 0) : q0[i] > 0 ? !(q1[i] < 0) : q1[i] != 0) return false;
    for (std::size_t j = 0; j < 4; ++j) {
      // Equal numbers round to equal products.
      if (q0[i] * q1[j] != q0[j] * q1[i]) return false;
    }
  }
  return true;
}

}  // namespace

Quaternion product(const Quaternion& a, const Quaternion& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

Vec3 turned(const Quaternion& q, const Vec3& x) {
  const Quaternion conjugate = {q[0], -q[1], -q[2], -q[3]};
  const Quaternion result = product(product(q, {0, x.x, x.y, x.z}), conjugate);
  return {result[1], result[2], result[3]};
}

Quaternion about_axis(std::size_t axis, double c, double s) {
  Quaternion q = {c, 0, 0, 0};
  q[1 + axis] = s;
  return q;
}

Quaternion lattice_quaternion(seeded::Rng& rng, int reach) {
  Quaternion q{};
  while (q == Quaternion{}) {
    for (double& c : q) c = rng.between(-reach, reach);
  }
  return q;
}

Vec3 position(const CurvedQuery& query, std::size_t corner, double t) {
  const CurvedCorner& c = query.corners[corner];
  const double s = 1 - t;
  if (c.motion != CurvedCorner::kOnCurve) {
    const RigidMotion& motion = query.motions[static_cast<std::size_t>(c.motion)];
    const Quaternion q = s * motion.q0 + t * motion.q1;
    const Vec3 x = turned(q, c.points[0]);
    const double length = dot(q, q);
    return Vec3{x.x / length, x.y / length, x.z / length} + (s * motion.p0 + t * motion.p1);
  }
  std::array<Vec3, 4> points = c.points;
  for (auto count = static_cast<std::size_t>(c.control_points); count > 1; --count) {
    for (std::size_t i = 0; i + 1 < count; ++i) points[i] = s * points[i] + t * points[i + 1];
  }
  return points[0];
}

void translate(CurvedQuery& query, std::size_t element, const Vec3& by) {
  std::array<bool, 4> moved{};
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    if (element_of(query.kind, i) != element) continue;
    CurvedCorner& corner = query.corners[i];
    if (corner.motion == CurvedCorner::kOnCurve) {
      for (Vec3& point : corner.points) point = point + by;
      continue;
    }
    const auto m = static_cast<std::size_t>(corner.motion);
    if (moved[m]) continue;
    moved[m] = true;
    query.motions[m].p0 = query.motions[m].p0 + by;
    query.motions[m].p1 = query.motions[m].p1 + by;
  }
}

void meet(CurvedQuery& query, const CornerWeights& wa, const CornerWeights& wb, double t) {
  const std::size_t first_of_b = element_sizes(query.kind).a;
  Vec3 difference;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    const double weight = i < first_of_b ? wa[i] : -wb[i - first_of_b];
    difference = difference + weight * position(query, i, t);
  }
  translate(query, 1, difference);
}

void turn_space(CurvedQuery& query, const Quaternion& q) {
  const double length = dot(q, q);
  for (CurvedCorner& corner : query.corners) {
    const bool on_curve = corner.motion == CurvedCorner::kOnCurve;
    for (Vec3& point : corner.points) point = on_curve ? turned(q, point) : length * point;
  }
  for (RigidMotion& motion : query.motions) {
    motion.q0 = product(q, motion.q0);
    motion.q1 = product(q, motion.q1);
    motion.p0 = turned(q, motion.p0);
    motion.p1 = turned(q, motion.p1);
  }
}

void make_valid(CurvedQuery& query) {
  for (RigidMotion& motion : query.motions) {
    for (Quaternion* const q : {&motion.q0, &motion.q1}) {
      if (*q == Quaternion{}) *q = kNoTurn;
    }
    if (seem_opposite(motion.q0, motion.q1)) motion.q1 = -1.0 * motion.q1;
  }
}

}  // namespace touchstone::families
