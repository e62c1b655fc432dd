// SPDX-License-Identifier: MIT
#include "filters/refined_root.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "filters/contact_values.hpp"
#include "filters/coplanarity_form.hpp"
#include "numbers/double_double.hpp"

namespace touchstone::filters {
namespace {

/// The root as an offset from a double: t - V(t) / V'(x) for some x between.
struct Offset {
  double value;
  double error;  ///< the true offset is off by at most this
  double reach;  ///< and at most this far away
};

std::optional<Offset> offset_of(const SimpleRoot& root, double product, double value) noexcept {
  const double value_error = kCoplanarityError * product + kUnit * std::fabs(value);
  // V'(x) differs from the computed slope by at most `spread`, which is below half of it (see SimpleRoot).
  const double steepness = std::fabs(root.slope);
  const double offset = -value / root.slope;
  const double reach = 2 * (std::fabs(offset) + value_error / steepness);
  const double spread = root.slope_error + root.curvature * reach;
  if (!(spread < 0.5 * steepness)) return std::nullopt;
  const double error =
      1.0625 * (2 * value_error / steepness + std::fabs(offset) * (2 * spread / steepness + kUnit));
  return Offset{offset, error, reach};
}

/// The sign of a component at the root; 0 when uncertain. With M the product of its vectors' bounds (or the sum of such
/// products): its value before rounding is off by 540 e^2 M (and 100 more for a difference). Its slope, at most 8 M, sums 4
/// products of a dropped low part or a rounded factor each, at most (4 + 20 + 2) e M, and 4 roundings of at most 4 M: with
/// the two last operations 136 e M, times the offset. Its second derivative is at most 16 M, so 8 M reach^2; the offset's
/// error weighs 8 M.
int sign_at_root(const ValueAndSlope& component, const Offset& offset, double m) noexcept {
  const double value = component.value + component.slope * offset.value;
  const double bound = m * (800 * kUnitSquared + 140 * kUnit * std::fabs(offset.value) + 8.25 * offset.reach * offset.reach +
                            8.25 * offset.error) +
                       4 * kUnit * std::fabs(component.value);
  return value > bound ? 1 : value < -bound ? -1 : 0;
}

/// The doubles beside x > 0.
double after(double x) noexcept { return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) + 1); }
double before(double x) noexcept { return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) - 1); }

/// The two neighbouring doubles around the root, equal when it is a double.
struct Times {
  double toi, toi_upper;
};

std::optional<Times> neighbouring_doubles(const Query& query, const SimpleRoot& root, const Offset& offset,
                                          ExactSign exact_sign) {
  // The root is nearest + rest, give or take the error.
  const numbers::DoubleDouble sum = numbers::two_sum(root.t, offset.value);
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
  const Times times = side > 0 ? Times{nearest, after(nearest)} : Times{before(nearest), nearest};
  if (!(std::fabs(rest) + offset.error < times.toi_upper - times.toi)) return std::nullopt;
  return times;
}

}  // namespace

RootVerdict refine_root(const Query& query, const SimpleRoot& root, const ContactFrame& frame, bool inside, double t_max,
                        ExactSign exact_sign, Answer& answer) {
  const bool edges = query.kind == Kind::edge_edge;
  const ContactValues at = contact_values(query.start.data(), query.end.data(), edges, root.t, frame.axis);
  const std::optional<Offset> offset = offset_of(root, frame.product, at.coplanarity);
  if (!offset) return RootVerdict::uncertain;

  const double uw = frame.u * frame.w;
  const double rw = frame.r * frame.w;
  const double ru = frame.r * frame.u;
  if (!inside) {
    const int s = at.normal.value > 0 ? 1 : -1;
    const int signs[4] = {s * sign_at_root(at.first, *offset, rw), s * sign_at_root(at.second, *offset, ru),
                          s * sign_at_root(at.third, *offset, edges ? uw + rw : uw + rw + ru),
                          edges ? s * sign_at_root(at.fourth, *offset, uw + ru) : 1};
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
  const double slope_bound = 8 * (uw + rw + ru) / std::fabs(at.normal.value);
  if (!(slope_bound <= 0x1p40 && slope_bound * offset->reach <= 0x1p-29 && slope_bound * offset->error <= 0x1p-56)) {
    return RootVerdict::uncertain;
  }
  const auto weight = [&](const ValueAndSlope& numerator) {
    const double f = numerator.value / at.normal.value;
    const double f_slope = (numerator.slope - f * at.normal.slope) / at.normal.value;
    return std::clamp(f + f_slope * offset->value, 0.0, 1.0);
  };
  answer.contact = true;
  answer.nature = Nature::crossing;
  answer.toi = times->toi;
  answer.toi_upper = times->toi_upper;
  if (edges) {
    const double f1 = weight(at.first);
    const double f2 = weight(at.second);
    answer.feature_a = Feature::a;
    answer.feature_b = Feature::b;
    answer.weights_a = {1 - f1, f1, 0};
    answer.weights_b = {1 - f2, f2, 0};
  } else {
    answer.feature_a = Feature::v;
    answer.feature_b = Feature::f;
    answer.weights_a = {1, 0, 0};
    answer.weights_b = {weight(at.third), weight(at.first), weight(at.second)};
  }
  return RootVerdict::contact;
}

}  // namespace touchstone::filters
