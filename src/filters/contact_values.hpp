// V and the side conditions at a time in double-double arithmetic. SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <touchstone/query.hpp>

namespace touchstone::filters {

/// A polynomial's value at a time, rounded from double-double, and its slope in doubles.
struct ValueAndSlope {
  double value;
  double slope;
};

/// V and, along an axis, the components whose signs and quotients tell where the elements meet.
/// Edge-edge: f1 = (r x w), f2 = (r x u). Vertex-face: f1 = (r x w), f2 = (u x r).
struct ContactValues {
  double coplanarity;
  ValueAndSlope normal;   ///< n
  ValueAndSlope first;    ///< f1
  ValueAndSlope second;   ///< f2
  ValueAndSlope third;    ///< n - f1 for edges, n - f1 - f2 for a face
  ValueAndSlope fourth;   ///< n - f2 for edges; for a face the same as `third`
};

// Errors of the values, in e^2 = 2^-106, for coordinates of u bounded by U (likewise w, r), from the
// operators of double_double.hpp. Differences of doubles are exact, with low parts of at most e U.
//   end - start: low parts of 2 and 4 e U are rounded, 6 e^2 U. t times it: + 10, 16 e^2 U, low part 6 e U. start + that:
//   low parts of 7 and 10 e U are rounded, 33 e^2 U, low part 10 e U.
//   A product of two such coordinates: operands 2 * 33, low parts of 10, 10, 20 and 21 e U W rounded, low times low 100
//   left out: 227 e^2 U W, low part 21 e U W. The difference of two: + 42 + 44 e^2, 540 e^2 U W, low part 44 e U W.
//   n_k r_k: operands 540 + 66, low parts of 20, 44, 64 and 66 e P rounded, low times low 440 left out: 1240 e^2 P, low
//   part 66 e P. The sum of three: + 132 + 136 + 202 + 208 e^2 P in low parts: 4400 e^2 P.
constexpr double kUnitSquared = 0x1p-106;
constexpr double kCoplanarityError = 4500 * kUnitSquared;  ///< of V, times P = U W R, before its rounding to a double
constexpr double kComponentError = 540 * kUnitSquared;     ///< of n, f1, f2, times U W, R W, R U, before rounding

/// The values at t, 0 <= t <= 1, of an edge-edge query (`edges`) or a vertex-face query with these corners.
ContactValues contact_values(const Vec3* start, const Vec3* end, bool edges, double t, std::size_t axis) noexcept;

/// The code that it chooses from, with the same result bit for bit (but where a product's low part underflows): `fused` for
/// processors with AVX2 and fused multiply-add, null where there is none; the other for every processor.
using ContactValuesFunction = ContactValues (*)(const Vec3* start, const Vec3* end, bool edges, double t, std::size_t axis);
ContactValuesFunction contact_values_function(bool fused) noexcept;

}  // namespace touchstone::filters
