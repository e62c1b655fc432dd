// Distances of two elements that stand still, for doubles and rationals. The formulas are not those of the oracle:
// feet of corners on segments, common perpendiculars by cross products, and separating axes.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace touchstone::tests::plain {

template <class N>
using Point = std::array<N, 3>;

/// The corners of a convex element: one, two or three.
template <class N>
using Element = std::vector<Point<N>>;

template <class N>
Point<N> minus(const Point<N>& a, const Point<N>& b) {
  return {N(a[0] - b[0]), N(a[1] - b[1]), N(a[2] - b[2])};
}

template <class N>
N dot(const Point<N>& a, const Point<N>& b) {
  return N(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

template <class N>
Point<N> cross(const Point<N>& a, const Point<N>& b) {
  return {N(a[1] * b[2] - a[2] * b[1]), N(a[2] * b[0] - a[0] * b[2]), N(a[0] * b[1] - a[1] * b[0])};
}

template <class N>
N squared_distance_to_segment(const Point<N>& p, const Point<N>& x, const Point<N>& y) {
  const Point<N> e = minus(y, x);
  const N square = dot(e, e);
  N s = N(0);
  if (square > N(0)) s = std::clamp(N(dot(minus(p, x), e) / square), N(0), N(1));
  const Point<N> foot = {N(x[0] + s * e[0]), N(x[1] + s * e[1]), N(x[2] + s * e[2])};
  const Point<N> gap = minus(p, foot);
  return dot(gap, gap);
}

/// The squared Euclidean distance of two edges, or of a point and an element.
template <class N>
N squared_distance(const Element<N>& a, const Element<N>& b) {
  const Point<N> between = minus(b[0], a[0]);
  N least = dot(between, between);
  const auto offer_corners = [&](const Element<N>& corners, const Element<N>& other) {
    for (const auto& corner : corners) {
      for (std::size_t i = 0; i < other.size(); ++i) {
        least = std::min(least, squared_distance_to_segment(corner, other[i], other[(i + 1) % other.size()]));
      }
    }
  };
  offer_corners(a, b);
  offer_corners(b, a);
  if (a.size() * b.size() < 3 || b.size() == 1 || (a.size() == 1 && b.size() == 2)) return least;
  const bool edges = a.size() == 2;
  const Point<N> u = edges ? minus(a[1], a[0]) : minus(b[1], b[0]);
  const Point<N> w = edges ? minus(b[1], b[0]) : minus(b[2], b[0]);
  const Point<N> r = edges ? between : minus(a[0], b[0]);
  const Point<N> n = cross(u, w);
  const N area = dot(n, n);
  if (!(area > N(0))) return least;
  const N s = dot(cross(r, w), n) / area;
  const N t = edges ? N(dot(cross(r, u), n) / area) : N(dot(cross(u, r), n) / area);
  const bool inside = s >= N(0) && t >= N(0) && (edges ? s <= N(1) && t <= N(1) : N(s + t) <= N(1));
  if (!inside) return least;
  const N along = dot(n, r);
  return std::min(least, N(along * along / area));
}

/// The distance in the largest-axis metric. It is the largest gap along a direction n with |n_x| + |n_y| + |n_z| = 1.
/// The candidates are those of the separating axis theorem for a cube and the polygon of differences.
template <class N>
N max_distance(const Element<N>& a, const Element<N>& b) {
  std::vector<Point<N>> differences;
  for (const auto& p : a) {
    for (const auto& q : b) differences.push_back(minus(q, p));
  }
  std::vector<Point<N>> edges;
  for (const Element<N>* element : {&a, &b}) {
    for (std::size_t i = 0; i < element->size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) edges.push_back(minus((*element)[i], (*element)[j]));
    }
  }
  const std::array<Point<N>, 3> axes = {{{N(1), N(0), N(0)}, {N(0), N(1), N(0)}, {N(0), N(0), N(1)}}};
  std::vector<Point<N>> directions(axes.begin(), axes.end());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (const auto& axis : axes) directions.push_back(cross(edges[i], axis));
    for (std::size_t j = 0; j < i; ++j) directions.push_back(cross(edges[i], edges[j]));
  }
  const auto absolute = [](const N& x) { return x < N(0) ? N(-x) : x; };
  N largest = N(0);
  for (const auto& n : directions) {
    const N length = absolute(n[0]) + absolute(n[1]) + absolute(n[2]);
    if (!(length > N(0))) continue;
    N low = dot(n, differences[0]);
    N high = low;
    for (const auto& x : differences) {
      low = std::min(low, dot(n, x));
      high = std::max(high, dot(n, x));
    }
    largest = std::max({largest, N(low / length), N(-high / length)});
  }
  return largest;
}

}  // namespace touchstone::tests::plain
