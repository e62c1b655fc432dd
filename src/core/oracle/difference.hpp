// The differences of two elements' points: q - p for every p of the first element and q of the second. They form a
// convex polygon in space whose corners move on straight lines. The distance of the elements is the polygon's distance
// from the origin, in every metric.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "oracle/motion.hpp"

namespace touchstone::oracle {

/// The difference of a corner of each element. `weights` holds the barycentric coordinates of the first element's
/// corner and then those of the second's, three each.
struct DifferenceCorner {
  Corner position;
  std::array<int, 6> weights;
};

/// A face of the polygon: a corner, a side or the interior. Its points are B + s (X - B) + t (Y - B), where B, X and Y
/// are `corners`. A side has no Y and a corner has no X.
struct DifferenceFace {
  std::vector<std::size_t> corners;  ///< B, then X, then Y

  /// The polygon near a point of the face is the point, plus the face's own directions, plus non-negative multiples of
  /// the directions from B to these corners.
  std::vector<std::size_t> inward;

  std::size_t dimension() const { return corners.size() - 1; }
};

/// The polygon: a parallelogram for two edges; otherwise a triangle, a segment or a point. It may be flat at times: the
/// description is that of the parameters s and t.
struct DifferencePolygon {
  Kind kind;
  std::vector<DifferenceCorner> corners;
  std::vector<DifferenceFace> faces;  ///< the corners, then the sides, then the interior, in the order of their names
};

/// The polygon of a query.
DifferencePolygon difference_polygon(Kind kind, const Corners& corners);

/// The values of unit, s and t that are positive exactly when B + (s / unit) (X - B) + (t / unit) (Y - B) is a point of
/// the face and of no face of lower dimension, for unit > 0.
template <class Number>
std::vector<Number> margins(Kind kind, std::size_t dimension, const Number& unit, const Number& s, const Number& t) {
  if (dimension == 0) return {};
  if (dimension == 1) return {s, Number(unit - s)};
  if (kind == Kind::edge_edge) return {s, Number(unit - s), t, Number(unit - t)};
  return {s, t, Number(unit - s - t)};
}

/// Vector arithmetic for corners and positions.
template <class Number>
std::array<Number, 3> operator-(const std::array<Number, 3>& a, const std::array<Number, 3>& b) {
  return {Number(a[0] - b[0]), Number(a[1] - b[1]), Number(a[2] - b[2])};
}

template <class Number>
std::array<Number, 3> operator+(const std::array<Number, 3>& a, const std::array<Number, 3>& b) {
  return {Number(a[0] + b[0]), Number(a[1] + b[1]), Number(a[2] + b[2])};
}

template <class Number>
std::array<Number, 3> operator*(const Number& factor, const std::array<Number, 3>& a) {
  return {Number(factor * a[0]), Number(factor * a[1]), Number(factor * a[2])};
}

template <class Number>
Number dot(const std::array<Number, 3>& a, const std::array<Number, 3>& b) {
  return Number(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

}  // namespace touchstone::oracle
