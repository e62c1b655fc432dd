// SPDX-License-Identifier: MIT
#include "sim/enclosed.hpp"

#include <algorithm>

#include "mesh/ray_passes.hpp"

namespace touchstone::sim {

bool is_closed(const std::vector<std::array<MeshIndex, 3>>& faces) {
  std::vector<std::array<MeshIndex, 2>> edges;
  edges.reserve(3 * faces.size());
  for (const auto& face : faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      edges.push_back({std::min(face[k], face[(k + 1) % 3]), std::max(face[k], face[(k + 1) % 3])});
    }
  }
  std::sort(edges.begin(), edges.end());
  for (auto edge = edges.begin(); edge != edges.end();) {
    const auto next = std::upper_bound(edge, edges.end(), *edge);
    if ((next - edge) % 2 != 0) return false;
    edge = next;
  }
  return !faces.empty();
}

bool is_enclosed(const std::vector<std::array<MeshIndex, 3>>& faces, const Vec3* corners, const Vec3& point) {
  mesh::RayPasses ray(point);
  for (const auto& face : faces) ray.add(corners[face[0]], corners[face[1]], corners[face[2]]);
  return ray.passes() % 2 != 0;
}

}  // namespace touchstone::sim
