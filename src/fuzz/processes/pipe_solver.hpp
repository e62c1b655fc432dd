// A solver that is a program of its own, in any language, and is asked over pipes (pipes/protocol.hpp).
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include <touchstone/separation.hpp>

#include "fuzz/processes/limits.hpp"
#include "fuzz/solver_under_test.hpp"

namespace touchstone::fuzz {

/// Starts `command_line` in the working folder: directly when it is plain words, by /bin/sh when it holds characters
/// with a meaning to a shell. One query of each kind finds out which kinds the program supports. A query on which
/// the program ends, hangs or gives no readable answer costs the process, and the next query starts another. The thread
/// that calls this, and ask(), must live as long as the solver: on Linux the process dies with it.
/// @param separation  what the queries ask about; the program is told each time that it starts
/// @throws Error when the program cannot be started, answers none of these first queries, or takes no separation
std::unique_ptr<SolverUnderTest> run_command(const std::string& command_line, const Limits& limits = {},
                                             const Separation& separation = {});

}  // namespace touchstone::fuzz
