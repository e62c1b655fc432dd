// Gradients of first contacts' times in rational arithmetic, with formulas of their own.
// SPDX-License-Identifier: MIT
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <touchstone/query.hpp>
#include <touchstone/toi_gradient.hpp>

#include "separation/distances.hpp"

namespace touchstone::tests {

using Rational = mpq_class;
using Point = std::array<Rational, 3>;

inline Rational dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point difference(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The gradient by the volume of the tetrahedron of the four corners, for a contact without separation at the time t;
/// none where the volume does not change then.
struct RationalGradient {
  std::array<Point, 4> start, end;
};

/// The corners at the time t, and their velocities.
inline std::array<std::array<Point, 4>, 2> corners_at(const Query& query, const Rational& t) {
  std::array<std::array<Point, 4>, 2> found;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational a(coordinate(query.start[i], k)), b(coordinate(query.end[i], k));
      found[0][i][k] = a + t * (b - a);
      found[1][i][k] = b - a;
    }
  }
  return found;
}

inline std::optional<RationalGradient> rational_gradient(const Query& query, const Rational& t) {
  const auto [x, v] = corners_at(query, t);
  // det(x1 - x0, x2 - x0, x3 - x0) is multilinear: by corner 1 its derivative is (x2 - x0) x (x3 - x0), and so on.
  std::array<Point, 4> by;
  by[1] = cross(difference(x[2], x[0]), difference(x[3], x[0]));
  by[2] = cross(difference(x[3], x[0]), difference(x[1], x[0]));
  by[3] = cross(difference(x[1], x[0]), difference(x[2], x[0]));
  Rational speed = 0;
  for (std::size_t k = 0; k < 3; ++k) by[0][k] = -by[1][k] - by[2][k] - by[3][k];
  for (std::size_t i = 0; i < 4; ++i) speed += dot(by[i], v[i]);
  if (speed == 0) return std::nullopt;
  RationalGradient gradient;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      gradient.start[i][k] = -(1 - t) * by[i][k] / speed;
      gradient.end[i][k] = -t * by[i][k] / speed;
    }
  }
  return gradient;
}

/// The time between two doubles at which the four corners are in one plane, from so many bisections; nothing where they
/// are on the same side of a plane at both.
inline std::optional<Rational> plane_time(const Query& query, double lower, double upper, int bisections = 250) {
  const auto volume = [&](const Rational& t) {
    const auto x = corners_at(query, t)[0];
    return Rational(dot(difference(x[1], x[0]), cross(difference(x[2], x[0]), difference(x[3], x[0]))));
  };
  Rational low(lower), high(upper);
  const int sign = sgn(volume(low));
  if (sign * sgn(volume(high)) > 0) return std::nullopt;
  for (int i = 0; i < bisections; ++i) {
    const Rational middle = (low + high) / 2;
    (sgn(volume(middle)) == sign ? low : high) = middle;
  }
  return low;
}

/// Whether it is the true one, or a double beside it; beyond the greatest double that is infinity.
inline bool is_beside(double found, const Rational& truth) {
  if (truth == 0) return found == 0;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double below = std::nextafter(found, -kInfinity), above = std::nextafter(found, kInfinity);
  return (std::isinf(below) || Rational(below) < truth) && (std::isinf(above) || truth < Rational(above)) &&
         (!std::isinf(found) || sgn(truth) == (found > 0 ? 1 : -1));
}

inline double greatest(const ToiGradient& gradient) {
  double most = 0;
  for (const auto* side : {&gradient.start, &gradient.end}) {
    for (const Vec3& g : *side) most = std::max({most, std::fabs(g.x), std::fabs(g.y), std::fabs(g.z)});
  }
  return most;
}

inline bool is_zero(const ToiGradient& gradient) { return greatest(gradient) == 0; }

}  // namespace touchstone::tests
