// Vertices of a mesh at equal positions: the corners of elements that are not joined.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <touchstone/mesh.hpp>

namespace touchstone {

/// How many of the vertices that collide are at exactly the position of another one that does; 0 and -0 are equal.
/// @throws InvalidQuery  for positions that do not fit the mesh, and for a coordinate that is not finite
std::size_t coinciding_vertices(const Mesh& mesh, const Positions& x);

}  // namespace touchstone
