// The closest points of two features of a query, over any number type.
//
// The oracle does not use this file.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "geometry/frame.hpp"
#include "geometry/kind_traits.hpp"
#include "geometry/vector.hpp"

namespace touchstone::geometry {

/// A feature's corners: one, two or, for a face, three. An overlap counts as the whole edge.
struct FeatureCorners {
  std::array<std::size_t, 3> corners;
  std::size_t count;
};

/// @param first  the number of the element's first corner
inline FeatureCorners corners_of(Feature feature, const Element& element, std::size_t first) noexcept {
  constexpr std::size_t kWholeEdge = 3;
  const auto found = std::find(element.features.begin(), element.features.end(), feature) - element.features.begin();
  const std::size_t set = feature == Feature::overlap ? kWholeEdge : static_cast<std::size_t>(found);
  FeatureCorners found_corners{};
  for (std::size_t i = 0; i < element.corners(); ++i) {
    if ((set >> i & 1) != 0) found_corners.corners[found_corners.count++] = first + i;
  }
  return found_corners;
}

/// Of both elements of a query.
inline std::array<FeatureCorners, 2> corners_of(Kind kind, Feature a, Feature b) noexcept {
  const auto& [first, second] = traits_of(kind);
  return {corners_of(a, first, 0), corners_of(b, second, first.corners())};
}

/// r less its component along e, times |e|^2.
template <class N>
Vector<N> across(const Vector<N>& e, const Vector<N>& r) {
  return dot(e, e) * r - dot(r, e) * e;
}

/// Of each element the square of its length, or of twice its area; of a point `one`. Where it is 0, the closest point
/// of the element has several sets of weights.
/// @param difference  corner i minus corner j
template <class N, class Difference>
std::array<N, 2> squared_sizes(Kind kind, const N& one, const Difference& difference) {
  std::array<N, 2> sizes = {one, one};
  std::size_t first = 0;
  for (std::size_t e = 0; e < 2; ++e) {
    const std::size_t count = (e == 0 ? traits_of(kind).first : traits_of(kind).second).corners();
    if (count > 1) {
      const Vector<N> side = difference(first + 1, first);
      const Vector<N> measure = count == 2 ? side : cross(side, difference(first + 2, first));
      sizes[e] = dot(measure, measure);
    }
    first += count;
  }
  return sizes;
}

/// The closest points of two features, at the times when they have some: a direction between them, and the weight of
/// each corner in its point times one positive number, negated on the first element.
template <class N>
struct Closest {
  Vector<N> direction;
  std::array<N, 4> weights{};
};

/// @param difference  corner i minus corner j
template <class N, class Difference>
Closest<N> closest_points(Kind kind, Feature feature_a, Feature feature_b, const N& one, const Difference& difference) {
  const auto [a, b] = corners_of(kind, feature_a, feature_b);
  const auto& i = a.corners;
  const auto& j = b.corners;
  Closest<N> closest;
  auto& weights = closest.weights;
  if (a.count == 1 && b.count == 1) {
    closest.direction = difference(j[0], i[0]);
    weights[i[0]] = -one;
    weights[j[0]] = one;
  } else if (a.count + b.count == 3) {  // a corner and an edge
    const auto [corner, start, end] = a.count == 1 ? std::array{i[0], j[0], j[1]} : std::array{j[0], i[0], i[1]};
    const Vector<N> e = difference(end, start), r = difference(corner, start);
    closest.direction = across(e, r);
    const N all = dot(e, e), along = dot(r, e);
    weights[corner] = all;
    weights[end] = -along;
    weights[start] = along - all;
  } else {
    const auto frame = frame_of(kind, difference);
    const Vector<N> n = normal(frame);
    closest.direction = n;
    const bool edges = kind == Kind::edge_edge;
    const N all = dot(n, n), first = dot(n, cross(frame.r, frame.w));
    const N second = dot(n, edges ? cross(frame.r, frame.u) : cross(frame.u, frame.r));
    weights = edges ? std::array{first - all, -first, all - second, second}
                    : std::array{-all, all - first - second, first, second};
  }
  return closest;
}

}  // namespace touchstone::geometry
