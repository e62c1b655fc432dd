// Closed surfaces that lie wholly inside others at rest.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <vector>

#include <touchstone/mesh.hpp>

#include "mesh/motion.hpp"

namespace touchstone::mesh {

/// Adds an intersection of sort `inside` for each closed surface that is inside another one.
///
/// A surface is the set of faces that are connected by common vertices. It is closed if its faces pass each of their
/// edges as often in one direction as in the other. So its winding number about a point beside it is a whole number. A
/// surface that none of `all` says to meet B has one winding number about all of B. Let `sum` be the sum of these numbers
/// over the closed surfaces with which the rules let B collide. If the outermost surface around B has its normals inwards,
/// it may be a room, which is a cavity of all space: then one is added for solids. B is inside if its normals are outwards
/// and there is material around it, or if they are inwards and `sum` is negative. So a solid in a solid counts, in a room
/// too, and a body in a body whose normals are all inwards; a cavity in a solid does not, and neither does a solid in a
/// cavity or in a room.
/// @param all  the other intersections of the mesh
void add_inside(const Mesh::Impl& mesh, const Motion& motion, int threads, const std::atomic<bool>* stop,
                std::vector<Intersection>& all);

}  // namespace touchstone::mesh
