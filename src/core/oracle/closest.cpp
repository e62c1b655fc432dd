// Which of several candidates is the answer.
// SPDX-License-Identifier: MIT
#include "oracle/closest.hpp"

#include <algorithm>

namespace touchstone::oracle {
namespace {

using PolynomialWeights = std::array<Polynomial, 6>;

/// `unit` times the weights of a candidate: of the first element's corners and then of the second's.
PolynomialWeights scaled_weights(const DifferencePolygon& polygon, const Candidate& candidate) {
  const auto weight = [&](std::size_t corner, std::size_t i) {
    return Integer(polygon.corners[candidate.face->corners[corner]].weights[i]);
  };
  PolynomialWeights weights;
  for (std::size_t i = 0; i < 6; ++i) {
    weights[i] = candidate.unit * Polynomial(weight(0, i));
    if (candidate.face->dimension() >= 1) weights[i] += candidate.s * Polynomial(weight(1, i) - weight(0, i));
    if (candidate.face->dimension() >= 2) weights[i] += candidate.t * Polynomial(weight(2, i) - weight(0, i));
  }
  return weights;
}

bool is_lexicographically_smaller(const DifferencePolygon& polygon, const Candidate& one, const Candidate& other,
                                  const Moment& at) {
  const PolynomialWeights weights = scaled_weights(polygon, one);
  const PolynomialWeights other_weights = scaled_weights(polygon, other);
  const CGAL::Sign units = at.sign(one.unit) * at.sign(other.unit);
  for (std::size_t i = 0; i < 6; ++i) {
    const CGAL::Sign order = at.sign(weights[i] * other.unit - other_weights[i] * one.unit) * units;
    if (order != CGAL::ZERO) return order < 0;
  }
  return false;
}

/// Whether a face of the polygon is spanned by corners of a zero-length edge, so that fewer corners give its points.
/// @param length_a, length_b whether the edges have a length; true for elements other than edges
bool is_spanned_by_fewer(const DifferencePolygon& polygon, const DifferenceFace& face, bool length_a, bool length_b) {
  return std::any_of(face.corners.begin(), face.corners.end(), [&](std::size_t corner) {
    const auto& weights = polygon.corners[corner].weights;
    return (!length_a && weights[1] != 0) || (!length_b && weights[4] != 0);
  });
}

/// Whether the polygon, a triangle, is flat.
bool is_flat(const DifferencePolygon& polygon, const Moment& at) {
  const Corner& x = polygon.corners[0].position;
  const Corner e = polygon.corners[1].position - x;
  const Corner f = polygon.corners[2].position - x;
  const Polynomial ef = dot(e, f);
  return at.sign(dot(e, e) * dot(f, f) - ef * ef) == CGAL::ZERO;
}

/// Whether a corner or side of a flat triangle that comes before the candidate's face holds the candidate's point. All
/// is on one line, so a point p is on the segment XY exactly when (p - X) . (p - Y) <= 0.
bool is_held_before(const DifferencePolygon& polygon, const Candidate& candidate, const Moment& at) {
  const auto position = [&](std::size_t corner) -> const Corner& { return polygon.corners[corner].position; };
  const Corner& base = position(candidate.face->corners[0]);
  Corner point = candidate.unit * base;
  if (candidate.face->dimension() == 1) {  // no interior point of a flat triangle counts: its unit is zero
    point = point + candidate.s * (position(candidate.face->corners[1]) - base);
  }
  for (const auto& face : polygon.faces) {
    if (&face == candidate.face) return false;
    const Corner& X = position(face.corners.front());
    const Corner& Y = position(face.corners.back());
    if (at.sign(dot(point - candidate.unit * X, point - candidate.unit * Y)) <= 0) return true;
  }
  return false;
}

/// The candidates that count, after the reduction of degenerate elements.
std::vector<const Candidate*> reduced_candidates(const DifferencePolygon& polygon, const Sublevel& sublevel,
                                                 const Moment& at) {
  const auto& corners = polygon.corners;
  bool length_a = true;
  bool length_b = true;
  if (polygon.kind == Kind::edge_edge) {
    length_a = !coincide(at, corners[0].position, corners[1].position);
    length_b = !coincide(at, corners[0].position, corners[2].position);
  }
  if (polygon.kind == Kind::point_edge) length_b = !coincide(at, corners[0].position, corners[1].position);
  const bool flat = polygon.kind == Kind::vertex_face && is_flat(polygon, at);
  std::vector<const Candidate*> reduced;
  for (const auto& candidate : sublevel.candidates) {
    if (is_spanned_by_fewer(polygon, *candidate.face, length_a, length_b)) continue;
    if (!counts(candidate, at)) continue;
    if (flat && is_held_before(polygon, candidate, at)) continue;
    reduced.push_back(&candidate);
  }
  return reduced;
}

/// The feature of an element whose corners with a positive weight are the bits of `support`.
Feature feature_of(Kind kind, bool second, unsigned support) {
  static constexpr std::array<Feature, 4> edge_a = {Feature::none, Feature::a0, Feature::a1, Feature::a};
  static constexpr std::array<Feature, 4> edge_b = {Feature::none, Feature::b0, Feature::b1, Feature::b};
  static constexpr std::array<Feature, 4> edge_e = {Feature::none, Feature::e0, Feature::e1, Feature::e};
  static constexpr std::array<Feature, 8> face = {Feature::none, Feature::f0,  Feature::f1,  Feature::f01,
                                                  Feature::f2,   Feature::f20, Feature::f12, Feature::f};
  switch (kind) {
    case Kind::edge_edge: return second ? edge_b[support] : edge_a[support];
    case Kind::vertex_face: return second ? face[support] : Feature::v;
    case Kind::point_edge: return second ? edge_e[support] : Feature::p;
    case Kind::point_point: return second ? Feature::q : Feature::p;
  }
  return Feature::none;
}

/// One element's feature and weights, from `unit` times the weights of both elements.
FeaturePoint feature_point(const DifferencePolygon& polygon, const Candidate& candidate,
                           const PolynomialWeights& weights, bool second, const Moment& at) {
  const std::size_t offset = second ? 3 : 0;
  unsigned support = 0;
  for (const std::size_t corner : candidate.face->corners) {
    for (unsigned i = 0; i < 3; ++i) {
      if (polygon.corners[corner].weights[offset + i] != 0) support |= 1U << i;
    }
  }
  FeaturePoint point = {feature_of(polygon.kind, second, support), {0, 0, 0}};
  for (unsigned i = 0; i < 3; ++i) {
    if (support == 1U << i)
      point.weights[i] = 1;
    else if ((support & 1U << i) != 0)
      point.weights[i] = at.ratio(weights[offset + i], candidate.unit);
  }
  return point;
}

}  // namespace

ClosestPair closest_pair(const DifferencePolygon& polygon, const Sublevel& sublevel, const Moment& at,
                         bool names_overlap) {
  const auto candidates = reduced_candidates(polygon, sublevel, at);
  const Candidate* first = candidates.at(0);
  const bool flat = polygon.kind == Kind::vertex_face && is_flat(polygon, at);
  for (const Candidate* candidate : candidates) {
    // Of a flat triangle, the first face that holds closest points; the faces lie in memory in their order.
    const bool other_face = flat && candidate->face != first->face;
    if (other_face ? candidate->face < first->face : is_lexicographically_smaller(polygon, *candidate, *first, at)) {
      first = candidate;
    }
  }
  const PolynomialWeights weights = scaled_weights(polygon, *first);
  ClosestPair pair = {feature_point(polygon, *first, weights, false, at),
                      feature_point(polygon, *first, weights, true, at)};
  // Candidates of the Euclidean metric are different points of the parallelogram: one on each face at most.
  if (names_overlap && polygon.kind == Kind::edge_edge && candidates.size() > 1) {
    pair.a.feature = pair.b.feature = Feature::overlap;
  }
  return pair;
}

}  // namespace touchstone::oracle
