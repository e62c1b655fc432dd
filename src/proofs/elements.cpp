// SPDX-License-Identifier: MIT
#include "proofs/elements.hpp"

#include "exact/corners.hpp"

namespace touchstone::proofs {
namespace {

template <class Q>
Elements elements_of_any(const Q& query, const Separation& separation) {
  Elements elements;
  elements.kind = query.kind;
  elements.count = corner_count(query.kind);
  elements.first = query.kind == Kind::edge_edge ? 2 : 1;
  const exact::ScaledCorners scaled = exact::scaled_corners(query);
  for (std::size_t i = 0; i < elements.count; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      elements.corners[i][k] = {scaled.corners[i][k][0], scaled.corners[i][k][1]};
    }
  }
  elements.separation = Exact(separation.distance) * scaled.factor;
  elements.metric = separation.metric;
  return elements;
}

}  // namespace

Elements Elements::at(const Exact& time) const {
  Elements still = *this;
  for (DenseVector& corner : still.corners) {
    for (Dense& coordinate : corner.c) coordinate = {value(coordinate, time)};
  }
  return still;
}

Elements elements_of(const Query& query, const Separation& separation) { return elements_of_any(query, separation); }
Elements elements_of(const RationalQuery& query, const Separation& separation) {
  return elements_of_any(query, separation);
}

CornersAndEdges corners_and_edges(Kind kind) {
  switch (kind) {
    case Kind::edge_edge: return {{{{0, 2, 3}, {1, 2, 3}, {2, 0, 1}, {3, 0, 1}}}, 4};
    case Kind::vertex_face: return {{{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}}, 3};
    case Kind::point_edge: return {{{{0, 1, 2}}}, 1};
    case Kind::point_point: break;
  }
  return {};
}

}  // namespace touchstone::proofs
