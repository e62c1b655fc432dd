// V and the side conditions at a time in double-double arithmetic.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <touchstone/query.hpp>

namespace touchstone::filters {

/// A polynomial's value at a time, rounded from double-double, and its slope in doubles.
template <class N>
struct ValueAndSlopeOf {
  N value;
  N slope;
};
using ValueAndSlope = ValueAndSlopeOf<double>;

/// Along an axis, the components whose signs and quotients tell where the elements meet: see geometry/frame.hpp.
template <class N>
struct ComponentsAt {
  ValueAndSlopeOf<N> normal;  ///< n
  ValueAndSlopeOf<N> first;   ///< f1, geometry::first_numerator
  ValueAndSlopeOf<N> second;  ///< f2, geometry::second_numerator
  ValueAndSlopeOf<N> third;   ///< n - f1 for edges, n - f1 - f2 for a face
  ValueAndSlopeOf<N> fourth;  ///< n - f2 for edges; for a face the same as `third`
};

/// V and these components.
struct ContactValues : ComponentsAt<double> {
  double coplanarity;
};

// Errors of the values, in e^2 = 2^-106, for coordinates of u bounded by U (likewise w, r). They come from the
// operators of double_double.hpp, which round low parts and leave out a product of two low parts. Let s = 1 - t. Below,
// "low parts a ..., b ..." lists the sizes of the rounded low parts in units of e times the bound.
//   Differences of doubles are exact, with low parts of at most e U.
//     s times a difference: low parts s ..., 2 s ...: 3 s e^2 U, low part 2 s e U. t times a difference likewise.
//     The sum of both, at most U: low parts 2 ..., 3 ...: 3 + 2 + 3 = 8 e^2 U. Normalised, the low part is e U.
//   A product of two such coordinates: operands 8 + 8; low parts 1 ..., 1 ..., 2 ..., 3 ..., and 1 left out:
//   24 e^2 U W, low part 3 e U W.
//     The difference of two products, at most 2 U W: low parts 6 ..., 8 ...: 62 e^2 U W, of which 32 are the operands',
//     low part 8 e U W. That is the error of a component of n, f1 or f2.
//     Differences of components, over the sum M of their U W, R W, R U. n - f1: low parts 8 ..., 10 ...: 80 e^2 M.
//     n - f1 - f2: low parts 10 ..., 12 ... more: 102 e^2 M.
//   V is linear in each coordinate, and the factors of a vector's coordinates sum to 4 P (see coplanarity_form.hpp).
//     The coordinates' errors make 3 * 4 * 8 = 96 e^2 P.
//     The cross product's own: 2 * 8 + 6 in each component, and 6 + n_k, in all 3 * 28 + 4 = 88 e^2 P. Normalised, its
//     low part is e n_k.
//     The product n_k r_k: (1 + 1 + 2 + 3 + 1) n_k, in all 32 e^2 P, low part 3 e n_k.
//     Two sums, at most 4 P: low parts 12 ..., 16 ..., 16 ..., 20 ...: 64 e^2 P.
//     In all 96 + 88 + 32 + 64 = 280 e^2 P.
constexpr double kUnitSquared = 0x1p-106;
/// Of V, times P = U W R, before its rounding to a double.
constexpr double kCoplanarityError = 281 * kUnitSquared;
/// Of components and their differences, times M, before rounding.
constexpr double kComponentError = 103 * kUnitSquared;

/// contact_values and coplanarity_value for one sort of processor.
struct ContactValuesFunctions {
  ContactValues (*all)(const Query& query, double t, std::size_t axis);
  double (*coplanarity)(const Query& query, double t);
};

/// The values at t of an edge-edge or vertex-face query; t in [0, 1] or a little beyond, and exact_to_one (see
/// bernstein_cubic.hpp).
ContactValues contact_values(const Query& query, double t, std::size_t axis) noexcept;
/// contact_values(query, t, axis).coplanarity, and no more.
double coplanarity_value(const Query& query, double t) noexcept;

/// The functions that these choose from. Their results are the same bit for bit, except where a product's low part
/// underflows. `fused`: for processors with AVX2 and fused multiply-add, null on others. Not `fused`: for every one.
const ContactValuesFunctions* contact_values_functions(bool fused) noexcept;

}  // namespace touchstone::filters
