// Somebody's solver that is a program of its own, in any language, asked over pipes (pipe_protocol.hpp).
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "fuzz/limits.hpp"
#include "fuzz/solver_under_test.hpp"

namespace touchstone::fuzz {

/// Starts `command_line`, in the working folder: by itself when it is plain words, by /bin/sh when it holds anything
/// that a shell gives a meaning to. One query of each kind finds out which it supports. A query that ends or hangs it,
/// or gets no answer that can be read, costs the process, and the next query starts another. The thread that calls
/// this, and ask(), must live as long as the solver: on Linux the process dies with it.
/// @throws Error when it cannot be started or answers none of these first queries
std::unique_ptr<SolverUnderTest> run_command(const std::string& command_line, const Limits& limits = {});

}  // namespace touchstone::fuzz
