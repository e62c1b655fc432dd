// A solver in a shared library (touchstone/plugin.h), asked in a process of its own.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include <touchstone/separation.hpp>

#include "fuzz/processes/limits.hpp"
#include "fuzz/solver_under_test.hpp"

namespace touchstone::fuzz {

/// Starts the process and loads the library there. A query on which it crashes or hangs costs the process, and the next
/// query starts another. The thread that calls this, and ask(), must live as long as the solver: on Linux the process
/// dies with it.
/// @param separation  what the queries ask about; the library is told
/// @throws Error when there is no such library, when it does not export touchstone_solver() or was made for another
/// version,
/// when its init fails, crashes or hangs, or when it does not take the separation
std::unique_ptr<SolverUnderTest> load_plugin(const std::string& path, const Limits& limits = {},
                                             const Separation& separation = {});

}  // namespace touchstone::fuzz
