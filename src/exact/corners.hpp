// From a query to moving corners in exact numbers. SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include <touchstone/query.hpp>

#include "exact/elements.hpp"

namespace touchstone::exact {

/// The corners of a query, all multiplied by one positive number (which changes no touching time, nature, feature or
/// weight), chosen so that the largest coordinate is of ordinary size.
std::array<Point, 4> moving_corners(const Query& query);
std::array<Point, 4> moving_corners(const RationalQuery& query);

/// Calls f with the elements of the query's kind.
template <class Q, class F>
auto with_elements(const Q& query, F&& f) {
  const std::array<Point, 4> corners = moving_corners(query);
  switch (query.kind) {
    case Kind::edge_edge: return f(EdgeEdgeElements(corners));
    case Kind::vertex_face: return f(VertexFaceElements(corners));
    case Kind::point_edge: return f(PointEdgeElements(corners));
    case Kind::point_point: break;
  }
  return f(PointPointElements(corners));
}

}  // namespace touchstone::exact
