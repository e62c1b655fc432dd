// The coplanarity cubic in Bernstein form over the step, and the proof that it keeps one sign, with every bound on the
// rounding. The text is written once, for doubles and for vectors of doubles. Each operator must be one IEEE operation
// in every lane.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>

#include "geometry/frame.hpp"
#include "geometry/vector.hpp"

namespace touchstone::filters {

/// Unit roundoff of a double, 2^-53.
constexpr double kUnit = 0x1p-53;

// The error of the coefficients. Let U, W, R be the largest absolute coordinates of the computed u, w, r over both
// ends, P = U W R, e = 2^-53. A determinant is linear in each of its entries. It is largest for entries of +-1, where
// it is 4 (Hadamard). So |[u w r]| <= 4 P, and the absolute coordinates of a cross product sum to at most 4 U W. To
// first order:
//   b0 = (u0 x w0) . r0.
//     The rounded differences: three vectors, each off by e times its bound: 3 * 4 e P.
//     The cross product: products of at most 2 U W a coordinate, 6 e P, and a subtraction each, 4 e P.
//     The dot product: three products, 4 e P, and two additions of at most 4 P, 8 e P.
//     In all 12 + 6 + 4 + 4 + 8 = 34 e P.
//   3 b1 = (u0 x w1 + u1 x w0) . r0 + (u0 x w0) . r1, three determinants.
//     Differences: 36 e P. Cross products: 30 e P. Their sum, of at most 8 U W in all: 8 e P.
//     The dot product with that sum: 8 + 16 e P. The other dot product: 4 + 8 e P. The sum of both, of at most 12 P:
//     12 e P. In all 36 + 30 + 8 + 24 + 12 + 12 = 122 e P.
// The constants have a reserve over that. It covers three things:
//   - the second-order terms (relative 2^-48);
//   - the rounding of the bound itself (2 products, and one by the constant: relative 3 e);
//   - underflow. A product that underflows is off by at most 2^-1075, in all by 18 * 2^-1075 R + 6 * 2^-1075. That is
//     below e P / 2 when U W and U W R are at least 2^-1000. (Differences of doubles do not underflow.)
constexpr double kEndsBound = 35 * kUnit;
constexpr double kMiddleBound = 123 * kUnit;

// Within these the guard above holds and nothing overflows: no partial sum exceeds 18 P (1 + 2^-48).
constexpr double kLeastProduct = 0x1p-1000;
constexpr double kGreatestProduct = 0x1p1000;

/// Whether the bounds hold for these U W and U W R: a bool, or a vector of them.
template <class N>
TOUCHSTONE_INLINE auto products_in_range(const N& uw, const N& uwr) noexcept {
  const auto uw_in_range = (uw >= kLeastProduct) & (uw <= kGreatestProduct);
  const auto uwr_in_range = (uwr >= kLeastProduct) & (uwr <= kGreatestProduct);
  return decltype(uw > uwr)(uw_in_range & uwr_in_range);
}

/// The frame at both ends of the step. Each coordinate is one rounded subtraction of two of the query's doubles.
template <class N>
struct StepFrame {
  geometry::Frame<geometry::Vector<N>> start, end;
};

/// The frame of the corners that corner(side, i), i = 0 .. 3, gives at the step's start (side 0) and end (1), for an
/// edge-edge or vertex-face query.
template <class N, class Corner>
TOUCHSTONE_INLINE StepFrame<N> step_frame(Kind kind, const Corner& corner) {
  const auto at = [kind, &corner](int side) {
    return geometry::frame_of(
        kind, [&corner, side](std::size_t i, std::size_t j) { return corner(side, i) - corner(side, j); });
  };
  return {at(0), at(1)};
}

/// The Bernstein coefficients n0, 2 n1, n2 of n = u x w over [0, 1].
template <class N>
using NormalCoefficients = std::array<geometry::Vector<N>, 3>;
template <class N>
TOUCHSTONE_INLINE NormalCoefficients<N> normal_coefficients(const StepFrame<N>& f) noexcept {
  using geometry::cross;
  const geometry::Vector<N> c01 = cross(f.start.u, f.end.w);
  const geometry::Vector<N> c10 = cross(f.end.u, f.start.w);
  return {cross(f.start.u, f.start.w), {{c01[0] + c10[0], c01[1] + c10[1], c01[2] + c10[2]}}, cross(f.end.u, f.end.w)};
}

/// The Bernstein coefficients b0, 3 b1, 3 b2, b3 of V = (u x w) . r over [0, 1].
template <class N>
TOUCHSTONE_INLINE std::array<N, 4> coplanarity_coefficients(const StepFrame<N>& f,
                                                            const NormalCoefficients<N>& n) noexcept {
  using geometry::dot;
  const auto& r0 = f.start.r;
  const auto& r1 = f.end.r;
  return {dot(n[0], r0), dot(n[1], r0) + dot(n[0], r1), dot(n[2], r0) + dot(n[1], r1), dot(n[2], r1)};
}
/// The same without n, which keeps fewer numbers at a time: it is faster.
template <class N>
TOUCHSTONE_INLINE std::array<N, 4> coplanarity_coefficients(const StepFrame<N>& f) noexcept {
  using geometry::cross;
  using geometry::dot;
  const auto& [u0, w0, r0] = f.start;
  const auto& [u1, w1, r1] = f.end;
  const geometry::Vector<N> n0 = cross(u0, w0);
  const geometry::Vector<N> n2 = cross(u1, w1);
  const geometry::Vector<N> c01 = cross(u0, w1);
  const geometry::Vector<N> c10 = cross(u1, w0);
  const geometry::Vector<N> n1 = {{c01[0] + c10[0], c01[1] + c10[1], c01[2] + c10[2]}};
  return {dot(n0, r0), dot(n1, r0) + dot(n0, r1), dot(n2, r0) + dot(n1, r1), dot(n2, r1)};
}

inline double magnitude(double x) noexcept { return std::fabs(x); }
/// x, or -x where s is negative.
inline double flipped(double x, double s) noexcept { return x * std::copysign(1.0, s); }
inline double larger(double a, double b) noexcept { return a > b ? a : b; }
inline double smaller(double a, double b) noexcept { return a < b ? a : b; }
inline double chosen(bool mask, double a, double b) noexcept { return mask ? a : b; }

/// The largest absolute coordinate of both, where no coordinate is NaN.
template <class N>
TOUCHSTONE_INLINE N largest(const geometry::Vector<N>& a, const geometry::Vector<N>& b) noexcept {
  return larger(larger(larger(magnitude(a[0]), magnitude(b[0])), larger(magnitude(a[1]), magnitude(b[1]))),
                larger(magnitude(a[2]), magnitude(b[2])));
}

/// Bounds on the coordinates of the frame over the step: U, W, R of the derivations.
template <class N>
struct MagnitudesOf {
  N u, w, r;
};
template <class N>
TOUCHSTONE_INLINE MagnitudesOf<N> magnitudes_of(const StepFrame<N>& f) noexcept {
  return {largest(f.start.u, f.end.u), largest(f.start.w, f.end.w), largest(f.start.r, f.end.r)};
}

/// Bounds on the absolute errors of the coefficients: `ends` for b0 and b3, `middle` for 3 b1 and 3 b2. They hold only
/// where `valid` is true; elsewhere a product may underflow or overflow.
template <class N>
struct CoefficientBounds {
  N ends;
  N middle;
  decltype(N() > N()) valid;  ///< a bool, or a vector of them
};

template <class N>
TOUCHSTONE_INLINE CoefficientBounds<N> coplanarity_bounds(const StepFrame<N>& f) noexcept {
  const N uw = largest(f.start.u, f.end.u) * largest(f.start.w, f.end.w);
  const N uwr = uw * largest(f.start.r, f.end.r);
  return {kEndsBound * uwr, kMiddleBound * uwr, products_in_range(uw, uwr)};
}

/// Whether V certainly has one sign all over [0, 1]: its four coefficients have that sign, and V lies in their hull.
///
/// Coordinates that are not finite never prove it. Every coordinate of a query is in a component of the frame at its
/// end of the step, and every component is in some product of b0 or b3. If a component is NaN, so is b0 or b3, and
/// comparisons with that are false. If none is NaN and one is infinite, its vector's bound is infinite, and U W R is
/// infinite or NaN.
template <class N>
TOUCHSTONE_INLINE auto certain_same_side(const StepFrame<N>& f, const std::array<N, 4>& b) noexcept {
  const auto [ends, middle, valid] = coplanarity_bounds(f);
  return valid & (magnitude(b[0]) > ends) & (flipped(b[1], b[0]) > middle) & (flipped(b[2], b[0]) > middle) &
         (flipped(b[3], b[0]) > ends);
}

// Clearance. The lines of two edges, or a vertex and a face's plane, are |V| / |n| apart where n is not zero, and the
// elements at least as far. So they are farther apart than d all along where |V| > d |n| in all of [0, 1]; V != 0 then
// excludes n = 0. In the largest-axis metric the sum of n's absolute coordinates takes |n|'s place, because n . x is at
// most that sum times x's largest coordinate. V and n lie in the hulls of their Bernstein coefficients. So it is enough
// that V's have one sign, each |b_i| > d max |n_j|.
//
// The error of the norms, e = 2^-53, to first order. A coordinate of n0 or n2, a difference of two products: 2 e U W
// from each of u and w, 2 e U W from the products, 2 e U W from the difference, in all 8 e U W. A coordinate of 2 n1
// has twice that, and 4 e U W for the sum of both parts: 20 e U W, of which n1 has half. So a norm is off by at most
// sqrt(3) times 10 e U W, and a sum of absolute coordinates by 30 e U W. Squares, their sums and the root: at most a
// relative 3.5 e; sums of absolute values: 2 e. The halving is exact. The product with d and the sum with the error
// bound: 3 e. With the constants below, 8 e covers both relative errors and the second-order terms, and 32 e U W the
// absolute one. Squares that underflow are off by 3 * 2^-1075 in all, and the root by less than 2^-530: below e U W
// when U W is at least 2^-400. The product with d is off by 2^-1075 where it underflows: below e U W R / 8 when U W R
// is at least 2^-900, a part of the reserve of kEndsBound and kMiddleBound.
constexpr double kNormFactor = 1 + 8 * kUnit;
constexpr double kNormBound = 32 * kUnit;
constexpr double kLeastNormProduct = 0x1p-400;
constexpr double kGreatestNormProduct = 0x1p400;
constexpr double kLeastVolume = 0x1p-900;
constexpr double kGreatestVolume = kGreatestProduct;

/// Whether no product of the norms underflows or overflows by more than their bounds allow.
template <class N>
TOUCHSTONE_INLINE auto norms_in_range(const N& uw, const N& uwr) noexcept {
  return (uw >= kLeastNormProduct) & (uw <= kGreatestNormProduct) & (uwr >= kLeastVolume) & (uwr <= kGreatestVolume);
}

inline double square_root(double x) noexcept { return std::sqrt(x); }

/// An upper bound on |n|, in the norm that belongs to the metric, over [0, 1], before kNormFactor and kNormBound.
template <bool Euclidean, class N>
TOUCHSTONE_INLINE N greatest_norm(const NormalCoefficients<N>& n) noexcept {
  const auto norm = [](const geometry::Vector<N>& v) {
    if constexpr (Euclidean) return geometry::dot(v, v);
    return magnitude(v[0]) + magnitude(v[1]) + magnitude(v[2]);
  };
  // The middle one is twice too large, and its square four times.
  const N middle = (Euclidean ? 0.25 : 0.5) * norm(n[1]);
  const N greatest = larger(larger(norm(n[0]), norm(n[2])), middle);
  return Euclidean ? square_root(greatest) : greatest;
}

/// Whether the elements are certainly farther apart than the distance all over [0, 1]. Coordinates that are not finite
/// never prove it, as for certain_same_side: `larger` may drop a NaN of n, but b0 or b3 then is NaN, too.
template <bool Euclidean, class N>
TOUCHSTONE_INLINE auto certain_clearance(const StepFrame<N>& f, const N& distance) noexcept {
  const NormalCoefficients<N> n = normal_coefficients(f);
  const std::array<N, 4> b = coplanarity_coefficients(f, n);
  const N uw = largest(f.start.u, f.end.u) * largest(f.start.w, f.end.w);
  const N uwr = uw * largest(f.start.r, f.end.r);
  const N kept = distance * (kNormFactor * greatest_norm<Euclidean>(n) + kNormBound * uw);
  const N ends = kEndsBound * uwr + kNormFactor * kept;
  const N middle = kMiddleBound * uwr + kNormFactor * (3.0 * kept);
  return norms_in_range(uw, uwr) & (magnitude(b[0]) > ends) & (flipped(b[1], b[0]) > middle) &
         (flipped(b[2], b[0]) > middle) & (flipped(b[3], b[0]) > ends);
}

}  // namespace touchstone::filters
