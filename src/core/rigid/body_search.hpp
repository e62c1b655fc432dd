// The contacts of bodies in a step.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include <touchstone/bodies.hpp>

#include "rigid/body_data.hpp"

namespace touchstone::rigid {

/// The pairs of bodies whose elements may come near each other in a step, in ascending order.
/// @param motions  valid
std::vector<std::array<BodyIndex, 2>> near_bodies(const Bodies& bodies, const CollidingBodies& colliding,
                                                  const std::vector<RigidMotion>& motions);

/// Every pair of elements in contact in the step, in the order of all_contacts.
std::vector<BodyContact> find_all(const Bodies& bodies, const CollidingBodies& colliding,
                                  const std::vector<RigidMotion>& motions, const StepOptions& options);

FirstBodyContact find_first(const Bodies& bodies, const CollidingBodies& colliding,
                            const std::vector<RigidMotion>& motions, const BodyStepOptions& options);

/// @param poses  valid
std::vector<BodyIntersection> find_intersections(const Bodies& bodies, const CollidingBodies& colliding,
                                                 const std::vector<Pose>& poses, const MeshOptions& options);

std::vector<Pose> starts_of(const std::vector<RigidMotion>& motions);

/// The motions that rest in these poses.
std::vector<RigidMotion> resting(const std::vector<Pose>& poses);

}  // namespace touchstone::rigid
