// A separation within a surface: pairs that are near along it are asked about touching alone.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <touchstone/mesh.hpp>

namespace touchstone::sequence {

/// The pairs of elements without a common vertex that are within the mesh's separation of each other at the positions
/// x, and that a chain of edges connects: from any corner of one to any corner of the other, shorter than `length` at
/// x. The length of an edge is Euclidean and rounded, and so is each sum: this is a selection, and no proof depends on
/// it. In ascending order.
/// @throws Stopped  soon after the flag of the options was set
std::vector<MeshPair> own_neighbours(const Mesh& mesh, const Positions& x, double length, const MeshOptions& options);

/// The mesh, whose separation these pairs do not have: their contact is touching.
Mesh touching_alone(const Mesh& mesh, const std::vector<MeshPair>& pairs);

/// How many of these contacts are about a separation and between two elements that an edge connects.
std::size_t own_neighbours_among(const Mesh& mesh, const std::vector<MeshContact>& contacts);

}  // namespace touchstone::sequence
