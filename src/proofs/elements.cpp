// SPDX-License-Identifier: MIT
#include "proofs/elements.hpp"

#include "exact/corners.hpp"

namespace touchstone::proofs {
namespace {

template <class Q>
Elements elements_of_any(const Q& query) {
  Elements elements;
  elements.kind = query.kind;
  elements.count = corner_count(query.kind);
  elements.first = query.kind == Kind::edge_edge ? 2 : 1;
  const auto corners = exact::moving_corners<Exact>(query);
  for (std::size_t i = 0; i < elements.count; ++i) {
    for (std::size_t k = 0; k < 3; ++k) elements.corners[i][k] = {corners[i][k][0], corners[i][k][1]};
  }
  return elements;
}

}  // namespace

DenseVector Elements::u() const { return is_edge_edge() ? corners[1] - corners[0] : corners[2] - corners[1]; }
DenseVector Elements::w() const { return is_edge_edge() ? corners[3] - corners[2] : corners[3] - corners[1]; }
DenseVector Elements::r() const { return is_edge_edge() ? corners[2] - corners[0] : corners[0] - corners[1]; }

Elements elements_of(const Query& query) { return elements_of_any(query); }
Elements elements_of(const RationalQuery& query) { return elements_of_any(query); }

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
