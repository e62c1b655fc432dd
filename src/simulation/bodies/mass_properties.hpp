// The mass of a rigid body, its centre, and its moments of inertia, from its shape.
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

#include "bodies/pose.hpp"

namespace touchstone::sim {

struct MassProperties {
  double mass = 0;                    ///< kg
  Vector3 centre = Vector3::Zero();   ///< of mass, m
  Matrix3 inertia = Matrix3::Zero();  ///< about the centre of mass, kg m^2
};

/// Of the solid inside a closed mesh whose faces turn counter-clockwise as seen from outside. The mass is negative when
/// they turn the other way.
/// @param density  kg/m^3
MassProperties solid_properties(const std::vector<Vector3>& vertices,
                                const std::vector<std::array<std::uint32_t, 3>>& faces, double density);

/// Of thin straight wires.
/// @param density  kg/m
MassProperties wire_properties(const std::vector<Vector3>& vertices,
                               const std::vector<std::array<std::uint32_t, 2>>& edges, double density);

}  // namespace touchstone::sim
