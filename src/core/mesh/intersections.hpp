// Where a mesh intersects itself at rest.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <vector>

#include <touchstone/mesh.hpp>

#include "mesh/moving_vertices.hpp"

namespace touchstone::mesh {

/// Those of `intersections` at the start of the motion, in its order.
std::vector<Intersection> find_intersections(const Mesh::Impl& mesh, const Motion& motion, int threads,
                                             const std::atomic<bool>* stop);

}  // namespace touchstone::mesh
