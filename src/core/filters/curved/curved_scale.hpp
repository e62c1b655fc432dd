// What brings the lengths and the orientations of a curved query to ordinary sizes, exactly.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <touchstone/curved_query.hpp>

namespace touchstone::filters {

/// A point or an orientation, times 2^exponent without any rounding.
struct Scale {
  double factor = 1, inverse = 1;
  bool exact = true;

  explicit Scale(double largest) noexcept {
    constexpr double kLeast = 0x1p-20, kMost = 0x1p20, kExtreme = 0x1p900;
    if (largest == 0 || (largest >= kLeast && largest <= kMost)) return;
    if (!(largest >= 1 / kExtreme && largest <= kExtreme)) {
      exact = false;
      return;
    }
    int exponent = 0;
    std::frexp(largest, &exponent);
    factor = std::ldexp(1.0, -exponent);
    inverse = std::ldexp(1.0, exponent);
  }
  double operator()(double x) noexcept {
    const double y = factor * x;
    exact = exact && y * inverse == x;
    return y;
  }
};

/// Lengths are multiplied by `lengths`.
inline std::array<double, 3> point(const Vec3& x, Scale& lengths) noexcept {
  return {lengths(x.x), lengths(x.y), lengths(x.z)};
}

/// An upper bound on all lengths of a query.
double longest(const CurvedQuery& query) noexcept;

/// The greatest absolute component of the orientations of a motion.
double largest_component(const RigidMotion& motion) noexcept;

}  // namespace touchstone::filters
