// Positions that are likely mistakes of a file: vertices that are not joined, and faces that are or become flat.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <touchstone/mesh.hpp>

namespace touchstone {

/// How many of the vertices that collide are at exactly the position of another one that does; 0 and -0 are equal.
/// @throws InvalidQuery  for positions that do not fit the mesh, and for a coordinate that is not finite
std::size_t coinciding_vertices(const Mesh& mesh, const Positions& x);

/// How many faces have their corners on one line, exactly: their own edges lie on each other, which is no intersection.
/// @throws InvalidQuery  likewise
std::size_t flat_faces(const Mesh& mesh, const Positions& x);

/// How many faces may be flat at some time of the step from x0 to x1: all that are, and perhaps others.
/// @throws InvalidQuery  likewise
std::size_t turning_faces(const Mesh& mesh, const Positions& x0, const Positions& x1);

}  // namespace touchstone
