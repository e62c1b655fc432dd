// Scenes and sums that several tests of bodies use.
// SPDX-License-Identifier: MIT
#pragma once

#include "sim/simulation.hpp"

namespace touchstone::tests {

/// A box around its place, with its sides along the axes.
sim::Body box_at(const sim::Vector3& size, const sim::Vector3& at, double density = 500);

/// Without gravity.
sim::Scene empty_scene(double time_step);

struct Momentum {
  sim::Vector3 linear = sim::Vector3::Zero(), angular = sim::Vector3::Zero();
};

/// Of free bodies, about the origin.
Momentum momentum_of(const sim::BodySystem& system, const sim::BodyStates& states);

/// Of all bodies and particles.
Momentum momentum_of(const sim::Simulation& simulation);

/// Every pair of elements of two different bodies, asked without a broad phase: whether any touches.
bool any_touch(const sim::Colliders& colliders, const sim::BodyStates& from, const sim::BodyStates& to);

}  // namespace touchstone::tests
