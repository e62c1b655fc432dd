// Points wholly inside a closed surface: no contact of surfaces shows them.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include <touchstone/mesh.hpp>

namespace touchstone::sim {

/// Whether the faces have an inside: each of their edges is in an even number of them.
bool is_closed(const std::vector<std::array<MeshIndex, 3>>& faces);

/// Whether a point that is not on the closed surface is inside it, exactly.
bool is_enclosed(const std::vector<std::array<MeshIndex, 3>>& faces, const Vec3* corners, const Vec3& point);

}  // namespace touchstone::sim
