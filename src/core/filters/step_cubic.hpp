// A cubic over [0, 1], and a little beyond, known up to rounding errors: certified sign variations over the step, and
// one root certified to an interval. The text is written once, for doubles and for packs of them.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "filters/coplanarity_form.hpp"
#include "numbers/doubles/lanes.hpp"

namespace touchstone::filters {

// e = kUnit and P = size throughout. The given coefficients are off by at most 34 e P (b0, b3) and 122 e P (3 b1, 3 b2)
// but for what their bounds have in reserve, and in absolute value at most 4 P and 12 P (see coplanarity_form.hpp).
// Times are exact_to_one, so s = 1 - t is exact. For t in [-m, 1 + m], m = kMargin = 2^-20, |s| + |t| is at most
// 1 + 2 m, and sums weighted by products of three of s and t grow by less than 1 + 2^-17: each constant has more slack
// than that.

// The value (c0 s + c1 t) s^2 + (c2 s + c3 t) t^2: the coefficients' errors weigh
// 34 (s^3 + t^3) + 122 s t = 34 + 20 s t <= 39 e P; each monomial passes through 5 roundings, and their absolute values
// sum to at most 4 P: 20 e P.
constexpr double kValueBound = 60 * kUnit;

// The derivative's Bernstein coefficients 3 b1 - 3 b0, 3 b2 - 3 b1, 3 b3 - 3 b2, at most 24 P: off by 122 + 3 * 34 and
// the roundings 12 + 24, or by 2 * 122 + 24, at most 268 e P. Its value: at most 4 roundings of monomials that sum to
// at most 24 P, 96 e P more. The curvature is twice the difference of two of these coefficients, off by
// 2 (260 + 268 + 48) = 1152 e P. At most 2^-10 away this makes 1.2 e P of slope, which this constant includes.
constexpr double kSlopeBound = 366 * kUnit;

/// Certain sign variations of Bernstein coefficients; neither is set where they are uncertain.
template <class N>
struct SignVariations {
  using Mask = typename numbers::Lanes<N>::Mask;
  Mask none, one;
};

/// The sign variations of coefficients that are off by at most `ends` (the first and the last) and `middle`.
template <class N>
TOUCHSTONE_INLINE SignVariations<N> variations_of(const std::array<N, 4>& b, const N& ends, const N& middle) noexcept {
  using Mask = typename numbers::Lanes<N>::Mask;
  const N at_start = magnitude(b[0]), at_end = magnitude(b[3]);
  const Mask certain_ends = (at_start > ends) & (at_end > ends);
  const N second = flipped(b[1], b[0]), third = flipped(b[2], b[0]), last = flipped(b[3], b[0]);
  // One variation whatever the uncertain signs are, unless the middle ones may change sign twice.
  return {Mask(certain_ends & (last > 0) & (second > middle) & (third > middle)),
          Mask(certain_ends & (last < 0) & ((second > middle) | (third < -middle)))};
}

/// See BernsteinCubic, which is this for doubles, and more.
template <class N>
class StepCubic {
 public:
  using Lanes = numbers::Lanes<N>;
  using Mask = typename Lanes::Mask;

  /// All functions hold for t in [-kMargin, 1 + kMargin]. So a root at or near the step's end is no different from
  /// others.
  static constexpr double kMargin = 0x1p-20;
  static constexpr double kGreatestRadius = 0x1p-10;

  /// `coefficients` b0, 3 b1, 3 b2, b3 as coplanarity_coefficients computes them, from vectors whose coordinates'
  /// bounds have the product `size`.
  StepCubic(const std::array<N, 4>& c, const N& size) noexcept
      : c_(c), size_(size), d0_(c[1] - 3 * c[0]), d1_(c[2] - c[1]), d2_(3 * c[3] - c[2]) {
    // V'' is linear in t between twice these differences, and beyond by at most 2 m times more.
    curvature_ = (2 + 0x1p-17) * larger(magnitude(d1_ - d0_), magnitude(d2_ - d1_));
  }

  /// The variations over [0, 1].
  SignVariations<N> step_variations() const noexcept {
    return variations_of(c_, kEndsBound * size_, kMiddleBound * size_);
  }

  /// Where [p, q] has exactly one root: proves that it lies in [t - radius, t + radius], inside [p, q], where the
  /// cubic's slope keeps the sign of `slope` and is at least half of it. Certain only if so.
  struct Root {
    Mask certain;
    N t;       ///< exact_to_one
    N radius;  ///< at most kGreatestRadius
    N slope;   ///< the cubic's derivative at t, off by at most slope_error()
  };
  Root root_between(const N& p, const N& q) const noexcept { return root_between(p, q, Lanes::every()); }
  /// The same, only where the mask is set: the other lanes do not wait for a root, and none is certain there.
  Root root_between(const N& p, const N& q, const Mask& where) const noexcept;

  /// The cubic's value and slope at t, off by at most value_error() and slope_error().
  N value(const N& t) const noexcept { return value(1 - t, t); }
  N slope(const N& t) const noexcept { return slope(1 - t, t); }
  N value_error() const noexcept { return kValueBound * size_; }
  N slope_error() const noexcept { return kSlopeBound * size_; }
  N size() const noexcept { return size_; }

  /// At h away from t, |h| <= kGreatestRadius, the slope differs from slope(t) by at most slope_error() + curvature()
  /// |h|.
  N curvature() const noexcept { return curvature_; }

 protected:
  /// At t = 1 - s.
  N value(const N& s, const N& t) const noexcept {
    return (c_[0] * s + c_[1] * t) * (s * s) + (c_[2] * s + c_[3] * t) * (t * t);
  }
  N slope(const N& s, const N& t) const noexcept { return (d0_ * s + 2 * d1_ * t) * s + d2_ * t * t; }

  std::array<N, 4> c_;  // b0, 3 b1, 3 b2, b3
  N size_;
  N d0_, d1_, d2_;  // Bernstein coefficients of the derivative
  N curvature_;
};

template <class N>
typename StepCubic<N>::Root StepCubic<N>::root_between(const N& p, const N& q, const Mask& where) const noexcept {
  // Halley's method, kept inside by bisection; the code below certifies its result. `refine_root` takes one more step,
  // in double-double. The iteration ends where that step's error, a multiple of its length squared, is about 2^-70 t:
  // then it seldom matters for the side of a double on which the root lies.
  const N value_p = value(p);
  const N value_q = value(q);
  N low = p;
  N high = q;
  N s = 1 - (p + (q - p) * (value_p / (value_p - value_q)));  // the chord's zero
  N t = 1 - s;                                                // exact_to_one
  N v = value(s, t);
  N d = slope(s, t);
  constexpr int kIterations = 30;
  constexpr double kNearEnough = 0x1p-38;
  const N bound = value_error();  // below it a sign means nothing
  for (int i = 0; i < kIterations; ++i) {
    const Mask near = magnitude(v) <= kNearEnough * t * magnitude(d);
    const Mask active = where & (magnitude(v) > bound) & (near == 0);  // a lane that is not stays where it is
    if (!Lanes::any(active)) break;
    const Mask is_low = (v < 0) == (value_p < 0);
    low = chosen(active & is_low, t, low);
    high = chosen(active & (is_low == 0), t, high);
    const N half_curvature = (d1_ - d0_) + t * ((d2_ - d1_) - (d1_ - d0_));
    const N step = t - v * d / (d * d - v * half_curvature);
    const N next = chosen((step > low) & (step < high), step, 0.5 * low + 0.5 * high);
    s = chosen(active, 1 - next, s);
    t = 1 - s;
    v = value(s, t);
    d = slope(s, t);
  }
  const N error = magnitude(v) + value_error();
  const N steepness = magnitude(d);
  // A root lies within the radius: the slope is at least half of |d| there, and half of |d| times the radius reaches
  // beyond any value that V(t) may have. The factors have slack for the rounding of these lines.
  const N radius = 2.0625 * error / steepness;
  const Mask certain = where & (radius <= kGreatestRadius) &
                       (curvature_ * radius + slope_error() <= 0.484375 * steepness) & (t - radius > p) &
                       (t + radius < q);
  return {certain, t, radius, d};
}

}  // namespace touchstone::filters
