// Steps of whole meshes as simulators make them, small and hard: for `fuzz-steps` and the tests.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <vector>

#include <touchstone/mesh.hpp>

namespace touchstone::families {

/// A mesh that can still be changed, and the positions of its vertices at both ends of a step.
struct StepScene {
  MeshElements elements;  ///< all edges are given, in the order of their numbers
  std::vector<Vec3> x0, x1;

  Mesh mesh() const { return Mesh(elements); }
};

enum class StepFamily : std::uint8_t {
  steps_sheets,      ///< two sheets, one of which falls onto the other; they may start close together
  steps_fold,        ///< a sheet that folds onto itself
  steps_stack,       ///< boxes on one another that sink by little
  steps_beads,       ///< loose points with a separation that rush through each other
  steps_rods,        ///< chains of edges that cross, and loose points beside them
  steps_shells,      ///< two closed surfaces that slide along each other, with a separation
  steps_far,         ///< those of another family far from the origin
  steps_one_vertex,  ///< one vertex moves, and all others rest
  steps_mixed,       ///< triangles of sizes that differ by many orders of magnitude
  steps_float32,     ///< those of another family, rounded to float32
  steps_lattice,     ///< random elements whose coordinates are small integers, and all meet in corners and borders
  steps_groups,      ///< those of steps_lattice, in two groups of vertices of which one does not meet itself
  steps_plane,       ///< edges and loose points in the plane z = 0 of a mesh in space
  steps_grazing      ///< those of another family, shortened to where the first contact is at the end, or just beyond
};

/// The names of the families, each at the place of its value.
const std::vector<std::string_view>& step_families();

/// The scene of a family. Equal seeds and indices make equal scenes. They have at most 64 vertices.
StepScene step_scene(StepFamily family, std::uint64_t seed, std::uint64_t index);

/// All pairs of a mesh in space that are asked about, from the words of Mesh::may_collide, in ascending order.
/// @param may_count  a pair for which it is false is left out before the mesh is asked
template <class MayCount>
std::vector<MeshPair> every_pair(const Mesh& mesh, const MayCount& may_count) {
  const auto vertices = static_cast<MeshIndex>(mesh.vertex_count());
  const auto edges = static_cast<MeshIndex>(mesh.edges().size()), faces = static_cast<MeshIndex>(mesh.faces().size());
  std::vector<MeshPair> pairs;
  const auto add = [&](Kind kind, MeshIndex first, MeshIndex second, bool ascending) {
    for (MeshIndex i = 0; i < first; ++i) {
      for (MeshIndex j = ascending ? i + 1 : 0; j < second; ++j) {
        const MeshPair pair{kind, i, j};
        if (may_count(pair) && mesh.may_collide(pair)) pairs.push_back(pair);
      }
    }
  };
  add(Kind::edge_edge, edges, edges, true);
  add(Kind::vertex_face, vertices, faces, false);
  add(Kind::point_edge, vertices, edges, false);
  add(Kind::point_point, vertices, vertices, true);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace touchstone::families
