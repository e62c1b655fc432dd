// Flat geometry at one moment: projections along an axis, in which orientation tests tell where everything is.
// SPDX-License-Identifier: MIT
#include "oracle/touch.hpp"

#include <array>
#include <vector>

#include "oracle/equations.hpp"

namespace touchstone::oracle {
namespace {

constexpr EdgeNames kEdgeA = {Feature::a0, Feature::a1, Feature::a};
constexpr EdgeNames kEdgeB = {Feature::b0, Feature::b1, Feature::b};

/// Edges that are parallel or have no length: they share points only if one's end is on the other.
std::optional<Touch> touch_parallel_edges(const Corner& A, const Corner& B, const Corner& C, const Corner& D,
                                          const Moment& at) {
  std::vector<const Corner*> shared;
  for (const Corner* end : {&A, &B}) {
    if (is_on_segment(at, *end, C, D)) shared.push_back(end);
  }
  for (const Corner* end : {&C, &D}) {
    if (is_on_segment(at, *end, A, B)) shared.push_back(end);
  }
  if (shared.empty()) return std::nullopt;

  // The shared part is the hull of these ends. Its point farthest towards B has the smallest weight of A, and as both
  // edges then have a length that point decides all weights.
  const Corner* farthest = shared.front();
  bool has_length = false;
  for (const Corner* end : shared) {
    if (!coincide(at, *end, *shared.front())) has_length = true;
    if (relative_direction(at, A, B, *farthest, *end) > 0) farthest = end;
  }
  Touch where = {point_on_edge(at, *farthest, A, B, kEdgeA), point_on_edge(at, *farthest, C, D, kEdgeB)};
  if (has_length) where.a.feature = where.b.feature = Feature::overlap;
  return where;
}

/// The feature of an edge that meets the line of another edge, not parallel to it, given the orientations of the edge's
/// ends with respect to that line; nothing when both ends are strictly on the same side.
std::optional<Feature> feature_on_line(const Moment& at, const Polynomial& start, const Polynomial& end,
                                       const EdgeNames& names) {
  const CGAL::Sign start_side = at.sign(start);
  if (start_side == CGAL::ZERO) return names.start;
  const CGAL::Sign end_side = at.sign(end);
  if (end_side == CGAL::ZERO) return names.end;
  if (start_side == end_side) return std::nullopt;
  return names.interior;
}

FeaturePoint point_on_line(const Moment& at, Feature feature, const Polynomial& start, const Polynomial& end,
                           const EdgeNames& names) {
  if (feature == names.start) return {feature, {1, 0, 0}};
  if (feature == names.end) return {feature, {0, 1, 0}};
  const double along = at.ratio(start, start - end);
  return {feature, {1 - along, along, 0}};
}

std::optional<Touch> touch_edges(const Corners& c, const Moment& at) {
  const auto& [A, B, C, D] = c;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Polynomial abc = orientation(axis, A, B, C);
    const Polynomial abd = orientation(axis, A, B, D);
    // abd - abc is the cross product of the two edges seen along the axis. Where it is not zero the edges span their
    // plane and the projection is one to one on it.
    if (at.sign(abd - abc) == CGAL::ZERO) continue;
    const auto feature_b = feature_on_line(at, abc, abd, kEdgeB);
    if (!feature_b) return std::nullopt;
    const Polynomial cda = orientation(axis, C, D, A);
    const Polynomial cdb = orientation(axis, C, D, B);
    const auto feature_a = feature_on_line(at, cda, cdb, kEdgeA);
    if (!feature_a) return std::nullopt;
    return Touch{point_on_line(at, *feature_a, cda, cdb, kEdgeA), point_on_line(at, *feature_b, abc, abd, kEdgeB)};
  }
  return touch_parallel_edges(A, B, C, D, at);
}

/// The point is on the triangle's plane and the triangle has an area, seen along `axis` too: the point is inside when
/// each of the triangles that it makes with two corners is oriented like the whole, or flat. Their areas are weights.
std::optional<FeaturePoint> point_on_face(const Corners& c, std::size_t axis, const Polynomial& area,
                                          const Moment& at) {
  const auto& [P, F0, F1, F2] = c;
  const std::array<Polynomial, 3> weights = {orientation(axis, P, F1, F2), orientation(axis, F0, P, F2),
                                             orientation(axis, F0, F1, P)};
  const CGAL::Sign whole = at.sign(area);
  unsigned pattern = 0;  // bit i is set when the weight of corner i is positive
  for (unsigned i = 0; i < 3; ++i) {
    const CGAL::Sign side = at.sign(weights[i]) * whole;
    if (side < 0) return std::nullopt;
    if (side > 0) pattern |= 1U << i;
  }
  static constexpr std::array<Feature, 8> names = {Feature::none, Feature::f0,  Feature::f1,  Feature::f01,
                                                   Feature::f2,   Feature::f20, Feature::f12, Feature::f};
  FeaturePoint touched = {names[pattern], {0, 0, 0}};
  for (unsigned i = 0; i < 3; ++i) {
    if (pattern == 1U << i)
      touched.weights[i] = 1;
    else if (pattern & 1U << i)
      touched.weights[i] = at.ratio(weights[i], area);
  }
  return touched;
}

/// A flat triangle is its three edges.
std::optional<FeaturePoint> point_on_flat_face(const Corners& c, const Moment& at) {
  struct Side {
    std::size_t from;
    std::size_t to;
    EdgeNames names;
  };
  static constexpr std::array<Side, 3> sides = {{{0, 1, {Feature::f0, Feature::f1, Feature::f01}},
                                                 {1, 2, {Feature::f1, Feature::f2, Feature::f12}},
                                                 {2, 0, {Feature::f2, Feature::f0, Feature::f20}}}};
  const Corner& P = c[0];
  static constexpr std::array<Feature, 3> corners = {Feature::f0, Feature::f1, Feature::f2};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!coincide(at, P, c[1 + i])) continue;
    FeaturePoint touched = {corners[i], {0, 0, 0}};
    touched.weights[i] = 1;
    return touched;
  }
  for (const Side& side : sides) {
    const Corner& X = c[1 + side.from];
    const Corner& Y = c[1 + side.to];
    if (!is_on_segment(at, P, X, Y)) continue;
    const FeaturePoint on_side = point_on_edge(at, P, X, Y, side.names);
    FeaturePoint touched = {on_side.feature, {0, 0, 0}};
    touched.weights[side.from] = on_side.weights[0];
    touched.weights[side.to] = on_side.weights[1];
    return touched;
  }
  return std::nullopt;
}

std::optional<Touch> touch_face(const Corners& c, const Moment& at) {
  const FeaturePoint vertex = {Feature::v, {1, 0, 0}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Polynomial area = orientation(axis, c[1], c[2], c[3]);
    if (at.sign(area) == CGAL::ZERO) continue;
    const auto touched = point_on_face(c, axis, area, at);
    return touched ? std::optional<Touch>({vertex, *touched}) : std::nullopt;
  }
  const auto touched = point_on_flat_face(c, at);
  return touched ? std::optional<Touch>({vertex, *touched}) : std::nullopt;
}

}  // namespace

std::optional<Touch> touch(Kind kind, const Corners& c, const Moment& at) {
  const FeaturePoint point = {Feature::p, {1, 0, 0}};
  switch (kind) {
    case Kind::edge_edge: return touch_edges(c, at);
    case Kind::vertex_face: return touch_face(c, at);
    case Kind::point_edge:
      if (!is_on_segment(at, c[0], c[1], c[2])) return std::nullopt;
      return Touch{point, point_on_edge(at, c[0], c[1], c[2], {Feature::e0, Feature::e1, Feature::e})};
    case Kind::point_point:
      if (!coincide(at, c[0], c[1])) return std::nullopt;
      return Touch{point, {Feature::q, {1, 0, 0}}};
  }
  return std::nullopt;
}

}  // namespace touchstone::oracle
