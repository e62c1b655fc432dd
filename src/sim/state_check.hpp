// Whether a state that was read from a checkpoint can be one of the scene's.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "dynamics/stepper.hpp"

namespace touchstone::sim {

/// A step is halved so often at most, and a run has so many of them at most: sums of steps and parts are exact.
constexpr int kMostHalvings = 24;
constexpr std::uint64_t kMostSteps = 1'000'000'000'000;

/// Every state that a run of the scene comes to after whole steps passes.
/// @throws Error "KEY[NUMBER]: what is wrong, and what would be right", by the keys of a checkpoint
void check_state(const Scene& scene, const System& system, const State& state, std::uint64_t steps);

}  // namespace touchstone::sim
