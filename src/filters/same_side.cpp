// SPDX-License-Identifier: MIT
#include "filters/same_side.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchstone::filters {
namespace {

/// Unit roundoff of a double, 2^-53.
constexpr double kUnit = 0x1p-53;

// The error of the coefficients. Let U, W, R be the largest absolute coordinates of the computed u, w, r over both ends,
// P = U W R, e = 2^-53. A coefficient is a sum of monomials u_i w_j r_k (signs aside); each computed monomial is the true
// one times a product of factors (1 + d), |d| <= e, one for each rounding that it passes through:
//   b0 = (u0 x w0) . r0: 6 monomials; 3 differences, 2 products, 1 subtraction in the cross product and 2 additions in the
//     dot product: 8 roundings, so |error| <= 6 ((1 + e)^8 - 1) P' with P' >= |monomial|.
//   3 b1 = (u0 x w1 + u1 x w0) . r0 + (u0 x w0) . r1: 12 monomials with 3 + 2 + 1 + 1 + 2 + 1 = 10 roundings and 6 with
//     3 + 2 + 1 + 2 + 1 = 9: |error| <= (12 * 10 + 6 * 9) e P' = 174 e P' to first order.
// True monomials are at most P (1 + e)^3, since a computed difference is the true one times (1 + d) (differences of
// doubles do not underflow). So to first order the errors are 48 e P and 174 e P; what the constants have over that
// covers the second-order terms (relative 2^-48), the rounding of the bound itself (2 products and one by the constant:
// relative 3 e) and underflow: a product that underflows is off by at most 2^-1075, in all by 18 * 2^-1075 R +
// 6 * 2^-1075, which is below e P / 2 when U W and U W R are at least 2^-1000.
constexpr double kEndsBound = 49 * kUnit;
constexpr double kMiddleBound = 175 * kUnit;

// Within these the guard above holds and nothing overflows: no partial sum exceeds 18 P (1 + 2^-48).
constexpr double kLeastProduct = 0x1p-1000;
constexpr double kGreatestProduct = 0x1p1000;

double largest(const Vector& start, const Vector& end) noexcept {
  return std::max({std::fabs(start[0]), std::fabs(start[1]), std::fabs(start[2]), std::fabs(end[0]), std::fabs(end[1]),
                   std::fabs(end[2])});
}

bool within_range(double product) noexcept { return product >= kLeastProduct && product <= kGreatestProduct; }

}  // namespace

std::array<double, 4> coplanarity_coefficients(const Frame& f) noexcept {
  using geometry::cross;
  using geometry::dot;
  const Vector n0 = cross(f.u0, f.w0);
  const Vector n2 = cross(f.u1, f.w1);
  const Vector c01 = cross(f.u0, f.w1);
  const Vector c10 = cross(f.u1, f.w0);
  const Vector n1 = {{c01[0] + c10[0], c01[1] + c10[1], c01[2] + c10[2]}};  // twice the middle coefficient of u x w
  return {dot(n0, f.r0), dot(n1, f.r0) + dot(n0, f.r1), dot(n2, f.r0) + dot(n1, f.r1), dot(n2, f.r1)};
}

CoefficientBounds coplanarity_bounds(const Frame& f) noexcept {
  const double uw = largest(f.u0, f.u1) * largest(f.w0, f.w1);
  const double uwr = uw * largest(f.r0, f.r1);
  if (!within_range(uw) || !within_range(uwr)) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan};
  }
  return {kEndsBound * uwr, kMiddleBound * uwr};
}

bool same_side_all_along(const std::array<double, 4>& b, const CoefficientBounds& bounds) noexcept {
  const auto [ends, middle] = bounds;
  const bool positive = b[0] > ends && b[1] > middle && b[2] > middle && b[3] > ends;
  const bool negative = b[0] < -ends && b[1] < -middle && b[2] < -middle && b[3] < -ends;
  return positive || negative;
}

}  // namespace touchstone::filters
