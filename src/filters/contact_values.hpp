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
  ValueAndSlope normal;  ///< n
  ValueAndSlope first;   ///< f1
  ValueAndSlope second;  ///< f2
  ValueAndSlope third;   ///< n - f1 for edges, n - f1 - f2 for a face
  ValueAndSlope fourth;  ///< n - f2 for edges; for a face the same as `third`
};

// Errors of the values, in e^2 = 2^-106, for coordinates of u bounded by U (likewise w, r), from the operators of
// double_double.hpp: they round low parts, and leave out a product of two. Let s = 1 - t and write ... for what is rounded.
//   Differences of doubles are exact, with low parts of at most e U. s times one: low parts s ..., 2 s ...: 3 s e^2 U, low part
//   2 s e U; t times one likewise. Their sum, at most U: low parts 2 ..., 3 ...: 3 + 2 + 3 = 8 e^2 U. Normalised, the low part is
//   e U.
//   A product of two such coordinates: operands 8 + 8; 1 ..., 1 ..., 2 ..., 3 ..., and 1 left out: 24 e^2 U W, low part
//   3 e U W. The difference of two, at most 2 U W: low parts 6 ..., 8 ...: 62 e^2 U W, of which 32 are the operands', low part
//   8 e U W. So for a component of n, f1 or f2. Differences of components, over the sum M of their U W, R W, R U: low
//   parts 8 ..., 10 ..., for n - f1: 80 e^2 M; then 10 ..., 12 ... for n - f1 - f2: 102 e^2 M.
//   V: it is linear in each coordinate, and the factors of a vector's sum to 4 P (see coplanarity_form.hpp): their errors make
//   3 * 4 * 8 = 96 e^2 P. The cross product's own: 2 * 8 + 6 in each component, and 6 + n_k, in all 3 * 28 + 4 = 88 e^2 P.
//   Normalised, its low part is e n_k. The product n_k r_k: (1 + 1 + 2 + 3 + 1) n_k, in all 32 e^2 P, low part 3 e n_k. Two
//   sums, at most 4 P: low parts 12 ..., 16 ..., 16 ..., 20 ...: 64. In all 96 + 88 + 32 + 64 = 280 e^2 P.
constexpr double kUnitSquared = 0x1p-106;
constexpr double kCoplanarityError = 281 * kUnitSquared;  ///< of V, times P = U W R, before its rounding to a double
constexpr double kComponentError =
    103 * kUnitSquared;  ///< of components and their differences, times M, before rounding

/// The values at t of an edge-edge query (`edges`) or a vertex-face query with these corners; t in [0, 1] or a little beyond,
/// and exact_to_one (see bernstein_cubic.hpp).
ContactValues contact_values(const Vec3* start, const Vec3* end, bool edges, double t, std::size_t axis) noexcept;

/// The code that it chooses from, with the same result bit for bit (but where a product's low part underflows): `fused` for
/// processors with AVX2 and fused multiply-add, null where there is none; the other for every processor.
using ContactValuesFunction = ContactValues (*)(const Vec3* start, const Vec3* end, bool edges, double t,
                                                std::size_t axis);
ContactValuesFunction contact_values_function(bool fused) noexcept;

}  // namespace touchstone::filters
