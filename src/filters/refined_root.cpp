// SPDX-License-Identifier: MIT
#include "filters/refined_root.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "filters/coplanarity_form.hpp"
#include "geometry/vector.hpp"
#include "numbers/double_double.hpp"

namespace touchstone::filters {
namespace {

using numbers::DoubleDouble;
using numbers::rounded;
using geometry::cross_component;
using Precise = geometry::Vector<DoubleDouble>;

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

Component operator-(const Component& a, const Component& b) noexcept { return {a.value - b.value, a.slope - b.slope}; }

/// The root as an offset from a double: t - V(t) / V'(x) for some x between.
struct Offset {
  double value;
  double error;  ///< the true offset is off by at most this
  double reach;  ///< and at most this far away
};

std::optional<Offset> offset_of(const BernsteinCubic& cubic, const BernsteinCubic::Root& root, double value) noexcept {
  const double value_error = kValueBound * cubic.size() + kUnit * std::fabs(value);
  // V'(x) differs from the computed slope by at most `spread`, which is below half of it (see BernsteinCubic::Root).
  const double steepness = std::fabs(root.slope);
  const double offset = -value / root.slope;
  const double reach = 2 * (std::fabs(offset) + value_error / steepness);
  const double spread = cubic.slope_error() + cubic.curvature_bound() * reach;
  if (!(spread < 0.5 * steepness)) return std::nullopt;
  const double error =
      1.0625 * (2 * value_error / steepness + std::fabs(offset) * (2 * spread / steepness + kUnit));
  return Offset{offset, error, reach};
}

/// The sign of a component at the root; 0 when uncertain. With M the product of its vectors' bounds (or the sum of such
/// products): its double-double value is off by 540 e^2 M (and 100 more for a difference). Its slope, at most 8 M, sums 4
/// products of a dropped low part or a rounded factor each, at most (4 + 20 + 2) e M, and 4 roundings of at most 4 M: with
/// the two last operations 136 e M, times the offset. Its second derivative is at most 16 M, so 8 M reach^2; the offset's
/// error weighs 8 M.
int sign_at_root(const Component& component, const Offset& offset, double m) noexcept {
  const double value = rounded(component.value) + component.slope * offset.value;
  const double bound = m * (800 * kUnitSquared + 140 * kUnit * std::fabs(offset.value) + 8.25 * offset.reach * offset.reach +
                            8.25 * offset.error) +
                       4 * kUnit * std::fabs(value);
  return value > bound ? 1 : value < -bound ? -1 : 0;
}

/// The two neighbouring doubles around the root, equal when it is a double.
struct Times {
  double toi, toi_upper;
};

std::optional<Times> neighbouring_doubles(const Query& query, const BernsteinCubic::Root& root, const Offset& offset,
                                          ExactSign exact_sign) {
  // The root is nearest + rest, give or take the error.
  const DoubleDouble sum = numbers::two_sum(root.t, offset.value);
  const double nearest = sum.high;
  const double rest = sum.low;
  if (!(nearest > 0 && nearest < 1)) return std::nullopt;
  int side = rest > offset.error ? 1 : rest < -offset.error ? -1 : 0;  // of the root, seen from `nearest`
  if (side == 0) {
    if (!(std::fabs(nearest - root.t) <= root.radius)) return std::nullopt;
    const int sign = exact_sign(query, nearest);
    if (sign == 0) return Times{nearest, nearest};
    side = (sign > 0) == (root.slope > 0) ? -1 : 1;  // V is monotone between the two
  }
  const Times times = side > 0 ? Times{nearest, std::nextafter(nearest, 1.0)} : Times{std::nextafter(nearest, 0.0), nearest};
  if (!(std::fabs(rest) + offset.error < times.toi_upper - times.toi)) return std::nullopt;
  return times;
}

}  // namespace

RootVerdict refine_root(const Query& query, const BernsteinCubic& cubic, const BernsteinCubic::Root& root,
                        const ContactFrame& frame, bool inside, double t_max, ExactSign exact_sign, Answer& answer) {
  const ElementVectors at = vectors_at(query, root.t);
  const Precise n = geometry::cross(at.u.value, at.w.value);
  const std::optional<Offset> offset = offset_of(cubic, root, rounded(geometry::dot(n, at.r.value)));
  if (!offset) return RootVerdict::uncertain;

  const bool edges = query.kind == Kind::edge_edge;
  const std::size_t k = frame.axis;
  const Component normal = component(at.u, at.w, k);
  const Component first = component(at.r, at.w, k);
  const Component second = edges ? component(at.r, at.u, k) : component(at.u, at.r, k);
  const Component rest_of = normal - first - second;  // of a face's weights
  const double n_value = rounded(normal.value);
  const double uw = frame.u * frame.w;
  const double rw = frame.r * frame.w;
  const double ru = frame.r * frame.u;
  if (!inside) {
    const int s = n_value > 0 ? 1 : -1;
    int signs[4] = {s * sign_at_root(first, *offset, rw), s * sign_at_root(second, *offset, ru), 1, 1};
    if (edges) {
      signs[2] = s * sign_at_root(normal - first, *offset, uw + rw);
      signs[3] = s * sign_at_root(normal - second, *offset, uw + ru);
    } else {
      signs[2] = s * sign_at_root(rest_of, *offset, uw + rw + ru);
    }
    const int least = std::min({signs[0], signs[1], signs[2], signs[3]});
    if (least < 0) return RootVerdict::outside;
    if (least == 0) return RootVerdict::uncertain;
  }

  const std::optional<Times> times = neighbouring_doubles(query, root, *offset, exact_sign);
  if (!times) return RootVerdict::uncertain;
  if (times->toi > t_max || (times->toi == t_max && times->toi < times->toi_upper)) return RootVerdict::too_late;

  // A weight is f(t + offset) = f + f' offset with f = a / n: the slope's own error, second-order terms (|f''| <= 2 K + 2 K^2
  // with K the bound below on |f'|) and the error of the offset are negligible under these conditions; so are the
  // double-double errors of a and n, 800 e^2 K. What remains are 4 roundings.
  const double slope_bound = 8 * (uw + rw + ru) / std::fabs(n_value);
  if (!(slope_bound <= 0x1p40 && slope_bound * offset->reach <= 0x1p-29 && slope_bound * offset->error <= 0x1p-56)) {
    return RootVerdict::uncertain;
  }
  const auto weight = [&](const Component& numerator) {
    const double f = rounded(numerator.value) / n_value;
    const double f_slope = (numerator.slope - f * normal.slope) / n_value;
    return std::clamp(f + f_slope * offset->value, 0.0, 1.0);
  };
  answer.contact = true;
  answer.nature = Nature::crossing;
  answer.toi = times->toi;
  answer.toi_upper = times->toi_upper;
  if (edges) {
    const double f1 = weight(first);
    const double f2 = weight(second);
    answer.feature_a = Feature::a;
    answer.feature_b = Feature::b;
    answer.weights_a = {1 - f1, f1, 0};
    answer.weights_b = {1 - f2, f2, 0};
  } else {
    answer.feature_a = Feature::v;
    answer.feature_b = Feature::f;
    answer.weights_a = {1, 0, 0};
    answer.weights_b = {weight(rest_of), weight(first), weight(second)};
  }
  return RootVerdict::contact;
}

}  // namespace touchstone::filters
