// The moving corners of a query, and the polynomials that proofs are made of. SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

#include "geometry/frame.hpp"
#include "proofs/dense.hpp"

namespace touchstone::proofs {

/// The corners of a query and its separation, all multiplied by one positive number.
struct Elements {
  Kind kind = Kind::edge_edge;
  std::size_t count = 0;  ///< the number of corners
  std::size_t first = 0;  ///< the number of corners of the first element, which come first
  std::array<DenseVector, 4> corners;
  Exact separation;  ///< zero without one
  Metric metric = Metric::euclidean;

  bool is_edge_edge() const { return kind == Kind::edge_edge; }
  bool has_normal() const { return count == 4; }
  bool has_separation() const { return !numbers::is_zero(separation); }
  bool has_max_separation() const { return has_separation() && metric == Metric::max; }
  DenseVector difference(std::size_t i, std::size_t j) const { return corners[i] - corners[j]; }
  geometry::Frame<DenseVector> frame() const {
    return geometry::frame_of(is_edge_edge(), [this](std::size_t i, std::size_t j) { return difference(i, j); });
  }

  /// The elements as they are at one time, standing still.
  Elements at(const Exact& time) const;

  /// Calls f(i, j) for each corner i of the first element and each corner j of the second one.
  template <class F>
  void for_each_pair(F&& f) const {
    for (std::size_t i = 0; i < first; ++i) {
      for (std::size_t j = first; j < count; ++j) f(i, j);
    }
  }
};

Elements elements_of(const Query& query, const Separation& separation);
Elements elements_of(const RationalQuery& query, const Separation& separation);

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
