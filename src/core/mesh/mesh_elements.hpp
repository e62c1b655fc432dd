// What a mesh holds.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <touchstone/mesh.hpp>

namespace touchstone::inline TOUCHSTONE_ABI {

struct Mesh::Impl {
  std::size_t vertex_count = 0;
  int dimension = 3;
  std::vector<std::array<MeshIndex, 3>> faces;
  std::vector<std::array<MeshIndex, 2>> edges;
  std::vector<MeshIndex> points;      // in ascending order, as the next two
  std::vector<MeshIndex> vertices;    // those in an edge, and the loose points
  std::vector<MeshIndex> wires;       // the edges that are in no face; empty in two dimensions, where no one asks
  std::vector<MeshIndex> wire_ends;   // the vertices from which a wire leads to another wire
  std::vector<std::uint64_t> joined;  // the corners of each wire, as a pair of the rules

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

}  // namespace touchstone::inline TOUCHSTONE_ABI

namespace touchstone::mesh {

using Index = MeshIndex;

inline std::uint64_t unordered(Index a, Index b) noexcept {
  return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

inline bool is_in(const std::vector<Index>& sorted, Index number) noexcept {
  return std::binary_search(sorted.begin(), sorted.end(), number);
}

template <std::size_t N>
bool contains(const std::array<Index, N>& corners, Index vertex) noexcept {
  return std::find(corners.begin(), corners.end(), vertex) != corners.end();
}

template <std::size_t N, std::size_t M>
bool share_vertex(const std::array<Index, N>& a, const std::array<Index, M>& b) noexcept {
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
template <std::size_t N, std::size_t M>
bool corners_may_collide(const Mesh::Impl& mesh, const std::array<Index, N>& a,
                         const std::array<Index, M>& b) noexcept {
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
  const bool one_sort = pair.kind == Kind::edge_edge || pair.kind == Kind::point_point;
  if (one_sort && pair.second < pair.first) std::swap(pair.first, pair.second);
  return pair;
}

inline bool is_excluded(const Mesh::Impl& mesh, const MeshPair& pair) noexcept {
  return std::binary_search(mesh.element_pairs.begin(), mesh.element_pairs.end(), in_order(pair));
}

/// Whether two elements of a pair, with these corners, share no vertex, and no rule excludes them.
template <std::size_t N, std::size_t M>
bool rules_allow(const Mesh::Impl& mesh, const MeshPair& pair, const std::array<Index, N>& a,
                 const std::array<Index, M>& b) noexcept {
  if (share_vertex(a, b)) return false;
  return !mesh.has_rules() || (corners_may_collide(mesh, a, b) && !is_excluded(mesh, pair));
}

/// The same for a pair whose elements exist.
inline bool rules_allow(const Mesh::Impl& mesh, const MeshPair& pair) noexcept {
  switch (pair.kind) {
    case Kind::edge_edge: return rules_allow(mesh, pair, mesh.edges[pair.first], mesh.edges[pair.second]);
    case Kind::vertex_face: return rules_allow(mesh, pair, std::array{pair.first}, mesh.faces[pair.second]);
    case Kind::point_edge: return rules_allow(mesh, pair, std::array{pair.first}, mesh.edges[pair.second]);
    case Kind::point_point: return rules_allow(mesh, pair, std::array{pair.first}, std::array{pair.second});
  }
  return false;
}

/// The vertices of a pair whose elements exist, in the order of a query's corners.
inline std::array<Index, 4> corners_of(const Mesh::Impl& mesh, const MeshPair& pair) noexcept {
  switch (pair.kind) {
    case Kind::edge_edge: {
      const auto &a = mesh.edges[pair.first], &b = mesh.edges[pair.second];
      return {a[0], a[1], b[0], b[1]};
    }
    case Kind::vertex_face: {
      const auto& f = mesh.faces[pair.second];
      return {pair.first, f[0], f[1], f[2]};
    }
    case Kind::point_edge: return {pair.first, mesh.edges[pair.second][0], mesh.edges[pair.second][1], 0};
    case Kind::point_point: return {pair.first, pair.second, 0, 0};
  }
  return {};
}

/// How many of a query's corners belong to the first element.
constexpr std::size_t first_corners(Kind kind) noexcept { return kind == Kind::edge_edge ? 2 : 1; }

}  // namespace touchstone::mesh
