// The corners of any query as exact polynomials in t.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <touchstone/query.hpp>

#include "io/queries/query_parser.hpp"
#include "proofs/dense.hpp"

namespace touchstone::view {

using numbers::Exact;
using proofs::Dense;
using proofs::DenseVector;
using ExactVector = geometry::Vector<Exact>;

/// Corner i is at numerators[i](t) / denominator(t). The denominator is positive on [0, 1].
struct MovingCorners {
  Kind kind = Kind::edge_edge;
  std::size_t count = 0;        ///< the number of corners
  std::size_t first_count = 0;  ///< the number of corners of the first element, which come first
  std::array<DenseVector, 4> numerators;
  Dense denominator;

  /// The numerators at a time.
  std::array<ExactVector, 4> at(const Exact& t) const;

  /// V(t) times the third power of the denominator; empty for kinds without V, and for V identically zero.
  Dense coplanarity() const;

  /// Whether no corner ever leaves the plane z = 0.
  bool is_planar() const;
};

MovingCorners moving_corners_of(const io::FileQuery& query);

/// p(t + shift), exactly.
Dense shifted(Dense p, const Exact& shift);
DenseVector shifted(const DenseVector& p, const Exact& shift);

/// p without its leading zeros.
Dense trimmed(Dense p);

/// A number near numerator / denominator, which lies in [-1, 1], within 2^-240.
Exact long_quotient(const Exact& numerator, const Exact& denominator);

/// Halves [low, high], in which p changes its sign once, until it is shorter than 2^-260 times its upper end, or until
/// a root is found. @returns a point of it
Exact narrowed_root(const Dense& p, Exact low, Exact high);

}  // namespace touchstone::view
