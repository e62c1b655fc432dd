// A third opinion: whether two elements at rest touch, from the definition "their closed convex hulls share a
// point". It solves small linear systems over GMP's rationals, and includes nothing of the library's sources.
// SPDX-License-Identifier: MIT
#pragma once

#include <gmpxx.h>

#include <array>
#include <vector>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>

namespace touchstone::tests {

using RationalPoint = std::array<mpq_class, 3>;
using RationalCorners = std::array<RationalPoint, 4>;

/// The exact corners of a query at a rational time.
RationalCorners corners_at(const Query& query, const mpq_class& time);

struct StaticContact {
  bool touching = false;
  Feature feature_a = Feature::none;  ///< named as `Answer` names them
  Feature feature_b = Feature::none;
  std::array<mpq_class, 3> weights_a{};
  std::array<mpq_class, 3> weights_b{};
};

/// How the elements touch when their corners are these.
StaticContact contact_at(Kind kind, const RationalCorners& corners);

/// Whether the elements of the query touch at `time`.
bool touching_at(const Query& query, const mpq_class& time);

/// The coefficients of V(t) = ((x1 - x0) x (y1 - y0)) . r, constant first, of an edge-edge or vertex-face query;
/// empty when V is identically zero or the kind has none.
std::vector<mpq_class> coplanarity_cubic(const Query& query);

/// How often `time` is a root of the polynomial, which is not identically zero.
int root_multiplicity(std::vector<mpq_class> polynomial, const mpq_class& time);

}  // namespace touchstone::tests
