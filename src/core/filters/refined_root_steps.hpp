// The steps from a simple root to its neighbouring doubles and a contact's weights, where no exact value is needed. The
// text is written once, for doubles and for packs of them.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "filters/contact_values.hpp"
#include "filters/coplanarity_form.hpp"
#include "filters/refined_root.hpp"
#include "numbers/doubles/double_double.hpp"
#include "numbers/doubles/lanes.hpp"

namespace touchstone::filters {

/// The root as an offset from a double.
template <class N>
struct OffsetOf {
  N value;
  N error;  ///< the true offset is off by at most this
};
using Offset = OffsetOf<double>;

/// The root's offset from `time`, within the root's radius, where V is `value`, off by at most `value_error` before it
/// was rounded to a double.
///
/// It is -V / S, with S the mean of V' from there to the root. |S| is at least half of |slope| (see SimpleRoot), so the
/// offset is at most 2 (|value| + value_error) / |slope|. S differs from V'(t) by at most the curvature times the mean
/// distance from t in between. Let q be the bound on the relative difference of S from the slope;
/// 1 / S <= (1 + 2 q) / slope. Then -value / slope is off by at most (1 + 2 q) (value_error + q |value|) / slope, its
/// own rounding and the value's. The factor has slack for the rounding of these lines and of sums with the result.
template <class N>
TOUCHSTONE_INLINE OffsetOf<N> offset_of(const SimpleRootOf<N>& root, const N& time, const N& value,
                                        const N& value_error) noexcept {
  const N per_slope = 1 / magnitude(root.slope);
  const N distance = magnitude(time - root.t) + (magnitude(value) + value_error) * per_slope;
  const N q = (root.slope_error + root.curvature * distance) * per_slope;
  const N missing = (1 + 2 * q) * (value_error + q * magnitude(value)) + 2 * kUnit * magnitude(value);
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
template <class N>
TOUCHSTONE_INLINE N component_spread(const OffsetOf<N>& offset) noexcept {
  const N away = magnitude(offset.value);
  const N reach = away + offset.error;
  return (1 + 0x1p-18) * (kComponentError * (1 + (1 / kUnit) * away) + 8 * (reach * reach + offset.error));
}

template <class N>
TOUCHSTONE_INLINE N at_root(const ValueAndSlopeOf<N>& component, const OffsetOf<N>& offset) noexcept {
  return component.value + component.slope * offset.value;
}

/// Where the elements certainly do not meet at the root, and where they certainly do.
template <class N>
struct SidesAtRoot {
  using Mask = typename numbers::Lanes<N>::Mask;
  Mask outside, inside;
};

/// @param spread  component_spread
template <class N>
TOUCHSTONE_INLINE SidesAtRoot<N> sides_at_root(Kind kind, const ComponentsAt<N>& at, const MagnitudesOf<N>& m,
                                               const OffsetOf<N>& offset, const N& spread) noexcept {
  using Lanes = numbers::Lanes<N>;
  using Mask = typename Lanes::Mask;
  const N uw = m.u * m.w, rw = m.r * m.w, ru = m.r * m.u;
  const N s = chosen(at.normal.value > 0, Lanes::all(1), Lanes::all(-1));
  const bool edges = kind == Kind::edge_edge;
  SidesAtRoot<N> sides = {Mask{}, Lanes::every()};
  const auto look_at = [&](const ValueAndSlopeOf<N>& component, const N& error) {
    const N value = s * at_root(component, offset);
    sides.outside = Mask(sides.outside | (value < -error));
    sides.inside = Mask(sides.inside & (value > error));
  };
  look_at(at.first, spread * rw);
  look_at(at.second, spread * ru);
  look_at(at.third, spread * (edges ? uw + rw : uw + rw + ru));
  if (edges) look_at(at.fourth, spread * (uw + ru));
  return sides;
}

/// The doubles beside x > 0.
inline double after(double x) noexcept { return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) + 1); }
inline double before(double x) noexcept { return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) - 1); }

/// A root as a sum: nearest + rest, up to the offset's error. `near`: nearest is a double in (0, 1] next to the root,
/// on one side or the other; where `earlier` or `later` is set, too, the root certainly lies before or after it.
template <class N>
struct NearestDouble {
  using Mask = typename numbers::Lanes<N>::Mask;
  N nearest;
  Mask near, earlier, later;
};

template <class N>
TOUCHSTONE_INLINE NearestDouble<N> nearest_double(const N& base, const OffsetOf<N>& offset) noexcept {
  using Mask = typename numbers::Lanes<N>::Mask;
  const auto [nearest, rest] = numbers::two_sum(base, offset.value);
  const Mask near = Mask((nearest > 0) & (nearest <= 1) & (magnitude(rest) + offset.error < nearest - before(nearest)));
  return {nearest, near, Mask(rest < -offset.error), Mask(rest > offset.error)};
}

/// Whether a contact between two neighbouring doubles is after t_max; its own time is not when both are equal to it.
template <class N>
TOUCHSTONE_INLINE typename numbers::Lanes<N>::Mask is_late(const N& toi, const N& toi_upper, const N& t_max) noexcept {
  return (toi > t_max) | ((toi >= t_max) & (toi < toi_upper));
}

/// The weights of a contact at a root, as RefinedRoot has them, and where they are certain.
template <class N>
struct WeightsAtRoot {
  typename numbers::Lanes<N>::Mask certain;
  std::array<N, 3> weights;
};

// A weight f = a / n in [0, 1], of components off by A and N, is off by at most (A + N) / |n|, here at most 2.75 e; by
// two roundings in each of a and n, 4 e; and by one of the quotient and one of 1 - f, e / 2 each. In all 7.75 e of the
// promised 8 e = 2^-50.
constexpr double kWeightError = 2.75 * kUnit;

template <class N>
TOUCHSTONE_INLINE WeightsAtRoot<N> weights_at_root(Kind kind, const ComponentsAt<N>& at, const MagnitudesOf<N>& m,
                                                   const OffsetOf<N>& offset, const N& spread) noexcept {
  const N uw = m.u * m.w, rw = m.r * m.w, ru = m.r * m.u;
  const N normal = at_root(at.normal, offset);
  const N zero = numbers::Lanes<N>::all(0), one = numbers::Lanes<N>::all(1);
  const auto weight = [&](const ValueAndSlopeOf<N>& numerator) {
    const N quotient = at_root(numerator, offset) / normal;
    return chosen(quotient < 0, zero, chosen(quotient > 1, one, quotient));
  };
  const typename numbers::Lanes<N>::Mask certain = spread * (2 * uw + rw + ru) <= kWeightError * magnitude(normal);
  if (kind == Kind::edge_edge) return {certain, {weight(at.first), weight(at.second), zero}};
  return {certain, {weight(at.third), weight(at.first), weight(at.second)}};
}

}  // namespace touchstone::filters
