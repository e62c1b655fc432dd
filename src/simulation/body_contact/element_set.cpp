// SPDX-License-Identifier: MIT
#include "body_contact/element_set.hpp"

#include <algorithm>
#include <utility>

namespace touchstone::sim {

std::vector<Edge> all_edges(const std::vector<Edge>& edges, const std::vector<Face>& faces) {
  std::vector<Edge> all;
  all.reserve(edges.size() + 3 * faces.size());
  const auto add = [&](Index a, Index b) { all.push_back({std::min(a, b), std::max(a, b)}); };
  for (const Edge& edge : edges) add(edge[0], edge[1]);
  for (const Face& face : faces) {
    for (std::size_t k = 0; k < 3; ++k) add(face[k], face[(k + 1) % 3]);
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

ElementSet::ElementSet(std::size_t vertex_count, std::vector<Index> of_vertices, std::vector<Edge> of_edges,
                       std::vector<Face> of_faces)
    : vertices(std::move(of_vertices)), edges(std::move(of_edges)), faces(std::move(of_faces)) {
  opposite.assign(edges.size(), {kNoCorner, kNoCorner});
  around.resize(vertex_count);
  for (const Edge& edge : edges) {
    around[edge[0]].push_back(edge[1]);
    around[edge[1]].push_back(edge[0]);
  }
  for (const Face& face : faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Edge edge{std::min(face[k], face[(k + 1) % 3]), std::max(face[k], face[(k + 1) % 3])};
      const auto found = std::lower_bound(edges.begin(), edges.end(), edge);
      if (found == edges.end() || *found != edge) continue;
      auto& corners = opposite[static_cast<std::size_t>(found - edges.begin())];
      (corners[0] == kNoCorner ? corners[0] : corners[1]) = face[(k + 2) % 3];
    }
  }
  for (const auto& corners : opposite) bare.push_back(corners[0] == kNoCorner ? 1 : 0);
  for (const Index vertex : vertices) {
    if (around[vertex].empty()) points.push_back(vertex);
  }
}

}  // namespace touchstone::sim
