// What a mesh holds.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <touchstone/mesh.hpp>

#include "geometry/kind_traits.hpp"

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

/// The elements that another one, a *representative*, stands for where boxes are compared.
struct StandsFor {
  static constexpr MeshIndex kNone = std::numeric_limits<MeshIndex>::max();
  std::array<MeshIndex, 3> edges{kNone, kNone, kNone};  ///< edge i leads from its corner i to the next one
  std::uint8_t vertices = 0;                            ///< bit i: its corner i
};

struct Mesh::Impl {
  std::size_t vertex_count = 0;
  int dimension = 3;
  std::vector<std::array<MeshIndex, 3>> faces;
  std::vector<std::array<MeshIndex, 2>> edges;
  std::vector<MeshIndex> points;      // in ascending order, as the next two
  std::vector<MeshIndex> vertices;    // those in an edge, and the loose points
  std::vector<MeshIndex> wires;       // the edges that are in no face; empty in two dimensions, where no one asks
  std::vector<std::uint64_t> joined;  // the corners of each wire, as a pair of the rules

  /// The representatives: first the faces, then the edges that are in no face, then the loose points. Each stands for
  /// itself, and for those of its edges and vertices that are in none before it. So two elements are near each other
  /// only where their representatives are (Curtis, Tamstorf, Manocha: Fast collision detection for deformable models
  /// using representative-triangles, 2008).
  std::vector<StandsFor> stands_for;

  Separation separation;
  std::vector<double> radii;
  std::vector<PairSeparation> pair_separations;  // by pair, in ascending order

  // The rules; pairs as one number, the lesser one in its upper half, in ascending order.
  std::vector<std::uint64_t> vertex_pairs;
  std::vector<MeshPair> element_pairs;
  std::vector<MeshIndex> groups;
  GroupRule group_rule = GroupRule::all_but_listed;
  std::vector<std::uint64_t> group_pairs;
  bool has_rules() const noexcept { return !(vertex_pairs.empty() && element_pairs.empty() && groups.empty()); }
};

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone

namespace touchstone::mesh {

using Index = MeshIndex;

/// A face, an edge that is in no face, or in the plane any edge, or a loose point.
struct Representative {
  MeshElement sort;
  Index number;  ///< of the face, edge or vertex
  std::array<Index, 3> corners;
  constexpr std::size_t count() const noexcept { return static_cast<std::size_t>(sort) + 1; }  ///< of its corners
};

inline std::size_t representative_count(const Mesh::Impl& mesh) noexcept {
  return mesh.faces.size() + (mesh.dimension == 3 ? mesh.wires.size() : mesh.edges.size()) + mesh.points.size();
}

/// The n-th representative.
inline Representative representative(const Mesh::Impl& mesh, Index n) noexcept {
  if (n < mesh.faces.size()) return {MeshElement::face, n, mesh.faces[n]};
  n -= static_cast<Index>(mesh.faces.size());
  const bool in_space = mesh.dimension == 3;
  const auto edges = static_cast<Index>(in_space ? mesh.wires.size() : mesh.edges.size());
  if (n < edges) {
    const Index number = in_space ? mesh.wires[n] : n;
    const auto& edge = mesh.edges[number];
    return {MeshElement::edge, number, {edge[0], edge[1], edge[1]}};
  }
  const Index point = mesh.points[n - edges];
  return {MeshElement::vertex, point, {point, point, point}};
}

inline std::uint64_t unordered(Index a, Index b) noexcept {
  return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

inline bool is_in(const std::vector<Index>& sorted, Index number) noexcept {
  return std::binary_search(sorted.begin(), sorted.end(), number);
}

template <class Corners>
bool contains(const Corners& corners, Index vertex) noexcept {
  return std::find(corners.begin(), corners.end(), vertex) != corners.end();
}

template <class A, class B>
bool share_vertex(const A& a, const B& b) noexcept {
  return std::any_of(a.begin(), a.end(), [&](Index vertex) { return contains(b, vertex); });
}

/// Whether the rules let two vertices collide.
inline bool vertices_may_collide(const Mesh::Impl& mesh, Index a, Index b) noexcept {
  if (!mesh.groups.empty()) {
    const bool listed =
        std::binary_search(mesh.group_pairs.begin(), mesh.group_pairs.end(), unordered(mesh.groups[a], mesh.groups[b]));
    if (listed != (mesh.group_rule == GroupRule::only_listed)) return false;
  }
  return !std::binary_search(mesh.vertex_pairs.begin(), mesh.vertex_pairs.end(), unordered(a, b));
}

/// Whether the rules let two elements collide, but for the list of elements.
template <class A, class B>
bool corners_may_collide(const Mesh::Impl& mesh, const A& a, const B& b) noexcept {
  for (const Index i : a) {
    for (const Index j : b) {
      if (vertices_may_collide(mesh, i, j)) return true;
    }
  }
  return false;
}

/// Whether a wire leads from the vertex to a corner of an edge, and the vertex is none of these.
inline bool is_beside(const Mesh::Impl& mesh, Index vertex, const std::array<Index, 2>& edge) noexcept {
  if (contains(edge, vertex)) return false;
  const auto are_joined = [&](Index end) {
    return std::binary_search(mesh.joined.begin(), mesh.joined.end(), unordered(vertex, end));
  };
  return are_joined(edge[0]) || are_joined(edge[1]);
}

/// `pair` with its lesser number first where both elements are of one sort.
inline MeshPair in_order(MeshPair pair) noexcept {
  const auto& [first, second] = geometry::traits_of(pair.kind);
  if (first.sort == second.sort && pair.second < pair.first) std::swap(pair.first, pair.second);
  return pair;
}

inline bool is_excluded(const Mesh::Impl& mesh, const MeshPair& pair) noexcept {
  return std::binary_search(mesh.element_pairs.begin(), mesh.element_pairs.end(), in_order(pair));
}

/// Whether no rule excludes two elements of a pair, with these corners, that share no vertex.
template <class A, class B>
bool rules_allow(const Mesh::Impl& mesh, const MeshPair& pair, const A& a, const B& b) noexcept {
  return !mesh.has_rules() || (corners_may_collide(mesh, a, b) && !is_excluded(mesh, pair));
}

/// The vertices of a pair whose elements exist, in the order of a query's corners.
inline std::array<Index, 4> corners_of(const Mesh::Impl& mesh, const MeshPair& pair) noexcept {
  return geometry::pair_corners(pair.kind, pair.first, pair.second, mesh.edges, mesh.faces);
}

/// Whether they share no vertex, and no rule excludes them, for a pair whose elements exist.
inline bool rules_allow(const Mesh::Impl& mesh, const MeshPair& pair) noexcept {
  const auto corners = corners_of(mesh, pair);
  const std::span all(corners.data(), corner_count(pair.kind));
  const std::size_t of_first = geometry::corners_of_first(pair.kind);
  const auto first = all.first(of_first), second = all.subspan(of_first);
  return !share_vertex(first, second) && rules_allow(mesh, pair, first, second);
}

}  // namespace touchstone::mesh
