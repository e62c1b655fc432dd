// SPDX-License-Identifier: MIT
#include "rigid/arc.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/arc_bulge.hpp"

namespace touchstone::rigid {
namespace {

using Quaternion = std::array<double, 4>;

constexpr double kRounding = 0x1p-53;
constexpr double kUnbounded = std::numeric_limits<double>::infinity();
constexpr double kWidened = 1 + 0x1p-49;  // for a few roundings

/// Of a point and of a position: how far computed places may be off, see Arc.
constexpr double kPositioning = 0x1p-45;

/// Numbers beyond this could overflow in sums and products.
constexpr double kMostLength = 0x1p1000;

double largest_of(const Vec3& x) noexcept { return std::max({std::fabs(x.x), std::fabs(x.y), std::fabs(x.z)}); }

/// An orientation at a time: q(t) = length * unit, for quaternions q0 and q1 that are scaled together so that their
/// largest component is near 1.
struct Orientation {
  Quaternion unit;  ///< of length 1 within 8 e, e = 2^-53
  double length;
  double wrong_by;  ///< `unit` is no farther than this from the true direction
};

double dot(const Quaternion& a, const Quaternion& b) noexcept {
  return (a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3]);
}

// With components up to 1, each product and the sum of (1 - t) q0 + t q1 are rounded: off by at most 2 e, the whole by
// 4 e in length. 1 - t is exact. The direction of a vector of length n that is off by d is off by at most 2 d / n. The
// length is off by 4 e + 4 e n, and each quotient has a relative error of 6 e. Scaling by a power of two is exact, or
// off by 2^-1074, which is nothing beside e: a length below kLeastLength is not used.
constexpr double kLeastLength = 0x1p-40;
double wrong_direction(double length) noexcept { return kRounding * (10 / length + 16); }

/// False where q(t) is next to zero beside q0 and q1.
bool orientation_at(const Quaternion& q0, const Quaternion& q1, double time, Orientation& at) noexcept {
  for (std::size_t i = 0; i < 4; ++i) at.unit[i] = (1 - time) * q0[i] + time * q1[i];
  at.length = std::sqrt(dot(at.unit, at.unit));
  if (!(at.length >= kLeastLength)) return false;
  for (double& component : at.unit) component /= at.length;
  at.wrong_by = wrong_direction(at.length);
  return true;
}

/// Both quaternions, times a power of two that makes their largest component 1/2 to 1.
std::array<Quaternion, 2> scaled(const Quaternion& q0, const Quaternion& q1) noexcept {
  double largest = 0;
  for (std::size_t i = 0; i < 4; ++i) largest = std::max({largest, std::fabs(q0[i]), std::fabs(q1[i])});
  int exponent = 0;
  std::frexp(largest, &exponent);
  std::array<Quaternion, 2> both;
  for (std::size_t i = 0; i < 4; ++i)
    both[0][i] = std::ldexp(q0[i], -exponent), both[1][i] = std::ldexp(q1[i], -exponent);
  return both;
}

std::array<std::array<double, 3>, 3> matrix_of(const Quaternion& q) noexcept {
  const auto [w, x, y, z] = q;
  return {{{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
           {2 * (x * y + w * z), w * w + y * y - x * x - z * z, 2 * (y * z - w * x)},
           {2 * (x * z - w * y), 2 * (y * z + w * x), w * w + z * z - x * x - y * y}}};
}

// A point X at the distance r from the origin. Let u and v be the directions of q(t) at both ends, d = |v - u|, a and b
// the lengths of q(t) there. If u . v >= 0, geometry::kArcBulge bounds how far X leaves the chord of its arc: by
// 0.55 d^2 r, at the same part t' of both ways of a motion whose quaternions have the lengths 1. Here they have the
// lengths a and b, and at the part t of the duration the body is at t' = t b / ((1 - t) a + t b). The difference
// |t' - t| is at most |sqrt(b) - sqrt(a)| / (sqrt(b) + sqrt(a)) = |b - a| / (sqrt(a) + sqrt(b))^2. The chord is at most
// 2 d r long. So the point is within (0.55 d^2 + 2 d |t' - t|) r of where straight motion is at the part t.
// At worst, both are in the ball of radius r around the position, which moves straight: 2 r apart, whatever the
// orientations at the ends are taken to be.
double deviation_of_arc(const Orientation& first, const Orientation& second) noexcept {
  double square = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const double difference = second.unit[i] - first.unit[i];
    square += difference * difference;
  }
  const double wrong_by = first.wrong_by + second.wrong_by + 16 * kRounding;
  if (!(dot(first.unit, second.unit) >= wrong_by)) return 2;
  const double d = std::sqrt(square) + wrong_by;
  const double a = first.length, b = second.length;
  const double pace = std::fabs(b - a) / (a + b + 2 * std::sqrt(a * b)) + 64 * kRounding / std::min(a, b);
  return std::min(2.0, (geometry::kArcBulge * d * d + 2 * d * pace) * kWidened);
}

Vec3 less(const Vec3& point, const Vec3& x) noexcept { return {point.x - x.x, point.y - x.y, point.z - x.z}; }

broad_phase::Box less(broad_phase::Box box, const Vec3& x) noexcept {
  const std::array<double, 3> all{x.x, x.y, x.z};
  for (std::size_t k = 0; k < 3; ++k) box.low[k] -= all[k], box.high[k] -= all[k];
  return box;
}

/// conj(a) b: the turn from the frame of b to that of a.
Quaternion between(const Quaternion& a, const Quaternion& b) noexcept {
  return {dot(a, b), (a[0] * b[1] - a[1] * b[0]) - (a[2] * b[3] - a[3] * b[2]),
          (a[0] * b[2] - a[2] * b[0]) - (a[3] * b[1] - a[1] * b[3]),
          (a[0] * b[3] - a[3] * b[0]) - (a[1] * b[2] - a[2] * b[1])};
}

/// A turn from a body's frame to another one's, which is nearly the true one all along a piece.
struct NearlyConstantTurn {
  Quaternion unit;  ///< of length 1 within 8 e
  double wrong_by;  ///< it is no farther than this from the true direction, at all times
};

// With qa(t) and qb(t) straight in t, s(t) = conj(qa(t)) qb(t) is a quadratic curve: the control points are
// v0 = conj(qa(from)) qb(from), v1, half of conj(qa(from)) qb(to) + conj(qa(to)) qb(from), and
// v2 = conj(qa(to)) qb(to), so s(t) is a sum of them with weights that are not negative. All that leans from a unit
// vector u by an angle of at most f < 90 degrees is a cone, which is convex: it has all of s(t) if it has the control
// points. Of v, tan(f) is |v - (v . u) u| / (v . u). The direction of s(t) is at most 2 sin(f / 2) <= tan(f) from u.
//
// The roundings, e = 2^-53: components of qa and qb are up to 1 and off by 2 e, so the lengths are up to 2 and off by
// 4 e: 16 e in a product. 4 products and 3 sums of up to 4 round each of its components by 16 e, together 32 e, and
// half of a sum of two by 8 e more: v is off by 64 e. v . u is off by 32 e, and by 4 * 8 e as u is not of length 1; the
// components of v - (v . u) u by 40 e each, in length by 80 e, and by 64 e for u. All of it is below 512 e = 2^-44.
std::optional<NearlyConstantTurn> turn_between(const RigidMotion& a, const RigidMotion& b, double from,
                                               double to) noexcept {
  constexpr double kOff = 0x1p-44;
  std::array<std::array<Quaternion, 2>, 2> at;  // by body and end
  for (std::size_t body = 0; body < 2; ++body) {
    const RigidMotion& motion = body == 0 ? a : b;
    const auto [q0, q1] = scaled(motion.q0, motion.q1);
    for (std::size_t end = 0; end < 2; ++end) {
      const double time = end == 0 ? from : to;
      for (std::size_t i = 0; i < 4; ++i) at[body][end][i] = (1 - time) * q0[i] + time * q1[i];
    }
  }
  std::array<Quaternion, 3> v = {between(at[0][0], at[1][0]), between(at[0][0], at[1][1]), between(at[0][1], at[1][1])};
  const Quaternion other = between(at[0][1], at[1][0]);
  for (std::size_t i = 0; i < 4; ++i) v[1][i] = (v[1][i] + other[i]) / 2;
  NearlyConstantTurn turn{v[1], 0};
  const double length = std::sqrt(dot(v[1], v[1]));
  if (!(length >= kLeastLength)) return std::nullopt;
  for (double& component : turn.unit) component /= length;
  for (const Quaternion& one : v) {
    const double along = dot(one, turn.unit);
    if (!(along > kOff)) return std::nullopt;
    double square = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const double across = one[i] - along * turn.unit[i];
      square += across * across;
    }
    turn.wrong_by = std::max(turn.wrong_by, (std::sqrt(square) + kOff) / (along - kOff) * kWidened);
  }
  return turn;
}

}  // namespace

double reach_of(const broad_phase::Box& box) noexcept {
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double most = std::max(std::fabs(box.low[k]), std::fabs(box.high[k]));
    square += most * most;
  }
  // Squares that underflow are of lengths below 2^-510.
  return std::sqrt(square) * kWidened + 0x1p-500;
}

// The ends. An entry of the computed matrix is at most 1, and off by 14 e from that of a unit quaternion that is within
// wrong_by + 8 e of the true direction; quaternions of length 1 that differ by w turn X to places that are 2 w r apart.
// 3 products and 2 sums of entries and coordinates are off by less than 51 e r together; the position adds
// e (r + P), where P is the largest coordinate, and 4 e P where it is interpolated, along each axis. All of it is below
// 2 wrong_by r + 2^-45 (r + P). Products that underflow are off by 2^-1074 each. A point less `about` is off by e
// of the difference along each axis, which is at most 2 e r and within that, too.
Arc::Arc(const RigidMotion& motion, double from, double to, double reach, double off, const Vec3& about) noexcept
    : about_(about), reach_(reach), off_(off) {
  const auto [q0, q1] = scaled(motion.q0, motion.q1);
  std::array<Orientation, 2> at{};
  if (orientation_at(q0, q1, from, at[0]) && orientation_at(q0, q1, to, at[1])) {
    bulge_ = deviation_of_arc(at[0], at[1]);
    per_reach_ = bulge_ + 2 * std::max(at[0].wrong_by, at[1].wrong_by) + kPositioning;
  } else {
    at[0].unit = at[1].unit = {1, 0, 0, 0};
    per_reach_ = bulge_ + kPositioning;
  }
  const auto first = matrix_of(at[0].unit), second = matrix_of(at[1].unit);
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t j = 0; j < 3; ++j) turn_[k][j] = AtBothEnds{first[k][j], second[k][j]};
  }
  const auto between = [&](double p0, double p1) {
    return AtBothEnds{(1 - from) * p0 + from * p1, (1 - to) * p0 + to * p1};
  };
  position_ = {between(motion.p0.x, motion.p1.x), between(motion.p0.y, motion.p1.y), between(motion.p0.z, motion.p1.z)};
  const double far = std::max(largest_of(motion.p0), largest_of(motion.p1));
  rounding_ = kPositioning * far + 0x1p-1060;
  error_ = reach + far < kMostLength ? (rounding_ + off) * kWidened : kUnbounded;
}

Arc::Ends Arc::ends_of(const Vec3& point) const noexcept {
  const Vec3 x = less(point, about_);
  std::array<AtBothEnds, 3> at;
  for (std::size_t k = 0; k < 3; ++k) {
    at[k] = (turn_[k][0] * x.x + turn_[k][1] * x.y + turn_[k][2] * x.z) + position_[k];
  }
  return {{at[0][0], at[1][0], at[2][0]}, {at[0][1], at[1][1], at[2][1]}};
}

double Arc::reach_of(const Vec3& point) const noexcept {
  const Vec3 x = less(point, about_);
  return rigid::reach_of({{x.x, x.y, x.z}, {x.x, x.y, x.z}});
}

// The computed place of a point of the box is that of its middle and, along each axis, at most the half widths times
// the magnitudes of the matrix's entries more; the roundings of both are within those of a point at the reach.
broad_phase::BoundsByAxis Arc::around(const broad_phase::Box& own, double own_reach, double margin) const noexcept {
  const bool is_moved = about_.x != 0 || about_.y != 0 || about_.z != 0;
  const broad_phase::Box box = is_moved ? less(own, about_) : own;
  const double reach = is_moved ? rigid::reach_of(box) : own_reach;
  std::array<double, 3> middle, half;
  for (std::size_t j = 0; j < 3; ++j) {
    middle[j] = box.low[j] / 2 + box.high[j] / 2;
    half[j] = std::max(box.high[j] - middle[j], middle[j] - box.low[j]);
  }
  const double wider = (deviation(reach) + kPositioning * reach + rounding_ + margin) * kWidened;
  const auto magnitude = [](AtBothEnds x) { return x < 0 ? -x : x; };
  broad_phase::BoundsByAxis bounds;
  for (std::size_t k = 0; k < 3; ++k) {
    const AtBothEnds at = (turn_[k][0] * middle[0] + turn_[k][1] * middle[1] + turn_[k][2] * middle[2]) + position_[k];
    const AtBothEnds side =
        magnitude(turn_[k][0]) * half[0] + magnitude(turn_[k][1]) * half[1] + magnitude(turn_[k][2]) * half[2] + wider;
    bounds.low[k] = broad_phase::lowered(at - side);
    bounds.high[k] = -broad_phase::lowered(-(at + side));
  }
  return bounds;
}

// Bodies with the turns A(t) and B(t), S(t) = A(t)^T B(t), and a point c of b's frame. Two points X and Y are apart by
//
//   A(t) X + p - B(t) Y - r = (A(t) (X - d) + p) - (B(t) (Y - c) + r) + A(t) (d - S(t) c)
//
// for any d. The first two terms are places of arcs about d and c. If S(t) is nearly a constant turn U, and d = U c,
// the last one is short, however far c is from the origin: quaternions of length 1 that differ by w turn c to places
// that are 2 w |c| apart, and the computed d is off by less than 2^-45 |c|, as a point in Arc is.
std::optional<std::array<Arc, 2>> turn_together(const RigidMotion& a, const broad_phase::Box& box_a,
                                                const RigidMotion& b, const broad_phase::Box& box_b, double from,
                                                double to) noexcept {
  const std::optional<NearlyConstantTurn> turn = turn_between(a, b, from, to);
  if (!turn) return std::nullopt;
  const auto middle = [&](std::size_t k) { return box_b.low[k] / 2 + box_b.high[k] / 2; };
  const Vec3 of_b{middle(0), middle(1), middle(2)};
  const auto matrix = matrix_of(turn->unit);
  const auto turned = [&](std::size_t k) {
    return matrix[k][0] * of_b.x + matrix[k][1] * of_b.y + matrix[k][2] * of_b.z;
  };
  const Vec3 of_a{turned(0), turned(1), turned(2)};
  const double far = reach_of({{of_b.x, of_b.y, of_b.z}, {of_b.x, of_b.y, of_b.z}});
  const double off = (2 * turn->wrong_by + kPositioning) * far * kWidened + 0x1p-1060;
  return std::array{Arc(a, from, to, reach_of(less(box_a, of_a)), off, of_a),
                    Arc(b, from, to, reach_of(less(box_b, of_b)), 0, of_b)};
}

}  // namespace touchstone::rigid
