// Whether a state that was read from a checkpoint can be a state of the scene.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "dynamics/state.hpp"
#include "sim/step_limits.hpp"

namespace touchstone::sim {

/// Accepts every state that a run of the scene comes to after whole steps.
/// @throws Error "KEY[NUMBER]: the fault and the right range", by the keys of a checkpoint
void check_state(const Scene& scene, const System& system, const State& state, std::uint64_t steps);

}  // namespace touchstone::sim
