// The parallelogram of two edges, and the translated element of a point and another element.
// SPDX-License-Identifier: MIT
#include "oracle/difference.hpp"

namespace touchstone::oracle {
namespace {

DifferenceCorner difference_corner(const Corner& first, std::size_t first_index, const Corner& second,
                                   std::size_t second_index) {
  DifferenceCorner corner = {second - first, {}};
  corner.weights[first_index] = 1;
  corner.weights[3 + second_index] = 1;
  return corner;
}

DifferencePolygon parallelogram(const Corners& c) {
  DifferencePolygon polygon = {Kind::edge_edge, {}, {}};
  for (const std::size_t b : {0U, 1U}) {
    for (const std::size_t a : {0U, 1U}) polygon.corners.push_back(difference_corner(c[a], a, c[2 + b], b));
  }
  // In the order of the corners: a0 b0, a1 b0, a0 b1, a1 b1.
  polygon.faces = {{{0}, {1, 2}},  {{1}, {0, 3}}, {{2}, {3, 0}}, {{3}, {2, 1}},  //
                   {{0, 1}, {2}},  {{2, 3}, {0}}, {{0, 2}, {1}}, {{1, 3}, {0}},  //
                   {{0, 1, 2}, {}}};
  return polygon;
}

DifferencePolygon translated_simplex(Kind kind, const Corners& c) {
  DifferencePolygon polygon = {kind, {}, {}};
  for (std::size_t i = 1; i < corner_count(kind); ++i)
    polygon.corners.push_back(difference_corner(c[0], 0, c[i], i - 1));
  switch (kind) {
    case Kind::edge_edge: break;
    case Kind::vertex_face:
      polygon.faces = {{{0}, {1, 2}},  {{1}, {2, 0}}, {{2}, {0, 1}},  //
                       {{0, 1}, {2}},  {{1, 2}, {0}}, {{2, 0}, {1}},  //
                       {{0, 1, 2}, {}}};
      break;
    case Kind::point_edge: polygon.faces = {{{0}, {1}}, {{1}, {0}}, {{0, 1}, {}}}; break;
    case Kind::point_point: polygon.faces = {{{0}, {}}}; break;
  }
  return polygon;
}

}  // namespace

DifferencePolygon difference_polygon(Kind kind, const Corners& corners) {
  return kind == Kind::edge_edge ? parallelogram(corners) : translated_simplex(kind, corners);
}

}  // namespace touchstone::oracle
