// The scene that a simulation starts from: one that comes with the program, a scene file or a checkpoint.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "cli/simulate/simulate.hpp"
#include "scene/scene.hpp"
#include "sim/checkpoint.hpp"

namespace touchstone::cli {

/// The scene that the options name. @throws Error
sim::Scene scene_of(const SimulateOptions& options);

/// @throws Error
sim::Checkpoint read_checkpoint(const std::string& path);

}  // namespace touchstone::cli
