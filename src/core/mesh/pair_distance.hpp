// The separation of a pair of elements, and the room around an element that its pairs need.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "geometry/kind_traits.hpp"
#include "mesh/mesh_elements.hpp"
#include "numbers/doubles/rounded_sum.hpp"

namespace touchstone::mesh {

/// The separation of a pair that is listed, or null.
inline const PairSeparation* listed_separation(const Mesh::Impl& mesh, const MeshPair& pair) noexcept {
  const MeshPair ordered = in_order(pair);
  const auto found = std::lower_bound(mesh.pair_separations.begin(), mesh.pair_separations.end(), ordered,
                                      [](const PairSeparation& one, const MeshPair& two) { return one.pair < two; });
  return found != mesh.pair_separations.end() && found->pair == ordered ? &*found : nullptr;
}

/// The separation of the pair, which has these corners.
inline double separation_of(const Mesh::Impl& mesh, const MeshPair& pair,
                            const std::array<Index, 4>& corners) noexcept {
  if (!mesh.pair_separations.empty()) {
    if (const PairSeparation* listed = listed_separation(mesh, pair)) return listed->distance;
  }
  // A vertex of a wire and a wire beside it are as near as their common neighbour lets them: only a fold counts.
  if (pair.kind == Kind::point_edge && mesh.dimension == 3 && !is_in(mesh.points, pair.first)) return 0;
  if (mesh.radii.empty()) return mesh.separation.distance;
  double first = 0, second = 0;
  for (std::size_t c = 0; c < corner_count(pair.kind); ++c) {
    double& radius = c < geometry::corners_of_first(pair.kind) ? first : second;
    radius = std::max(radius, mesh.radii[corners[c]]);
  }
  return numbers::sum_rounded_up(first, second);
}

/// The greatest fraction of a distance at the start for which that distance may be a bound of doubles (distance_bound),
/// and for which candidates are kept from step to step.
constexpr double kMostBounded = 0.9;

/// More than `length` by a relative 2^-45 or the least double, unless it is 0. So the sum of two such numbers exceeds
/// the sum of the lengths even if that is rounded up, and a few rounding errors in each are covered.
inline double with_room(double length) noexcept {
  if (length == 0) return 0;
  return std::nextafter(length * (1 + 0x1p-45), std::numeric_limits<double>::infinity());
}

}  // namespace touchstone::mesh
