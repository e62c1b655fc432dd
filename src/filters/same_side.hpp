// The coplanarity cubic in Bernstein form over the step, with a bound on its rounding error.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "geometry/vector.hpp"

namespace touchstone::filters {

using Vector = geometry::Vector<double>;

/// The three difference vectors of which V is the determinant, at both ends of the step; each coordinate is one
/// rounded subtraction of two of the query's doubles.
struct Frame {
  Vector u0, w0, r0;
  Vector u1, w1, r1;
};

/// The Bernstein coefficients b0, 3 b1, 3 b2, b3 of V = (u x w) . r over [0, 1], computed in doubles.
std::array<double, 4> coplanarity_coefficients(const Frame& frame) noexcept;

/// Bounds on the absolute errors of these coefficients: `ends` for b0 and b3, `middle` for 3 b1 and 3 b2. NaN when
/// a product may underflow or overflow; comparisons with it are false, which is "uncertain".
struct CoefficientBounds {
  double ends;
  double middle;
};
CoefficientBounds coplanarity_bounds(const Frame& frame) noexcept;

/// True proves that V has no root in [0, 1]: all four coefficients have one certain sign, and V lies in their hull.
bool same_side_all_along(const std::array<double, 4>& coefficients, const CoefficientBounds& bounds) noexcept;

}  // namespace touchstone::filters
