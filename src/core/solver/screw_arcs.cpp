// docs/design.md, "Constant angular velocity", proves the bounds.
//
// Arcs. Let a be the angle between the unit quaternions at both ends of an arc, so that the body turns by 2 a. On the
// arc (1 - s) q + s q', the angle from q is f(s) with f' = sin a / (1 - 2 s (1 - s) (1 - cos a)), where slerp has s a.
// f - s a is zero at s = 0, 1/2 and 1, and its slope lies between -m = sin a - a and M = 2 tan(a / 2) - a. So between
// two of these zeros, 1/2 apart, |f - s a| <= (1/2) m M / (m + M). For a <= 1, m <= a^3 / 6 and M <= 0.0927 a^3: less
// than a^3 / 32.
//
// Orientations. The ends of arcs are midpoints of slerp, found by halving: q(1/2) is the sum of both ends divided by
// its length. Let A and B be the errors of the ends, and l the length of their sum as computed. With e = 2^-53 the sum
// is off by at most A + B + e l. By the inequality of Dunkl and Williams, |x / |x| - y / |y|| <= 2 |x - y| / (|x| +
// |y|), its direction is off by at most that, divided by what it leaves of l. The length and the quotient add less than
// 6 e.
//
// An error E <= 0.1 of both ends of an arc turns the orientation on it by less than asin(E / cos(a / 2)) < 1.2 E. An
// error of the orientation by an angle h moves a body point X by at most 2 |X| h, and never by more than 2 |X|.
//
// Positions. On a curve p, an arc of duration h has the chord of p: off by at most h^2 / 8 times the greatest |p''|, as
// linear interpolation is. p'' is degree (degree - 1) times a convex combination of the second differences of the
// control points. The ends of the chord are values of the curve, rounded.
// SPDX-License-Identifier: MIT
#include "solver/screw_arcs.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/kind_traits.hpp"

namespace touchstone::solver {
namespace {

using Quaternion = std::array<double, 4>;

constexpr double kUlp = 0x1p-53;
constexpr double kRoom = 1 + 0x1p-40;  // for the roundings of the bounds themselves: products and sums of a few numbers
constexpr double kLost = 2;            // the error of an orientation about which nothing is known

double length_of(const Quaternion& q) noexcept {
  return std::sqrt((q[0] * q[0] + q[1] * q[1]) + (q[2] * q[2] + q[3] * q[3]));
}

/// At least the length of a vector.
double length_of(const Vec3& x) noexcept {
  const double largest = std::max({std::fabs(x.x), std::fabs(x.y), std::fabs(x.z)});
  if (largest == 0 || std::isinf(largest)) return largest;
  const double a = x.x / largest, b = x.y / largest, c = x.z / largest;  // from 1 to sqrt(3) long
  return kRoom * (std::sqrt(a * a + b * b + c * c) * largest) + 0x1p-1070;
}

double largest_of(const Vec3& x) noexcept { return std::max({std::fabs(x.x), std::fabs(x.y), std::fabs(x.z)}); }

Quaternion divided(Quaternion q, double length) noexcept {
  for (double& c : q) c /= length;
  return q;
}

/// q / |q|, off by less than 6 e: 4 e for the squares and their sum, halved by the root, and 2 e for root and quotient.
Quaternion unit(Quaternion q) noexcept {
  double largest = 0;
  for (const double c : q) largest = std::max(largest, std::fabs(c));
  int exponent = 0;
  std::frexp(largest, &exponent);
  for (double& c : q) c = std::ldexp(c, -exponent);
  return divided(q, length_of(q));
}

/// (1 - t) a + t b for a t with few digits: off by at most 2.1 e times the larger of both.
double between(double t, double a, double b) noexcept { return (1 - t) * a + t * b; }
Vec3 between(double t, const Vec3& a, const Vec3& b) noexcept {
  return {between(t, a.x, b.x), between(t, a.y, b.y), between(t, a.z, b.z)};
}

/// The control points of a Bezier curve.
struct Curve {
  std::array<Vec3, 4> points;
  std::size_t degree;

  /// The blossom's value at degree - j times `from` and j times `to` (Farin, "Curves and surfaces for CAGD"). For
  /// times with few digits each level is off by at most 2.1 e times the largest coordinate, and what underflows.
  Vec3 blossom(double from, double to, std::size_t j) const noexcept {
    std::array<Vec3, 4> b = points;
    for (std::size_t level = 0; level < degree; ++level) {
      for (std::size_t k = 0; k + level < degree; ++k) b[k] = between(level < j ? to : from, b[k], b[k + 1]);
    }
    return b[0];
  }

  /// At least the length of each rounding error of `blossom`: three coordinates make it sqrt(3) times as long.
  double rounding() const noexcept {
    double size = 0;
    for (std::size_t k = 0; k <= degree; ++k) size = std::max(size, largest_of(points[k]));
    return 4 * static_cast<double>(degree) * kUlp * size + 0x1p-1060;
  }

  /// At least the greatest speed: the degree times the longest leg of the control polygon.
  double speed() const noexcept {
    double longest = 0;
    for (std::size_t k = 1; k <= degree; ++k) {
      const Vec3 &a = points[k - 1], &b = points[k], leg = {b.x - a.x, b.y - a.y, b.z - a.z};
      longest = std::max(longest, kRoom * length_of(leg));
    }
    return kRoom * static_cast<double>(degree) * longest;
  }
};

Curve curve_of(const CurvedCorner& corner) noexcept {
  return {corner.points, static_cast<std::size_t>(corner.control_points) - 1};
}

Curve curve_of(const RigidMotion& motion) noexcept {
  Curve curve = {{motion.p0, motion.inner[0], motion.inner[1], {}},
                 static_cast<std::size_t>(motion.control_points) - 1};
  curve.points[curve.degree] = motion.p1;
  return curve;
}

}  // namespace

double sag_of(const RigidMotion& motion, int count) noexcept {
  const auto [b, degree] = curve_of(motion);
  double longest = 0;
  for (std::size_t k = 1; k < degree; ++k) {
    // The three subtractions round by less than e times four of the largest coordinate, and underflow nothing.
    const Vec3 second = {(b[k - 1].x - b[k].x) + (b[k + 1].x - b[k].x), (b[k - 1].y - b[k].y) + (b[k + 1].y - b[k].y),
                         (b[k - 1].z - b[k].z) + (b[k + 1].z - b[k].z)};
    const double size = std::max({largest_of(b[k - 1]), largest_of(b[k]), largest_of(b[k + 1])});
    longest = std::max(longest, kRoom * (length_of(second) + 16 * kUlp * size));
  }
  const double arcs = count;
  return kRoom * (static_cast<double>(degree * (degree - 1)) / 8 * longest / arcs / arcs) +
         (longest > 0 ? 0x1p-1070 : 0);
}

ScrewArcs::Turn ScrewArcs::turn_of(const RigidMotion& motion, int count) {
  const std::size_t size = static_cast<std::size_t>(count);
  Turn turn;
  turn.at.resize(size + 1);
  turn.error.assign(size + 1, 6 * kUlp);
  turn.at[0] = unit(motion.q0);
  turn.at[size] = unit(motion.q1);
  for (std::size_t stride = size; stride > 1; stride /= 2) {
    for (std::size_t i = 0; i < size; i += stride) {
      const std::size_t j = i + stride, middle = i + stride / 2;
      Quaternion sum;
      for (std::size_t k = 0; k < 4; ++k) sum[k] = turn.at[i][k] + turn.at[j][k];
      const double length = length_of(sum);
      const double off = kRoom * (turn.error[i] + turn.error[j] + 2 * kUlp * length);
      const double left = (length - off) * (1 - 0x1p-40);
      const bool known = left > off;
      turn.at[middle] = known ? divided(sum, length) : turn.at[i];
      turn.error[middle] = known ? kRoom * (off / left + 6 * kUlp) : kLost;
    }
  }
  for (std::size_t i = 0; i < size; ++i) {
    Quaternion change;
    for (std::size_t k = 0; k < 4; ++k) change[k] = turn.at[i + 1][k] - turn.at[i][k];
    const double error = std::max(turn.error[i], turn.error[i + 1]);
    const double chord = kRoom * (length_of(change) + 2 * error + 8 * kUlp);
    // asin(y) <= y + y^3 / 5 for y <= 1/2, so 2 asin(chord / 2) <= chord + chord^3 / 20.
    const double a = kRoom * (chord + chord * chord * chord / 20);
    const bool known = error <= 0.1 && chord <= 1 && a <= 1;
    turn.deviation = std::max(turn.deviation, known ? kRoom * 2 * (a * a * a / 32 + 1.2 * error) : 2.0);
    turn.angle += known ? 2 * a : 7;  // more than 2 pi
  }
  turn.deviation = std::min(turn.deviation, 2.0);
  turn.angle = kRoom * std::min(turn.angle, 7.0);
  return turn;
}

ScrewArcs::ScrewArcs(const CurvedQuery& query, int count) : query_(query), count_(count) {
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    if (query.corners[i].motion == CurvedCorner::kOnCurve) continue;
    const std::size_t motion = static_cast<std::size_t>(query.corners[i].motion);
    if (turns_[motion].at.empty()) turns_[motion] = turn_of(query.motions[motion], count);
  }
}

CurvedQuery ScrewArcs::arc(int i) const {
  CurvedQuery arc = query_;
  const double from = static_cast<double>(i) / count_, to = static_cast<double>(i + 1) / count_;  // both are exact
  const std::size_t first = static_cast<std::size_t>(i);
  for (std::size_t m = 0; m < turns_.size(); ++m) {
    if (turns_[m].at.empty()) continue;
    const RigidMotion& motion = query_.motions[m];
    const Curve path = curve_of(motion);
    arc.motions[m] = {turns_[m].at[first], turns_[m].at[first + 1], path.blossom(from, from, 0),
                      path.blossom(to, to, 0)};
  }
  for (std::size_t c = 0; c < corner_count(query_.kind); ++c) {
    const CurvedCorner& corner = query_.corners[c];
    if (corner.motion != CurvedCorner::kOnCurve) continue;
    const Curve path = curve_of(corner);
    for (std::size_t j = 0; j <= path.degree; ++j) arc.corners[c].points[j] = path.blossom(from, to, j);
  }
  return arc;
}

double ScrewArcs::corner_deviation(std::size_t c) const noexcept {
  const CurvedCorner& corner = query_.corners[c];
  if (corner.motion == CurvedCorner::kOnCurve) return curve_of(corner).rounding();
  const std::size_t m = static_cast<std::size_t>(corner.motion);
  const RigidMotion& motion = query_.motions[m];
  const double turning = length_of(corner.points[0]) * turns_[m].deviation;
  return kRoom * (turning + sag_of(motion, count_) + curve_of(motion).rounding());
}

double ScrewArcs::deviation(std::size_t element) const noexcept {
  const std::size_t second = geometry::corners_of_first(query_.kind);
  double most = 0;
  for (std::size_t c = element == 0 ? 0 : second; c < (element == 0 ? second : corner_count(query_.kind)); ++c) {
    most = std::max(most, corner_deviation(c));
  }
  return most;
}

double ScrewArcs::corner_speed(std::size_t c) const noexcept {
  const CurvedCorner& corner = query_.corners[c];
  if (corner.motion == CurvedCorner::kOnCurve) return curve_of(corner).speed();
  const std::size_t m = static_cast<std::size_t>(corner.motion);
  return kRoom * (length_of(corner.points[0]) * turns_[m].angle + curve_of(query_.motions[m]).speed());
}

geometry::Vector<Interval> ScrewArcs::position(std::size_t c, double from, double to) const {
  const double time = from + (to - from) / 2;
  const int i = std::min(static_cast<int>(time * count_), count_ - 1);
  const double local = time * count_ - i;  // exact: a power of two, and the fraction of a double
  const Interval s(local), rest = Interval(1) - s;
  const CurvedQuery arc = this->arc(i);
  const CurvedCorner& corner = arc.corners[c];
  const auto blend = [&](double a, double b) { return rest * Interval(a) + s * Interval(b); };
  geometry::Vector<Interval> x;
  if (corner.motion == CurvedCorner::kOnCurve) {
    const std::size_t degree = static_cast<std::size_t>(corner.control_points) - 1;
    constexpr double Vec3::*kAxes[] = {&Vec3::x, &Vec3::y, &Vec3::z};
    for (std::size_t k = 0; k < 3; ++k) {
      std::array<Interval, 4> b;
      for (std::size_t j = 0; j <= degree; ++j) b[j] = corner.points[j].*kAxes[k];
      for (std::size_t level = degree; level > 0; --level) {
        for (std::size_t j = 0; j < level; ++j) b[j] = rest * b[j] + s * b[j + 1];
      }
      x[k] = b[0];
    }
  } else {
    const RigidMotion& motion = arc.motions[static_cast<std::size_t>(corner.motion)];
    std::array<Interval, 4> q;
    Interval square = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      q[k] = blend(motion.q0[k], motion.q1[k]);
      square = square + q[k] * q[k];
    }
    // x = X + 2 v x (v x X + w X) / |q|^2 + p, with q = (w, v); the square is positive: see `Interval`'s quotient.
    const Vec3& point = corner.points[0];
    const geometry::Vector<Interval> v = {{q[1], q[2], q[3]}}, body = {{point.x, point.y, point.z}};
    geometry::Vector<Interval> inner = geometry::cross(v, body);
    for (std::size_t k = 0; k < 3; ++k) inner[k] = inner[k] + q[0] * body[k];
    const geometry::Vector<Interval> outer = geometry::cross(v, inner);
    const Interval position[3] = {blend(motion.p0.x, motion.p1.x), blend(motion.p0.y, motion.p1.y),
                                  blend(motion.p0.z, motion.p1.z)};
    for (std::size_t k = 0; k < 3; ++k) x[k] = body[k] + Interval(2) * outer[k] / square + position[k];
  }
  const double half = rounded_up(std::max(rounded_up(time - from), rounded_up(to - time)));
  const double radius =
      from == to ? corner_deviation(c) : rounded_up(corner_deviation(c) + rounded_up(corner_speed(c) * half));
  for (std::size_t k = 0; k < 3; ++k) x[k] = x[k].grown(radius);
  return x;
}

}  // namespace touchstone::solver
