// Cuts of a piece of the step in two, and projections of what is in it on directions, with bounds on their errors.
// Coefficients are those of polynomials in the Bernstein basis over the piece.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "filters/separation/facet.hpp"
#include "numbers/doubles/bounded.hpp"

namespace touchstone::filters {

/// The coefficients over both sides of a time in (0, 1), by de Casteljau's algorithm. `right` is all of it at first.
template <std::size_t Size>
void cut_at(std::array<double, Size>& left, std::array<double, Size>& right, int degree, double fraction) noexcept {
  const std::size_t size = static_cast<std::size_t>(degree) + 1;
  for (std::size_t round = 0; round < size; ++round) {
    left[round] = right[0];
    for (std::size_t i = 0; i + round + 1 < size; ++i) right[i] = (1 - fraction) * right[i] + fraction * right[i + 1];
  }
}

/// What a cut adds to the errors of coefficients up to a size, with e = 2^-53. In each of n rounds a coefficient has a
/// rounding of its products, of their sum and of 1 - fraction: 3 e times the size. The errors before are averaged.
constexpr double kCutRoundings = 3;
inline double cut_error(int degree, double size) noexcept {
  return size * (kCutRoundings * degree * numbers::kRounding) + numbers::kUnderflow;
}
/// The same where 1 - fraction is exact.
constexpr double kExactCutRoundings = 2;
inline double exact_cut_error(int degree, double size) noexcept {
  return size * (kExactCutRoundings * degree * numbers::kRounding) + numbers::kUnderflow;
}

/// n . x for coefficient k.
template <std::size_t Size>
double projection(const Vector& n, const std::array<std::array<double, Size>, 3>& x, std::size_t k) noexcept {
  return n[0] * x[0][k] + n[1] * x[1][k] + n[2] * x[2][k];
}

/// The bound on its error, for a direction whose largest coordinate is 1 and for points up to a size and off by
/// `error` = x: 3 products, with at most 3 roundings each. It is 3 x + 9 e size and second-order terms.
constexpr double kProjectionErrors = 3;
constexpr double kProjectionRoundings = 10;
inline double projection_error(double error, double size) noexcept {
  return kProjectionErrors * error + kProjectionRoundings * numbers::kRounding * size + numbers::kUnderflow;
}

/// The bound for k times a projection plus n - k times another one, n the degree: of products of a projection, at most
/// 3 size, and a whole number, and of the sum of two. These are 2 roundings more.
constexpr double kTurningRoundings = kProjectionRoundings + 7;
inline double turning_error(double degree, double error, double size) noexcept {
  return degree * (kProjectionErrors * error + kTurningRoundings * numbers::kRounding * size) + numbers::kUnderflow;
}

}  // namespace touchstone::filters
