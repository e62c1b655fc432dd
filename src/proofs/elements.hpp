// The moving corners of a query, and the polynomials that proofs are made of. SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <variant>

#include <touchstone/query.hpp>

#include "proofs/dense.hpp"

namespace touchstone::proofs {

/// The corners of a query, all multiplied by one positive number.
struct Elements {
  Kind kind = Kind::edge_edge;
  std::size_t count = 0;  ///< the number of corners
  std::size_t first = 0;  ///< the number of corners of the first element, which come first
  std::array<DenseVector, 4> corners;

  bool is_edge_edge() const { return kind == Kind::edge_edge; }
  bool has_normal() const { return count == 4; }
  DenseVector u() const;  ///< a1 - a0, or f1 - f0
  DenseVector w() const;  ///< b1 - b0, or f2 - f0
  DenseVector r() const;  ///< b0 - a0, or v - f0
};

Elements elements_of(const Query& query);
Elements elements_of(const RationalQuery& query);

/// The pairs of a corner and an edge of the other element, by the numbers of their corners.
struct CornerAndEdge {
  std::size_t corner, start, end;
};
struct CornersAndEdges {
  std::array<CornerAndEdge, 4> pairs;
  std::size_t count = 0;
  const CornerAndEdge* begin() const { return pairs.data(); }
  const CornerAndEdge* end() const { return pairs.data() + count; }
};
CornersAndEdges corners_and_edges(Kind kind);

}  // namespace touchstone::proofs
