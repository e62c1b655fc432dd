// Polynomials of t in doubles, with bounds on their sizes and errors, as curved queries are made of them.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "geometry/vector.hpp"
#include "numbers/doubles/bounded.hpp"

namespace touchstone::filters {

constexpr int kMostCurvedDegree = 12;

/// binomial(n, k).
constexpr std::array<std::array<double, kMostCurvedDegree + 1>, kMostCurvedDegree + 1> binomials() {
  std::array<std::array<double, kMostCurvedDegree + 1>, kMostCurvedDegree + 1> b{};
  for (std::size_t n = 0; n < b.size(); ++n) {
    b[n][0] = 1;
    for (std::size_t k = 1; k <= n; ++k) b[n][k] = b[n - 1][k - 1] + (k < n ? b[n - 1][k] : 0);
  }
  return b;
}
inline constexpr auto kBinomial = binomials();

/// Dim polynomials of one degree n on [0, 1], each the sum of c_k t^k (1 - t)^(n - k): c_k is binomial(n, k) times a
/// coefficient in the Bernstein basis. With these, products of polynomials are convolutions.
///
/// Each |c_k| is at most binomial(n, k) size, and the true one is within kBoundSlack binomial(n, k) error of it: this
/// is so for sums and products, too, as the binomial coefficients of the factors add up to those of the product
/// (Vandermonde). The values on [0, 1] have the same bounds, as binomial(n, k) t^k (1 - t)^(n - k) add up to 1.
template <std::size_t Dim>
struct CurvedForm {
  int degree = 0;
  double size = 0;
  double error = 0;
  std::array<std::array<double, kMostCurvedDegree + 1>, Dim> c;

  /// Sets the size to the least one that the coefficients have.
  void measure() noexcept {
    size = 0;
    const auto& b = kBinomial[static_cast<std::size_t>(degree)];
    for (const auto& each : c) {
      for (std::size_t k = 0; k <= static_cast<std::size_t>(degree); ++k)
        size = std::max(size, std::fabs(each[k]) / b[k]);
    }
  }
};
using ScalarForm = CurvedForm<1>;
using VectorForm = CurvedForm<3>;

/// Products and sums with their bounds; of sums the degree is the greater one. `sign` is 1 or -1: a + sign b.
template <std::size_t Dim>
CurvedForm<Dim> operator*(const ScalarForm& a, const CurvedForm<Dim>& b) noexcept;
template <std::size_t Dim>
CurvedForm<Dim> sum(CurvedForm<Dim> a, CurvedForm<Dim> b, double sign) noexcept;
/// The same polynomials, of a higher degree.
template <std::size_t Dim>
CurvedForm<Dim> elevated(CurvedForm<Dim> form, int degree) noexcept;

/// The polynomial that is x everywhere, exact.
ScalarForm constant(double x) noexcept;

/// a . b, a x b, and the component of a x b along an axis.
ScalarForm dot(const VectorForm& a, const VectorForm& b) noexcept;
VectorForm cross(const VectorForm& a, const VectorForm& b) noexcept;
ScalarForm cross_component(const VectorForm& a, const VectorForm& b, std::size_t axis) noexcept;

/// The derivatives of p.
template <std::size_t Dim>
CurvedForm<Dim> derivative_of(const CurvedForm<Dim>& p) noexcept;

/// A bound on the absolute slopes of the polynomials that the coefficients have as computed.
template <std::size_t Dim>
double slope_of(const CurvedForm<Dim>& p) noexcept;

/// The values at all times within `radius` of t, which lie in [0, 1]. `slope` is slope_of(p), and of no matter for the
/// radius 0.
numbers::Bounded value_at(const ScalarForm& p, double t, double radius = 0, double slope = 0) noexcept;
geometry::Vector<numbers::Bounded> value_at(const VectorForm& p, double t, double radius, double slope) noexcept;

}  // namespace touchstone::filters
