// SPDX-License-Identifier: MIT
#include "filters/refined_root.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
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

/// The two neighbouring doubles around the root, equal when it is a double; or that it lies outside [0, 1], or that this is
/// uncertain.
struct Times {
  enum class Found : std::uint8_t { yes, outside, uncertain } found;
  double toi, toi_upper;
};
constexpr Times kOutside = {Times::Found::outside, 0, 0};
constexpr Times kUncertain = {Times::Found::uncertain, 0, 0};

/// On which side of a double in [0, 1] that lies within the root's radius the root lies, exactly: 1 after it. V is
/// monotone between the two.
int side_of(const Query& query, const SimpleRoot& root, double time, ExactSign exact_sign) {
  const int sign = exact_sign(query, time);
  return sign == 0 ? 0 : (sign > 0) == (root.slope > 0) ? -1 : 1;
}

Times neighbouring_doubles(const Query& query, const SimpleRoot& root, const Offset& offset, ExactSign exact_sign) {
  // The root is nearest + rest, give or take the error.
  const numbers::DoubleDouble sum = numbers::two_sum(root.t, offset.value);
  const double nearest = sum.high;
  const double rest = sum.low;
  for (const double end : {0.0, 1.0}) {
    const double beyond = (nearest - end) + rest;  // off by a rounding; nearest - end is exact where it matters
    const double error = 1.0625 * offset.error + 2 * kUnit * std::fabs(beyond);
    if (end == 0 ? beyond < -error : beyond > error) return kOutside;
    if (std::fabs(beyond) > error) continue;
    if (!(std::fabs(end - root.t) <= root.radius)) return kUncertain;
    const int side = side_of(query, root, end, exact_sign);
    if (side == 0) return {Times::Found::yes, end, end};
    if (side == (end == 0 ? -1 : 1)) return kOutside;
    if (end == 0 || !(std::fabs(beyond) + error < 0x1p-53)) return kUncertain;
    return {Times::Found::yes, before(1.0), 1.0};
  }
  if (!(nearest > 0 && nearest <= 1)) return kUncertain;
  int side = rest > offset.error ? 1 : rest < -offset.error ? -1 : 0;  // of the root, seen from `nearest`
  if (side == 0) {
    if (!(std::fabs(nearest - root.t) <= root.radius)) return kUncertain;
    side = side_of(query, root, nearest, exact_sign);
    if (side == 0) return {Times::Found::yes, nearest, nearest};
  }
  const double toi = side > 0 ? nearest : before(nearest);
  const double toi_upper = after(toi);
  if (!(std::fabs(rest) + offset.error < toi_upper - toi) || toi_upper > 1) return kUncertain;
  return {Times::Found::yes, toi, toi_upper};
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

  const Times times = neighbouring_doubles(query, root, *offset, exact_sign);
  if (times.found == Times::Found::uncertain) return RootVerdict::uncertain;
  if (times.found == Times::Found::outside) return RootVerdict::outside;
  if (times.toi > t_max || (times.toi == t_max && times.toi < times.toi_upper)) return RootVerdict::too_late;

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
  answer.toi = times.toi;
  answer.toi_upper = times.toi_upper;
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
