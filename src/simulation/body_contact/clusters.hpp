// Groups of a body's elements that lie near each other, so that most of them need no box of their own.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "body_contact/element_set.hpp"

namespace touchstone::sim {

/// The elements [begin, end) of a body lie within `radius` of a centre, in the body's frame.
struct Cluster {
  Vector3 centre = Vector3::Zero();
  double radius = 0;  ///< m, rounded up
  Index begin = 0, end = 0;
};

/// Clusters of elements that follow each other: those of a wire, of a strip of faces or of a row of vertices.
/// @param elements  each a list of the numbers of its corners
template <class Element>
std::vector<Cluster> clusters_of(const std::vector<Vector3>& points, const std::vector<Element>& elements) {
  constexpr Index kMost = 8;  // elements: a box for each of them costs about as much as four boxes of clusters
  constexpr double kRounded = 1 + 0x1p-40;
  std::vector<Cluster> clusters;
  const auto count = static_cast<Index>(elements.size());
  for (Index first = 0; first < count; first += kMost) {
    Cluster& cluster = clusters.emplace_back();
    cluster.begin = first;
    cluster.end = std::min(first + kMost, count);
    Vector3 low = points[elements[first][0]], high = low;
    const auto for_each_corner = [&](const auto& visit) {
      for (Index i = cluster.begin; i < cluster.end; ++i) {
        for (const Index corner : elements[i]) visit(points[corner]);
      }
    };
    for_each_corner([&](const Vector3& x) {
      low = low.cwiseMin(x);
      high = high.cwiseMax(x);
    });
    cluster.centre = 0.5 * low + 0.5 * high;
    for_each_corner([&](const Vector3& x) { cluster.radius = std::max(cluster.radius, (x - cluster.centre).norm()); });
    cluster.radius *= kRounded;
  }
  return clusters;
}

}  // namespace touchstone::sim
