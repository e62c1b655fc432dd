// What lies wholly inside closed surfaces at rest.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <touchstone/mesh.hpp>

#include "mesh/moving_vertices.hpp"

namespace touchstone::mesh {

/// Adds an intersection of sort `inside` for each closed surface that is inside another one.
///
/// A surface is a piece of faces (Pieces). It is closed if its faces pass each of their edges as often in one direction
/// as in the other. So its winding number about a point beside it is a whole number. A surface that none of `all` says
/// to meet B has one winding number about all of B, but for vertices and edges that both have: without them, B is still
/// connected, if it does not branch. Let `sum` be the sum of these numbers over the closed surfaces with
/// which the rules let B collide. If the outermost surface around B has its normals inwards, it may be a room, which is
/// a cavity of all space: then one is added for solids. B is inside if its normals are outwards and there is material
/// around it, or if they are inwards and `sum` is negative. So a solid in a solid counts, in a room too, and a body in
/// a body whose normals are all inwards; a cavity in a solid does not, and neither does a solid in a cavity or in a
/// room.
/// @param all  the other intersections of the mesh
void add_inside(const Mesh::Impl& mesh, const Motion& motion, int threads, const std::atomic<bool>* stop,
                std::vector<Intersection>& all);

}  // namespace touchstone::mesh

namespace touchstone {

/// A piece of a mesh that is wholly inside a closed surface, which is no intersection.
struct EnclosedPart {
  MeshElement element = MeshElement::face;  ///< what it consists of: faces, wires (edges in no face) or a loose point
  MeshIndex vertex = 0;                     ///< one of its vertices: the least one that is in no other piece
  std::vector<MeshIndex> faces;             ///< the least one of each closed surface around it, in ascending order
};

/// Which closed surfaces count as enclosed parts.
enum class ClosedParts : std::uint8_t {
  /// Those that `intersections` does not say to be inside: one of both is not oriented, or they are as a cavity and its
  /// solid, or as a thing and its room.
  unasked,
  all  ///< all that are inside a surface, also those that `intersections` finds
};

/// What is inside closed surfaces, and what nobody can tell to be inside or outside.
struct Insides {
  /// The loose points, wires and open surfaces that are wholly inside closed surfaces which they do not meet, and
  /// closed surfaces as ClosedParts says, in ascending order of their vertices. Whether that is right, as for cloth in
  /// a drum, no geometry tells. A surface also counts as closed if each of its edges is in an even number of its faces;
  /// its winding number is then 0 or 1. A part whose winding numbers add up to 0 is not enclosed, as in a cavity of a
  /// solid, unless the outermost surface may be a room.
  std::vector<EnclosedPart> enclosed;

  std::size_t branching = 0;  ///< surfaces with an edge of three faces or more: which one is around which is not known
  std::size_t in_open = 0;    ///< parts in the box around an open surface, which has no inside; those that branch aside
};

/// @param found  the intersections of the mesh at x
/// @throws InvalidQuery  as `intersections`
Insides insides(const Mesh& mesh, const Positions& x, const MeshOptions& options,
                const std::vector<Intersection>& found, ClosedParts closed);

}  // namespace touchstone
