// A rigid body of a scene, as a user writes it.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "bodies/mass_properties.hpp"

namespace touchstone::sim {

/// A point of a driven body's path. Between two of them it moves evenly and turns evenly, the shorter way; before the
/// first and after the last it rests.
struct BodyWaypoint {
  double time = 0;  ///< s
  Pose pose;

  bool operator==(const BodyWaypoint&) const = default;
};

enum class BodyMotion : std::uint8_t {
  free,   ///< gravity and contacts move it
  fixed,  ///< it never moves
  driven  ///< it moves at constant velocities, or along a path, whatever it meets
};
std::string_view body_motion_name(BodyMotion motion) noexcept;

/// A mesh (faces) or a wire frame (edges). Coordinates are in the body's own frame.
struct Body {
  std::vector<Vector3> vertices;                    ///< m
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< of a wire frame; those of a mesh follow from its faces
  std::vector<std::array<std::uint32_t, 3>> faces;  ///< of a mesh

  // Of a free body: either the density, or all of the others.
  double density = 0;                ///< kg/m^3 of the solid inside a closed mesh, kg/m of a wire frame
  double mass = 0;                   ///< kg
  Vector3 centre = Vector3::Zero();  ///< of mass, in the body's own frame, m
  std::array<double, 6> inertia{};   ///< about that centre: xx, yy, zz, xy, xz, yz, kg m^2

  Pose pose;                                   ///< of the body's own frame; a quaternion of any length
  Vector3 velocity = Vector3::Zero();          ///< of the centre of mass, or of the origin of a driven body, m/s
  Vector3 angular_velocity = Vector3::Zero();  ///< in the world's frame, rad/s
  BodyMotion motion = BodyMotion::free;
  std::vector<BodyWaypoint> path;  ///< of a driven body; not empty: instead of velocities
  double radius = 0;               ///< m, in contacts, of all its elements
};

/// Of a free body.
MassProperties mass_properties(const Body& body);

struct Scene;

/// @throws Error "bodies[i].KEY: the fault and what would be right"
void check_bodies(const Scene& scene);

}  // namespace touchstone::sim
