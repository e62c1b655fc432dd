// The moving corners of a query, and the polynomials that proofs are made of.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <touchstone/curved_query.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

#include "geometry/frame.hpp"
#include "proofs/dense.hpp"

namespace touchstone::proofs {

/// The corners of a query and its separation, all multiplied by one positive number. Corner i is at corners[i] /
/// weights[i], and this weight is positive over [0, 1]: 1 for straight motion and for curves, |q|^2 for a body.
struct Elements {
  Kind kind = Kind::edge_edge;
  std::size_t count = 0;        ///< the number of corners
  std::size_t first_count = 0;  ///< the number of corners of the first element, which come first
  std::array<DenseVector, 4> corners;
  std::array<Dense, 4> weights;
  std::array<int, 4> motions{};  ///< corners with the same one have the same weight
  Exact separation;              ///< zero without one
  Metric metric = Metric::euclidean;

  bool is_edge_edge() const { return kind == Kind::edge_edge; }
  bool has_normal() const { return count == 4; }
  bool has_separation() const { return !numbers::is_zero(separation); }
  bool has_max_separation() const { return has_separation() && metric == Metric::max; }
  bool have_one_weight(std::size_t i, std::size_t j) const { return motions[i] == motions[j]; }

  /// Corner i minus corner j, times scale(i, j), which is positive: X_i - X_j for corners that have one weight, and W_j
  /// X_i - W_i X_j for others.
  DenseVector difference(std::size_t i, std::size_t j) const;

  /// p scale(i, j) / W_i, where scale(i, j) is W_i or W_i W_j.
  Dense completed(const Dense& p, std::size_t i, std::size_t j) const {
    return have_one_weight(i, j) ? p : scaled_by(weights[j], p);
  }
  Dense scale(std::size_t i, std::size_t j) const { return completed(weights[i], i, j); }

  /// The separation times scale(i, j).
  Dense bound(std::size_t i, std::size_t j) const { return separation * scale(i, j); }

  geometry::Frame<DenseVector> frame() const {
    return geometry::frame_of(kind, [this](std::size_t i, std::size_t j) { return difference(i, j); });
  }

  /// The elements as they are at one time, standing still.
  Elements at(const Exact& time) const;

  /// Calls f(i, j) for each corner i of the first element and each corner j of the second one.
  template <class F>
  void for_each_pair(F&& f) const {
    for (std::size_t i = 0; i < first_count; ++i) {
      for (std::size_t j = first_count; j < count; ++j) f(i, j);
    }
  }
};

Elements elements_of(const Query& query, const Separation& separation);
Elements elements_of(const RationalQuery& query, const Separation& separation);
Elements elements_of(const CurvedQuery& query, const Separation& separation);

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
