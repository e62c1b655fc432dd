// A shared library under test that is asked about whole steps: touchstone/plugin.h, touchstone_ask_step.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <touchstone/fuzz.hpp>

#include "fuzz/processes/limits.hpp"

namespace touchstone::fuzz {

/// The library's function, in a process that ends with the calling thread, on which alone it may be called. It is
/// started again and throws as that of run_step_command, whose lines and replies go through the same pipes.
/// @throws Error  when the library cannot be used
StepSolver run_step_plugin(const std::string& path, const Limits& limits);

}  // namespace touchstone::fuzz
