// SPDX-License-Identifier: MIT
#include "filters/refined_root.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "filters/contact_values.hpp"
#include "filters/coplanarity_form.hpp"
#include "numbers/double_double.hpp"

namespace touchstone::filters {
namespace {

/// The root as an offset from a double.
struct Offset {
  double value;
  double error;  ///< the true offset is off by at most this
};

/// The root's offset from `time`, within the root's radius, where V is `value`, off by at most `value_error` before it was
/// rounded to a double.
///
/// It is -V / S, with S the mean of V' from there to the root: at least half of the root's slope (see SimpleRoot), so it is at
/// most 2 (|value| + value_error) / |slope|, and S differs from V'(t) by at most the curvature times the mean distance
/// from t in between. With q the bound on the relative difference of S from the slope, and as 1 / S <= (1 + 2 q) / slope,
/// -value / slope is off by at most (1 + 2 q) (value_error + q |value|) / slope, its own rounding and the value's. The factor
/// has slack for the rounding of these lines and of sums with the result.
Offset offset_of(const SimpleRoot& root, double time, double value, double value_error) noexcept {
  const double per_slope = 1 / std::fabs(root.slope);
  const double distance = std::fabs(time - root.t) + (std::fabs(value) + value_error) * per_slope;
  const double q = (root.slope_error + root.curvature * distance) * per_slope;
  const double missing = (1 + 2 * q) * (value_error + q * std::fabs(value)) + 2 * kUnit * std::fabs(value);
  return {-value / root.slope, (1 + 0x1p-20) * missing * per_slope};
}

/// How far a component of n, f1 or f2 at the root, or a difference of them, may be from what its value and slope make of it,
/// over M, the product of the bounds of its vectors (or the sum of such products).
///
/// Its value before rounding is off by kComponentError M = 103 e^2 M. Its slope, at most 8 M, sums 4 products in a component, of
/// two factors off by 4 e and 1 e times their bounds, (4 + 2 + 2) e M each, 4 e M, 4 e M and 8 e M for their sums, and for
/// differences 8 e M and 8 e M more: 64 e M. The product of slope and offset, and the value, which is at most the sum of that
/// and the result, are rounded: 8 e M |offset| each, 80 e M |offset| in all, which kComponentError / e covers. Its second
/// derivative is at most 16 M; the offset's error weighs 8 M. Where t lies up to kMargin = 2^-20 outside of [0, 1],
/// coordinates are larger by 2^-19 of their bounds, and so is the slope, 8 M (1 + 2^-19): of the rounding errors 103 has
/// room for that beside 102 and 80, and of the offset's weight the factor, which also has slack for the rounding of the
/// result and of these lines.
double component_spread(const Offset& offset) noexcept {
  const double away = std::fabs(offset.value);
  const double reach = away + offset.error;
  return (1 + 0x1p-18) * (kComponentError * (1 + away / kUnit) + 8 * (reach * reach + offset.error));
}

double at_root(const ValueAndSlope& component, const Offset& offset) noexcept {
  return component.value + component.slope * offset.value;
}

/// The sign of a component at the root, which is off by at most `error`; 0 when uncertain.
int sign_at_root(const ValueAndSlope& component, const Offset& offset, double error) noexcept {
  const double value = at_root(component, offset);
  return value > error ? 1 : value < -error ? -1 : 0;
}

/// The doubles beside x > 0.
double after(double x) noexcept { return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) + 1); }
double before(double x) noexcept { return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) - 1); }

/// How far an ExactValue is off: 2^-50 of it; and less than 2^-1074 where it underflows, as each of the terms of offset_of may
/// then be.
double exact_value_error(double value) noexcept { return 8 * kUnit * std::fabs(value) + 0x1p-1072; }

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
      if (end == 0 ? beyond < -offset_.error : beyond > offset_.error) {
        times = kOutside;
        return true;
      }
      if (std::fabs(beyond) > offset_.error) continue;
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

  /// On which side of `time` the root lies, exactly (1: after it). The root's offset from there becomes the one to use.
  int look_from(double time) {
    const double value = exact_value_(query_, time);
    base_ = time;
    offset_ = offset_of(root_, time, value, exact_value_error(value));
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

RootVerdict refine_root(const Query& query, const SimpleRoot& root, const ContactFrame& frame, bool inside,
                        double t_max, ExactValue exact_value, Answer& answer) {
  const bool edges = query.kind == Kind::edge_edge;
  const ContactValues at = contact_values(query.start.data(), query.end.data(), edges, root.t, frame.axis);
  const Offset offset = offset_of(root, root.t, at.coplanarity, kCoplanarityError * frame.product);
  const double spread = component_spread(offset);

  const double uw = frame.u * frame.w;
  const double rw = frame.r * frame.w;
  const double ru = frame.r * frame.u;
  if (!inside) {
    const int s = at.normal.value > 0 ? 1 : -1;
    const int signs[4] = {s * sign_at_root(at.first, offset, spread * rw),
                          s * sign_at_root(at.second, offset, spread * ru),
                          s * sign_at_root(at.third, offset, spread * (edges ? uw + rw : uw + rw + ru)),
                          edges ? s * sign_at_root(at.fourth, offset, spread * (uw + ru)) : 1};
    const int least = std::min({signs[0], signs[1], signs[2], signs[3]});
    if (least < 0) return RootVerdict::outside;
    if (least == 0) return RootVerdict::uncertain;
  }

  const Times times = NeighbouringDoubles(query, root, offset, exact_value).find();
  if (times.found == Times::Found::uncertain) return RootVerdict::uncertain;
  if (times.found == Times::Found::outside) return RootVerdict::outside;
  if (times.toi > t_max || (times.toi == t_max && times.toi < times.toi_upper)) return RootVerdict::too_late;

  // A weight f = a / n in [0, 1], of components off by A and N, is off by at most (A + N) / |n|, here at most 2.75 e; by two
  // roundings in each of a and n, 4 e; and by one of the quotient and one of 1 - f, e / 2 each: 7.75 e of the 8 e = 2^-50
  // that are promised.
  const double normal = at_root(at.normal, offset);
  constexpr double kWeightError = 2.75 * kUnit;
  if (!(spread * (2 * uw + rw + ru) <= kWeightError * std::fabs(normal))) return RootVerdict::uncertain;
  const auto weight = [&](const ValueAndSlope& numerator) {
    return std::clamp(at_root(numerator, offset) / normal, 0.0, 1.0);
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
