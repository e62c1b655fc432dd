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

/// The root as an offset from a double.
struct Offset {
  double value;
  double error;  ///< the true offset is off by at most this
};

/// The root's offset from `time`, within the root's radius, where V is `value`, off by at most `value_error` before it
/// was rounded to a double.
///
/// It is -V / S, with S the mean of V' from there to the root. |S| is at least half of |slope| (see SimpleRoot), so the
/// offset is at most 2 (|value| + value_error) / |slope|. S differs from V'(t) by at most the curvature times the mean
/// distance from t in between. Let q be the bound on the relative difference of S from the slope;
/// 1 / S <= (1 + 2 q) / slope. Then -value / slope is off by at most (1 + 2 q) (value_error + q |value|) / slope, its
/// own rounding and the value's. The factor has slack for the rounding of these lines and of sums with the result.
Offset offset_of(const SimpleRoot& root, double time, double value, double value_error) noexcept {
  const double per_slope = 1 / std::fabs(root.slope);
  const double distance = std::fabs(time - root.t) + (std::fabs(value) + value_error) * per_slope;
  const double q = (root.slope_error + root.curvature * distance) * per_slope;
  const double missing = (1 + 2 * q) * (value_error + q * std::fabs(value)) + 2 * kUnit * std::fabs(value);
  return {-value / root.slope, (1 + 0x1p-20) * missing * per_slope};
}

/// A bound on the error of value + slope * offset, for a component of n, f1 or f2 at the root or a difference of them.
/// It is in units of M, the product of the bounds of its vectors (or the sum of such products).
///
/// The value before rounding is off by kComponentError M = 103 e^2 M.
/// The slope is at most 8 M. In a component it sums 4 products of two factors that are off by 4 e and 1 e times their
/// bounds: (4 + 2 + 2) e M each; 4 e M, 4 e M and 8 e M for their sums; and 8 e M and 8 e M more for differences:
/// 64 e M. The product of slope and offset is rounded, and so is the value, which is at most the sum of that product
/// and the result: 8 e M |offset| each, 80 e M |offset| in all, which kComponentError / e covers.
/// The second derivative is at most 16 M. The offset's error weighs 8 M.
/// Where t lies up to kMargin = 2^-20 outside of [0, 1], coordinates are larger by 2^-19 of their bounds, and so is the
/// slope, 8 M (1 + 2^-19). For the rounding errors, 103 has room for that beside 102 and 80. For the offset's weight,
/// the factor has; it also has slack for the rounding of the result and of these lines.
double component_spread(const Offset& offset) noexcept {
  const double away = std::fabs(offset.value);
  const double reach = away + offset.error;
  return (1 + 0x1p-18) * (kComponentError * (1 + away / kUnit) + 8 * (reach * reach + offset.error));
}

double at_root(const ValueAndSlope& component, const Offset& offset) noexcept {
  return component.value + component.slope * offset.value;
}

/// The sign of a component at the root, known to within `error`; 0 when uncertain.
int sign_at_root(const ValueAndSlope& component, const Offset& offset, double error) noexcept {
  const double value = at_root(component, offset);
  return value > error ? 1 : value < -error ? -1 : 0;
}

/// The doubles beside x > 0.
double after(double x) noexcept { return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) + 1); }
double before(double x) noexcept { return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) - 1); }

/// A bound on the error of an ExactValue: 2^-50 of it, and less than 2^-1074 where it underflows. The terms of
/// offset_of may underflow too.
double exact_value_error(double value) noexcept { return 8 * kUnit * std::fabs(value) + 0x1p-1072; }

/// Finds the two neighbouring doubles around a root, equal when it is a double. It uses the root's offset and, where
/// this leaves a doubt, V's exact value at a double: its sign tells on which side of the double the root lies, because
/// V is monotone within the root's radius.
///
/// Its results are RefinedRoots without weights: `contact` means that the times are found, `no_contact` that the root
/// lies outside [0, 1].
template <class ValueAt>
class NeighbouringDoubles {
 public:
  /// value_at(t): an ExactValue of the query at t.
  NeighbouringDoubles(const SimpleRoot& root, const Offset& offset, const ValueAt& value_at)
      : root_(root), value_at_(value_at), base_(root.t), offset_(offset) {}

  RefinedRoot find() {
    const bool inner = root_.t - root_.radius > 0 && root_.t + root_.radius < 1;
    if (const std::optional<RefinedRoot> found = inner ? settled() : settled_near_end()) return *found;
    // The root is several doubles away from the nearest, since it is small. A step from there is as good as its value
    // is exact.
    const double nearest = base_ + offset_.value;
    if (!(nearest > 0 && nearest < 1 && within_radius(nearest))) return {};
    if (look_from(nearest) == 0) return {Finding::contact, nearest, nearest};
    return settled().value_or(RefinedRoot{});
  }

 private:
  /// `settled`, for a root that may lie outside [0, 1].
  std::optional<RefinedRoot> settled_near_end() {
    for (const double end : {0.0, 1.0}) {
      const numbers::DoubleDouble sum = numbers::two_sum(base_, offset_.value);
      const double beyond = (sum.high - end) + sum.low;  // sum.high - end is exact where it matters
      if (end == 0 ? beyond < -offset_.error : beyond > offset_.error) return RefinedRoot{Finding::no_contact};
      if (std::fabs(beyond) > offset_.error) continue;
      if (!within_radius(end)) return RefinedRoot{};
      const int side = look_from(end);
      if (side == 0) return RefinedRoot{Finding::contact, end, end};
      if (side == (end == 0 ? -1 : 1)) return RefinedRoot{Finding::no_contact};
      break;  // the root lies inside, and far from the other end
    }
    return settled();
  }

  bool within_radius(double time) const { return std::fabs(time - root_.t) <= root_.radius; }

  /// On which side of `time` the root lies, exactly (1: after it). From now on the offset is counted from there.
  int look_from(double time) {
    const double value = value_at_(time);
    base_ = time;
    offset_ = offset_of(root_, time, value, exact_value_error(value));
    return value == 0 ? 0 : (value > 0) == (root_.slope > 0) ? -1 : 1;
  }

  /// The times of a root in (0, 1); nothing where the offset is not good enough to tell.
  std::optional<RefinedRoot> settled() {
    const numbers::DoubleDouble sum = numbers::two_sum(base_, offset_.value);
    const double nearest = sum.high;
    const double rest = sum.low;  // the root is nearest + rest, up to the offset's error
    if (!(nearest > 0 && nearest <= 1)) return std::nullopt;
    if (!(std::fabs(rest) + offset_.error < nearest - before(nearest))) return std::nullopt;
    int side = rest > offset_.error ? 1 : rest < -offset_.error ? -1 : 0;
    if (side == 0) {
      if (!within_radius(nearest)) return std::nullopt;
      side = look_from(nearest);
    }
    const double toi = side < 0 ? before(nearest) : nearest;
    return RefinedRoot{Finding::contact, toi, side == 0 ? nearest : after(toi)};  // nearest < 1 where side > 0
  }

  const SimpleRoot& root_;
  const ValueAt& value_at_;
  double base_;
  Offset offset_;
};

}  // namespace

RefinedRoot refine_root(const Question& question, const SimpleRoot& root) {
  const auto& [query, t_max, exact_value, wanted] = question;
  const auto& [u, w, r] = root.magnitudes;
  const bool edges = query.kind == Kind::edge_edge;
  const ContactValues at = contact_values(query, root.t, root.axis);
  const Offset offset = offset_of(root, root.t, at.coplanarity, kCoplanarityError * (u * w * r));
  const double spread = component_spread(offset);

  const double uw = u * w;
  const double rw = r * w;
  const double ru = r * u;
  if (!root.inside) {
    const int s = at.normal.value > 0 ? 1 : -1;
    const int signs[4] = {s * sign_at_root(at.first, offset, spread * rw),
                          s * sign_at_root(at.second, offset, spread * ru),
                          s * sign_at_root(at.third, offset, spread * (edges ? uw + rw : uw + rw + ru)),
                          edges ? s * sign_at_root(at.fourth, offset, spread * (uw + ru)) : 1};
    const int least = std::min({signs[0], signs[1], signs[2], signs[3]});
    if (least < 0) return {Finding::no_contact};
    if (least == 0) return {Finding::uncertain};
  }

  const auto value_at = [&question](double time) { return question.exact_value(question.query, time); };
  RefinedRoot refined = NeighbouringDoubles(root, offset, value_at).find();
  if (refined.finding != Finding::contact) return refined;
  if (refined.toi > t_max || (refined.toi == t_max && refined.toi < refined.toi_upper)) return {Finding::no_contact};

  if (wanted != Wanted::all) return refined;

  // A weight f = a / n in [0, 1], of components off by A and N, is off by at most (A + N) / |n|, here at most 2.75 e;
  // by two roundings in each of a and n, 4 e; and by one of the quotient and one of 1 - f, e / 2 each. In all 7.75 e of
  // the promised 8 e = 2^-50.
  const double normal = at_root(at.normal, offset);
  constexpr double kWeightError = 2.75 * kUnit;
  if (!(spread * (2 * uw + rw + ru) <= kWeightError * std::fabs(normal))) return {Finding::uncertain};
  const auto weight = [&](const ValueAndSlope& numerator) {
    return std::clamp(at_root(numerator, offset) / normal, 0.0, 1.0);
  };
  if (edges) {
    refined.weights = {weight(at.first), weight(at.second), 0};
  } else {
    refined.weights = {weight(at.third), weight(at.first), weight(at.second)};
  }
  return refined;
}

}  // namespace touchstone::filters
