// Any C++ callable as a solver under test.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "fuzz/solver_under_test.hpp"

namespace touchstone::fuzz {

using Callable = std::function<Reply(const Query&)>;

/// The callable runs in this process. An exception of it is a finding, but a signal ends the whole program, and an
/// endless loop never returns. A solver that may do either belongs into a child process.
/// @param supports  the kinds that it takes; empty: all
std::unique_ptr<SolverUnderTest> callable_solver(std::string name, Callable callable,
                                                 std::function<bool(Kind)> supports = {});

}  // namespace touchstone::fuzz
