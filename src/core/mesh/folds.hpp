// Elements that share a vertex at rest: whether they may have another common point.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "mesh/mesh_elements.hpp"
#include "mesh/moving_vertices.hpp"

namespace touchstone::mesh {

inline bool same_position(const Vec3& a, const Vec3& b) noexcept { return a.x == b.x && a.y == b.y && a.z == b.z; }

/// True proves that the segment from `shared` to `end` has no point in the convex hull of `shared` and the points
/// others[0 .. count), but `shared`. 1 <= count <= 2. False says nothing.
bool certainly_unfolded(const Vec3& shared, const Vec3& end, const std::array<Vec3, 2>& others,
                        std::size_t count) noexcept;

/// Whether two elements with a common vertex may fold onto each other. Both ends of an edge of a face are in the face,
/// which is no fold. A vertex and an element have nothing else in common.
template <std::size_t N, std::size_t M>
bool may_fold(const Mesh::Impl& mesh, const Motion& motion, const std::array<Index, N>& a,
              const std::array<Index, M>& b) noexcept {
  if constexpr (N != 2 || M < 2) {
    return false;
  } else {
    const bool first = contains(b, a[0]), second = contains(b, a[1]);
    if (first && second) return false;
    const Index shared = a[first ? 0 : 1], end = a[first ? 1 : 0];
    std::array<Vec3, 2> others;
    std::size_t count = 0;
    bool allowed = !mesh.has_rules();
    for (const Index vertex : b) {
      if (vertex == shared) continue;
      others[count++] = motion[vertex].start;
      allowed = allowed || vertices_may_collide(mesh, end, vertex);
    }
    return allowed && !certainly_unfolded(motion[shared].start, motion[end].start, others, count);
  }
}

/// Whether two elements at rest have to be asked about: they share no vertex, or may fold onto each other, and the
/// rules let them collide.
template <std::size_t N, std::size_t M>
bool may_intersect(const Mesh::Impl& mesh, const Motion& motion, const std::array<Index, N>& a,
                   const std::array<Index, M>& b) noexcept {
  if (share_vertex(a, b)) return may_fold(mesh, motion, a, b);
  return !mesh.has_rules() || corners_may_collide(mesh, a, b);
}

}  // namespace touchstone::mesh
