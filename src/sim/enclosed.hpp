// Points wholly inside a closed surface: no contact of surfaces shows them.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include <touchstone/mesh.hpp>

namespace touchstone::sim {

/// Whether the faces have an inside: each of their edges is in an even number of them.
bool is_closed(const std::vector<std::array<MeshIndex, 3>>& faces);

/// Of each point, whether it is inside the closed surface, exactly: a ray from it leaves the surface as often as it
/// enters it, and once more. A point on the surface is not inside.
std::vector<char> enclosed(const std::vector<std::array<MeshIndex, 3>>& faces, const std::vector<Vec3>& corners,
                           const std::vector<Vec3>& points, int threads);

}  // namespace touchstone::sim
