// The side conditions over a bracket of one root of V. The text is written once, for doubles and for packs of them.
// SPDX-License-Identifier: MIT
#pragma once

#include "filters/coplanarity_form.hpp"
#include "filters/step_cubic.hpp"
#include "numbers/doubles/lanes.hpp"

namespace touchstone::filters {

// With U, W and R between these, no product of three underflows or overflows to an effect, and no low part of one does.
// The loss is at most 2^-1074 per product, 2^-500 of U W and 2^-300 of U W R.
constexpr double kLeastMagnitude = 0x1p-250;
constexpr double kGreatestMagnitude = 0x1p250;

template <class N>
TOUCHSTONE_INLINE typename numbers::Lanes<N>::Mask within_range(const MagnitudesOf<N>& m) noexcept {
  const N least = smaller(smaller(m.u, m.w), m.r), greatest = larger(larger(m.u, m.w), m.r);
  return (least >= kLeastMagnitude) & (greatest <= kGreatestMagnitude);
}

/// Whether all of a bracket is outside of [0, t_max], and whether all of it is inside.
template <class N>
struct RootTime {
  using Mask = typename numbers::Lanes<N>::Mask;
  Mask outside, inside;
};
template <class N>
TOUCHSTONE_INLINE RootTime<N> time_of(const typename StepCubic<N>::Root& root, const N& t_max) noexcept {
  using Mask = typename numbers::Lanes<N>::Mask;
  const N first = root.t - root.radius, last = root.t + root.radius;
  return {Mask((first > t_max) | (last < 0)), Mask((first > 0) & (last < t_max))};
}

template <class N>
TOUCHSTONE_INLINE geometry::Vector<N> at(const geometry::Vector<N>& start, const geometry::Vector<N>& end,
                                         const N& t) noexcept {
  const N s = 1 - t;
  return {{s * start[0] + t * end[0], s * start[1] + t * end[1], s * start[2] + t * end[2]}};
}

/// A value; the true one is at most `error` away.
template <class N>
struct WithError {
  N value;
  N error;
};

/// n, f1 and f2 along the axis where n is largest, each times the sign of n there. The side conditions compare them.
template <class N>
struct SideValues {
  typename numbers::Lanes<N>::Axis axis;
  N signed_normal;  ///< n itself
  WithError<N> normal, first, second;
};

// At t, exact_to_one, the vectors u, w and r are off by at most 3 e times their bound: the rounded differences, two
// products and a sum. A component of a cross product of two of them has 2 monomials with 3 + 3 + 2 roundings: 16 e. Its
// slope in t is at most 2 (2 + 2) = 8 times the product of the bounds, since a coordinate changes by at most twice its
// bound over the step. So at any time within h of t the component is off by at most (16 e + 8 h) times the product.
// Within kMargin of the step, bounds and slopes grow by less than 2^-18 of themselves; the constants cover that.
template <class N>
TOUCHSTONE_INLINE SideValues<N> side_values(Kind kind, const StepFrame<N>& f, const MagnitudesOf<N>& m, const N& t,
                                            const N& h) noexcept {
  using Lanes = numbers::Lanes<N>;
  const geometry::Frame<geometry::Vector<N>> frame = {at(f.start.u, f.end.u, t), at(f.start.w, f.end.w, t),
                                                      at(f.start.r, f.end.r, t)};
  const geometry::Vector<N> n = geometry::normal(frame);
  const auto k = Lanes::greatest(magnitude(n[0]), magnitude(n[1]), magnitude(n[2]));
  const N n_k = Lanes::turned(n, k)[0];
  const geometry::Frame<geometry::Vector<N>> turned = {Lanes::turned(frame.u, k), Lanes::turned(frame.w, k),
                                                       Lanes::turned(frame.r, k)};
  const N spread = 17 * kUnit + (8 + 0x1p-10) * h;
  return {k,
          n_k,
          {magnitude(n_k), spread * m.u * m.w},
          {flipped(geometry::first_numerator(turned, 0), n_k), spread * m.r * m.w},
          {flipped(geometry::second_numerator(kind, turned, 0), n_k), spread * m.r * m.u}};
}

/// Where the two lines, or the point and the plane, meet at the roots that the values are for. Where none is set, it is
/// close to a border: a closer look may tell.
template <class N>
struct Sides {
  using Mask = typename numbers::Lanes<N>::Mask;
  Mask unknown;  ///< n may be zero
  Mask outside, inside;
};

template <class N>
TOUCHSTONE_INLINE Sides<N> sides_of(Kind kind, const SideValues<N>& values) noexcept {
  using Mask = typename numbers::Lanes<N>::Mask;
  const auto& [axis, signed_normal, normal, first, second] = values;
  const Mask known = normal.value > normal.error;
  // Each must be >= 0. `minus` counts its own rounding; the slack of 1 e in `spread` is for terms of e^2.
  const auto minus = [](const WithError<N>& a, const WithError<N>& b) {
    return WithError<N>{a.value - b.value, a.error + b.error + kUnit * (magnitude(a.value) + magnitude(b.value))};
  };
  const auto below = [](const WithError<N>& a) { return Mask(a.value < -a.error); };
  const auto above = [](const WithError<N>& a) { return Mask(a.value > a.error); };
  const WithError<N> without_first = minus(normal, first);
  const bool edges = kind == Kind::edge_edge;
  const WithError<N> third = edges ? without_first : minus(without_first, second);
  Mask outside = below(first), inside = above(first);
  const auto take = [&](const WithError<N>& next) {
    const Mask is_below = below(next), is_above = above(next);
    outside = outside | is_below;
    inside = inside & is_above;
  };
  take(second);
  take(third);
  if (edges) take(minus(normal, second));
  return {Mask(known == 0), Mask(known & outside), Mask(known & inside)};
}

}  // namespace touchstone::filters
