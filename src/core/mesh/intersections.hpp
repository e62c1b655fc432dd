// Where a mesh intersects itself at rest.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include <touchstone/mesh.hpp>

#include "mesh/moving_vertices.hpp"

namespace touchstone::mesh {

enum class HowMany : std::uint8_t { all, any };

/// Those of `intersections` at the start of the motion, in its order; or some of them, where there are any.
std::vector<Intersection> find_intersections(const Mesh::Impl& mesh, const Motion& motion, int threads,
                                             const std::atomic<bool>* stop, HowMany how_many = HowMany::all);

}  // namespace touchstone::mesh
