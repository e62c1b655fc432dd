// Vertices, edges and faces that belong together, and which of them are neighbours.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "scene/scene.hpp"

namespace touchstone::sim {

/// Of one body, or of all particles.
struct ElementSet {
  std::vector<Index> vertices;  ///< those that collide
  std::vector<Index> points;    ///< of these, those in no edge
  std::vector<Edge> edges;
  std::vector<Face> faces;
  std::vector<std::array<Index, 2>> opposite;  ///< of each edge: the third corners of its first two faces, or kNoCorner
  std::vector<std::vector<Index>> around;      ///< of each vertex: the other ends of its edges
  std::vector<char> bare;                      ///< of each edge: it has no face

  static constexpr Index kNoCorner = ~Index{0};

  ElementSet() = default;
  /// @param edges  sorted, each with its smaller number first
  ElementSet(std::size_t vertex_count, std::vector<Index> vertices, std::vector<Edge> edges, std::vector<Face> faces);
};

/// The edges of a wire frame and of faces: sorted, each once, its smaller number first.
std::vector<Edge> all_edges(const std::vector<Edge>& edges, const std::vector<Face>& faces);

}  // namespace touchstone::sim
