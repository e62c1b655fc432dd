// Any C++ callable as a solver under test.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "fuzz/solver_under_test.hpp"

namespace touchstone::fuzz {

using Callable = std::function<Reply(const Query&)>;

/// It runs in this process: an exception is a crash that is found, but a signal ends everything and a loop without end
/// never returns. A solver that may do either belongs into a child process.
/// @param supports  the kinds that it takes; empty: all
std::unique_ptr<SolverUnderTest> callable_solver(std::string name, Callable callable,
                                                 std::function<bool(Kind)> supports = {});

}  // namespace touchstone::fuzz
