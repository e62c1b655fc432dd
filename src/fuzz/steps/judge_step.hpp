// Replies about a whole mesh in a step, judged by the exact answers to all pairs of its elements.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <touchstone/fuzz.hpp>

#include "families/step_scenes.hpp"
#include "fuzz/scenes/scene_search.hpp"

namespace touchstone::fuzz {

/// Asks, and compares with `solve` by Method::exact for each pair of elements by itself.
/// @return nothing when all of it is right
/// @throws InvalidQuery, InvalidMesh  for a scene without meaning
std::optional<SceneFailure> judge_step(const families::StepScene& scene, const StepSolver& solver,
                                       const StepFuzzOptions& options);

}  // namespace touchstone::fuzz
