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

/// Finds them from the root's offset and, where this leaves a doubt, V's exact value at a double, whose sign tells on which
/// side of it the root lies: V is monotone within the root's radius.
class NeighbouringDoubles {
 public:
  NeighbouringDoubles(const Query& query, const SimpleRoot& root, const Offset& offset, ExactValue exact_value)
      : query_(query), root_(root), exact_value_(exact_value), base_(root.t), offset_(offset) {}

  Times find() {
    const bool inner = root_.t - root_.radius > 0 && root_.t + root_.radius < 1;
    if (Times times; inner ? settle(times) : near_end(times)) return times;
    // Several doubles away from the nearest, since it is small: a step from there is as good as its value is exact.
    const double nearest = base_ + offset_.value;
    if (!(nearest > 0 && nearest < 1 && within_radius(nearest))) return kUncertain;
    if (look_from(nearest) == 0) return {Times::Found::yes, nearest, nearest};
    Times times = kUncertain;
    settle(times);
    return times;
  }

 private:
  /// For a root that may be on either side of 0 or 1: `settle`, or that it is outside.
  bool near_end(Times& times) {
    for (const double end : {0.0, 1.0}) {
      const numbers::DoubleDouble sum = numbers::two_sum(base_, offset_.value);
      const double beyond = (sum.high - end) + sum.low;  // sum.high - end is exact where it matters
      const double error = 1.0625 * offset_.error + 2 * kUnit * std::fabs(beyond);
      if (end == 0 ? beyond < -error : beyond > error) {
        times = kOutside;
        return true;
      }
      if (std::fabs(beyond) > error) continue;
      if (!within_radius(end)) {
        times = kUncertain;
        return true;
      }
      const int side = look_from(end);
      if (side == 0) {
        times = {Times::Found::yes, end, end};
        return true;
      }
      if (side == (end == 0 ? -1 : 1)) {
        times = kOutside;
        return true;
      }
      break;  // and so far away from the other end
    }
    return settle(times);
  }

  bool within_radius(double time) const { return std::fabs(time - root_.t) <= root_.radius; }

  /// On which side of `time` the root lies, exactly (1: after it). The root's offset from there becomes the one to use: it is
  /// -V(time) / V'(x) for some x between; V'(x) is at least half of the computed slope, and off by at most `spread`.
  int look_from(double time) {
    const double value = exact_value_(query_, time);
    base_ = time;
    offset_.value = -value / root_.slope;
    const double spread = root_.slope_error + root_.curvature * std::max(offset_.reach, std::fabs(time - root_.t));
    const double steepness = std::fabs(root_.slope);
    offset_.error = std::fabs(offset_.value) * (1.0625 * 2 * spread / steepness + 16 * kUnit) + 0x1p-1070 / steepness;
    return value == 0 ? 0 : (value > 0) == (root_.slope > 0) ? -1 : 1;
  }

  /// Whether the offset is good enough to tell. The root is known to be in (0, 1).
  bool settle(Times& times) {
    const numbers::DoubleDouble sum = numbers::two_sum(base_, offset_.value);
    const double nearest = sum.high;
    const double rest = sum.low;  // the root is nearest + rest, give or take the error
    if (!(nearest > 0 && nearest <= 1)) return false;
    if (!(std::fabs(rest) + offset_.error < nearest - before(nearest))) return false;
    int side = rest > offset_.error ? 1 : rest < -offset_.error ? -1 : 0;
    if (side == 0) {
      if (!within_radius(nearest)) return false;
      side = look_from(nearest);
    }
    const double toi = side < 0 ? before(nearest) : nearest;
    times = {Times::Found::yes, toi, side == 0 ? nearest : after(toi)};  // nearest < 1 where side > 0
    return true;
  }

  const Query& query_;
  const SimpleRoot& root_;
  ExactValue exact_value_;
  double base_;
  Offset offset_;
};

}  // namespace

RootVerdict refine_root(const Query& query, const SimpleRoot& root, const ContactFrame& frame, bool inside, double t_max,
                        ExactValue exact_value, Answer& answer) {
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

  const Times times = NeighbouringDoubles(query, root, *offset, exact_value).find();
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
