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
/// edge-edge query (`edges`) or a vertex-face query.
template <class N, class Corner>
TOUCHSTONE_INLINE StepFrame<N> step_frame(bool edges, const Corner& corner) {
  const auto at = [edges, &corner](int side) {
    return geometry::frame_of(
        edges, [&corner, side](std::size_t i, std::size_t j) { return corner(side, i) - corner(side, j); });
  };
  return {at(0), at(1)};
}

/// The Bernstein coefficients b0, 3 b1, 3 b2, b3 of V = (u x w) . r over [0, 1].
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
  // Twice the middle Bernstein coefficient of n = u x w.
  const geometry::Vector<N> n1 = {{c01[0] + c10[0], c01[1] + c10[1], c01[2] + c10[2]}};
  return {dot(n0, r0), dot(n1, r0) + dot(n0, r1), dot(n2, r0) + dot(n1, r1), dot(n2, r1)};
}

inline double magnitude(double x) noexcept { return std::fabs(x); }
/// x, or -x where s is negative.
inline double flipped(double x, double s) noexcept { return x * std::copysign(1.0, s); }
inline double larger(double a, double b) noexcept { return a > b ? a : b; }

/// The largest absolute coordinate of both, where no coordinate is NaN.
template <class N>
TOUCHSTONE_INLINE N largest(const geometry::Vector<N>& a, const geometry::Vector<N>& b) noexcept {
  return larger(larger(larger(magnitude(a[0]), magnitude(b[0])), larger(magnitude(a[1]), magnitude(b[1]))),
                larger(magnitude(a[2]), magnitude(b[2])));
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

}  // namespace touchstone::filters
