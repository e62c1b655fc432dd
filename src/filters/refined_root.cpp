// SPDX-License-Identifier: MIT
#include "filters/refined_root.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/vector.hpp"
#include "numbers/double_double.hpp"

namespace touchstone::filters {
namespace {

using numbers::DoubleDouble;
using numbers::rounded;
using geometry::cross_component;
using Precise = geometry::Vector<DoubleDouble>;

constexpr double kUnit = 0x1p-53;

// Errors of the double-double values below, in e^2 = 2^-106, for coordinates of u bounded by U (likewise w, r), from the
// operators of double_double.hpp. Differences of doubles are exact, with low parts of at most e U.
//   end - start: low parts of 2 and 4 e U are rounded, 6 e^2 U. t times it: + 10, 16 e^2 U, low part 6 e U. start + that:
//   low parts of 7 and 10 e U are rounded, 33 e^2 U, low part 10 e U.
//   A product of two such coordinates: operands 2 * 33, low parts of 10, 10, 20 and 21 e U W rounded, low times low 100
//   left out: 227 e^2 U W, low part 21 e U W. The difference of two: + 42 + 44 e^2, 540 e^2 U W, low part 44 e U W.
//   n_k r_k: operands 540 + 66, low parts of 20, 44, 64 and 66 e P rounded, low times low 440 left out: 1240 e^2 P, low
//   part 66 e P. The sum of three: + 132 + 136 + 202 + 208 e^2 P in low parts: 4400 e^2 P.
constexpr double kUnitSquared = 0x1p-106;
constexpr double kValueBound = 4500 * kUnitSquared;

/// The difference of two corners at t, and its constant slope rounded.
struct AtRoot {
  Precise value;
  geometry::Vector<double> slope;
};

AtRoot difference_at(const Vec3& a0, const Vec3& b0, const Vec3& a1, const Vec3& b1, double t) noexcept {
  AtRoot result;
  const double start_a[3] = {a0.x, a0.y, a0.z};
  const double start_b[3] = {b0.x, b0.y, b0.z};
  const double end_a[3] = {a1.x, a1.y, a1.z};
  const double end_b[3] = {b1.x, b1.y, b1.z};
  for (std::size_t k = 0; k < 3; ++k) {
    const DoubleDouble start = numbers::two_difference(start_a[k], start_b[k]);
    const DoubleDouble change = numbers::two_difference(end_a[k], end_b[k]) - start;
    result.value[k] = start + t * change;
    result.slope[k] = change.high;
  }
  return result;
}

struct ElementVectors {
  AtRoot u, w, r;
};

ElementVectors vectors_at(const Query& q, double t) noexcept {
  const auto difference = [&](std::size_t i, std::size_t j) {
    return difference_at(q.start[i], q.start[j], q.end[i], q.end[j], t);
  };
  if (q.kind == Kind::edge_edge) return {difference(1, 0), difference(3, 2), difference(2, 0)};
  return {difference(2, 1), difference(3, 1), difference(0, 1)};
}

geometry::Vector<double> in_doubles(const Precise& v) noexcept { return {{v[0].high, v[1].high, v[2].high}}; }

/// A component of a x b at t, and its slope in t in doubles.
struct Component {
  DoubleDouble value;
  double slope;
};

Component component(const AtRoot& a, const AtRoot& b, std::size_t k) noexcept {
  return {cross_component(a.value, b.value, k),
          cross_component(a.slope, in_doubles(b.value), k) + cross_component(in_doubles(a.value), b.slope, k)};
}

}  // namespace

Decision refine_contact(const Query& query, const BernsteinCubic& cubic, const BernsteinCubic::Root& root,
                        const ContactFrame& frame, double t_max, Answer& answer) noexcept {
  const ElementVectors at = vectors_at(query, root.t);
  const Precise n = geometry::cross(at.u.value, at.w.value);
  const double value = rounded(geometry::dot(n, at.r.value));
  const double value_error = kValueBound * cubic.size() + kUnit * std::fabs(value);

  // The root is t - V(t) / V'(x) for some x between, at most `reach` away; V'(x) differs from the computed slope by at
  // most `slope_spread`, which is below half of it (see BernsteinCubic::Root).
  const double steepness = std::fabs(root.slope);
  const double offset = -value / root.slope;
  const double reach = 2 * (std::fabs(offset) + value_error / steepness);
  const double slope_spread = cubic.slope_error() + cubic.curvature_bound() * reach;
  if (!(slope_spread < 0.5 * steepness)) return Decision::uncertain;
  const double error =
      1.0625 * (2 * value_error / steepness + std::fabs(offset) * (2 * slope_spread / steepness + kUnit));

  // The exact root is nearest + rest, give or take the error; it must certainly lie on one side of the double `nearest`.
  const DoubleDouble sum = numbers::two_sum(root.t, offset);
  const double nearest = sum.high;
  const double rest = sum.low;
  if (!(nearest > 0 && nearest < 1 && std::fabs(rest) > error)) return Decision::uncertain;
  const double toi = rest > 0 ? nearest : std::nextafter(nearest, 0.0);
  const double toi_upper = rest > 0 ? std::nextafter(nearest, 1.0) : nearest;
  if (!(std::fabs(rest) + error < toi_upper - toi)) return Decision::uncertain;
  if (toi >= t_max) return Decision::no_contact;

  // A weight is f(t + offset) = f + f' offset with f = a / n: the slope's own error, second-order terms (|f''| <= 2 K + 2 K^2
  // with K the bound below on |f'|) and the error of the offset are negligible under these two conditions; so are the
  // double-double errors of a and n, 540 e^2 K. What remains are 4 roundings.
  const std::size_t k = frame.axis;
  const Component normal = component(at.u, at.w, k);
  const double n_value = rounded(normal.value);
  const double slope_bound = 8 * (frame.u * frame.w + std::max(frame.u, frame.w) * frame.r) / std::fabs(n_value);
  if (!(slope_bound <= 0x1p40 && slope_bound * (std::fabs(offset) + error) <= 0x1p-29 && slope_bound * error <= 0x1p-56)) {
    return Decision::uncertain;
  }
  const auto weight = [&](const Component& numerator) {
    const double f = rounded(numerator.value) / n_value;
    const double f_slope = (numerator.slope - f * normal.slope) / n_value;
    return std::clamp(f + f_slope * offset, 0.0, 1.0);
  };
  Answer contact;
  contact.contact = true;
  contact.level = Level::bracket;
  contact.nature = Nature::crossing;
  contact.toi = toi;
  contact.toi_upper = toi_upper;
  const Component first = component(at.r, at.w, k);
  if (query.kind == Kind::edge_edge) {
    const double f1 = weight(first);
    const double f2 = weight(component(at.r, at.u, k));
    contact.feature_a = Feature::a;
    contact.feature_b = Feature::b;
    contact.weights_a = {1 - f1, f1, 0};
    contact.weights_b = {1 - f2, f2, 0};
  } else {
    const Component second = component(at.u, at.r, k);
    const Component rest_of = {normal.value - first.value - second.value, normal.slope - first.slope - second.slope};
    contact.feature_a = Feature::v;
    contact.feature_b = Feature::f;
    contact.weights_a = {1, 0, 0};
    contact.weights_b = {weight(rest_of), weight(first), weight(second)};
  }
  answer = contact;
  return Decision::contact;
}

}  // namespace touchstone::filters
