// The child's side of a plugin: loads it, and answers the parent's queries.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "fuzz/processes/shared_call.hpp"

namespace touchstone::fuzz {

/// Runs in the child process until it is told to end. `path` is absolute. `call.failure` receives the reason when the
/// plugin cannot run.
void serve_plugin(const std::string& path, SharedCall& call);

}  // namespace touchstone::fuzz
