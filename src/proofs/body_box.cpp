// SPDX-License-Identifier: MIT
#include "proofs/body_box.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <touchstone/error.hpp>

#include "proofs/elements.hpp"

namespace touchstone::proofs {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The Bernstein coefficients over [0, 1] of a polynomial of degree 3 at most; the two in the middle three times.
std::array<Exact, 4> controls(const Dense& p) {
  const auto c = [&](std::size_t i) { return i < p.size() ? p[i] : Exact(0); };
  const Exact three(3), two(2);
  return {c(0), three * c(0) + c(1), three * c(0) + two * c(1) + c(2), c(0) + c(1) + c(2) + c(3)};
}

/// The greatest double that is at most numerator / denominator. The denominator is positive.
double quotient_rounded_down(const Exact& numerator, const Exact& denominator) {
  const auto is_at_most = [&](double x) { return (Exact(x) * denominator - numerator).sign() <= 0; };
  double x = approximate_quotient(numerator, denominator);
  if (!std::isfinite(x)) throw Error("the box of a body's corner is beyond the doubles");
  while (std::isfinite(x) && !is_at_most(x)) x = std::nextafter(x, -kInfinity);
  for (double next = std::nextafter(x, kInfinity); std::isfinite(next) && is_at_most(next);) {
    x = next;
    next = std::nextafter(x, kInfinity);
  }
  if (!std::isfinite(x)) throw Error("the box of a body's corner is beyond the doubles");
  return x;
}

}  // namespace

PointBox box_on_body(const RigidMotion& motion, const Vec3& point) {
  CurvedQuery query;
  query.kind = Kind::point_point;
  query.motions[0] = motion;
  query.corners[0] = query.corners[1] = CurvedCorner::on_body(0, point);
  const Elements elements = elements_of(query, {1, Metric::euclidean});
  const Exact& unit = elements.separation;  // what all coordinates are multiplied by
  const std::array<Exact, 4> weights = controls(elements.weights[0]);
  std::array<double, 3> low{}, high{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::array<Exact, 4> x = controls(elements.corners[0][k]);
    low[k] = kInfinity;
    high[k] = -kInfinity;
    for (std::size_t i = 0; i < 4; ++i) {
      if (weights[i].sign() <= 0) throw Error("a body turns too far in a step for a box of its corners");
      const Exact denominator = weights[i] * unit;
      low[k] = std::min(low[k], quotient_rounded_down(x[i], denominator));
      high[k] = std::max(high[k], -quotient_rounded_down(-x[i], denominator));
    }
  }
  return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
}

}  // namespace touchstone::proofs
