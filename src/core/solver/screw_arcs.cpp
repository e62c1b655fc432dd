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
  if (largest == 0) return 0;
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

}  // namespace

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
    arc.motions[m] = {turns_[m].at[first], turns_[m].at[first + 1], between(from, motion.p0, motion.p1),
                      between(to, motion.p0, motion.p1)};
  }
  for (std::size_t c = 0; c < corner_count(query_.kind); ++c) {
    const CurvedCorner& corner = query_.corners[c];
    if (corner.motion != CurvedCorner::kOnCurve) continue;
    // The blossom's values at n - j times `from` and j times `to` (Farin, "Curves and surfaces for CAGD").
    const std::size_t degree = static_cast<std::size_t>(corner.control_points) - 1;
    for (std::size_t j = 0; j <= degree; ++j) {
      std::array<Vec3, 4> points = corner.points;
      for (std::size_t level = 0; level < degree; ++level) {
        for (std::size_t k = 0; k + level < degree; ++k) {
          points[k] = between(level < j ? to : from, points[k], points[k + 1]);
        }
      }
      arc.corners[c].points[j] = points[0];
    }
  }
  return arc;
}

double ScrewArcs::corner_deviation(std::size_t c) const noexcept {
  // Three levels of at most 2.1 e each, or one, times sqrt(3) for three coordinates; and what underflows.
  const CurvedCorner& corner = query_.corners[c];
  if (corner.motion == CurvedCorner::kOnCurve) {
    double size = 0;
    for (int k = 0; k < corner.control_points; ++k) {
      size = std::max(size, largest_of(corner.points[static_cast<std::size_t>(k)]));
    }
    return 12 * kUlp * size + 0x1p-1060;
  }
  const std::size_t m = static_cast<std::size_t>(corner.motion);
  const double size = std::max(largest_of(query_.motions[m].p0), largest_of(query_.motions[m].p1));
  return kRoom * (length_of(corner.points[0]) * turns_[m].deviation + 4 * kUlp * size) + 0x1p-1060;
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
  const auto distance = [](const Vec3& a, const Vec3& b) {
    const Vec3 difference = {b.x - a.x, b.y - a.y, b.z - a.z};
    return kRoom * length_of(difference);
  };
  if (corner.motion == CurvedCorner::kOnCurve) {  // degree times the longest leg of the control polygon
    double longest = 0;
    for (std::size_t k = 1; k < static_cast<std::size_t>(corner.control_points); ++k) {
      longest = std::max(longest, distance(corner.points[k - 1], corner.points[k]));
    }
    return kRoom * 3 * longest;
  }
  const std::size_t m = static_cast<std::size_t>(corner.motion);
  const double turning = length_of(corner.points[0]) * turns_[m].angle;
  return kRoom * (turning + distance(query_.motions[m].p0, query_.motions[m].p1));
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
