// The positions of a mesh's vertices at both ends of a step, checked.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include <touchstone/mesh.hpp>
#include <touchstone/query.hpp>

#include "broad_phase/large_vector.hpp"
#include "mesh/mesh_elements.hpp"

namespace touchstone::mesh {

/// A vertex at t = 0 and t = 1.
struct MovingVertex {
  Vec3 start, end;
};

using Motion = broad_phase::LargeVector<MovingVertex>;

inline constexpr const char *kAtStart = " at t = 0", *kAtEnd = " at t = 1";

/// @param when           one of these; empty: at rest
/// @throws InvalidQuery  "vertex 3 has y = 0.5 at t = 1", and the fault
[[noreturn]] void refuse_coordinate(std::size_t vertex, std::size_t axis, double value, const char* when,
                                    const std::string& fault);

/// Sets the motion to that from x0 to x1.
/// @throws InvalidQuery  for positions that do not fit the mesh, or naming the first vertex with a coordinate that is
///                       not finite
void set_motion(Motion& motion, const Mesh::Impl& mesh, const Positions& x0, const Positions& x1, int threads);
Motion motion_of(const Mesh::Impl& mesh, const Positions& x0, const Positions& x1, int threads);

/// How a vertex moves: each coordinate is one rounded difference.
inline Vec3 way_of(const MovingVertex& vertex) noexcept {
  return {vertex.end.x - vertex.start.x, vertex.end.y - vertex.start.y, vertex.end.z - vertex.start.z};
}

/// The median length of an edge at the start. Some edges, evenly by their numbers, stand for all: so a floor of two
/// large faces counts for little. 0 without edges.
double usual_edge_length(const Mesh::Impl& mesh, const Motion& motion);

/// How far each vertex moves, or a little farther, as seen by someone who moves the usual way, which is the median
/// along each axis: so the distance of two elements falls by no more than the sum of their corners' greatest ones.
std::vector<double> lengths_beside_usual_way(const Motion& motion);

/// The median of these, of some vertices as above; 0 without vertices.
double usual_length_beside_usual_way(const Motion& motion);

/// The query of the vertices `corners`, as many as the kind has.
Query query_of(const Motion& motion, Kind kind, const std::array<Index, 4>& corners) noexcept;

}  // namespace touchstone::mesh
