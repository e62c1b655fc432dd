// The scene that a simulation starts from: one that comes with the program, a scene file or a checkpoint.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <touchstone/error.hpp>

#include "cli/simulate/simulate.hpp"
#include "io/fail.hpp"
#include "scene/scene.hpp"
#include "sim/checkpoint.hpp"

namespace touchstone::cli {

/// The result of `make`. Errors of `make` name the file `path`, which its result is made from. @throws FileError
template <class Make>
auto naming_file(const std::string& path, Make make) {
  try {
    return make();
  } catch (const Error& error) {
    io::fail(path, error.what());
  }
}

/// The scene that the options name. @throws Error
sim::Scene scene_of(const SimulateOptions& options);

/// @throws Error
sim::Checkpoint read_checkpoint(const std::string& path);

}  // namespace touchstone::cli
