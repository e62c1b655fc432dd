// The solvers of the project itself, by name.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "fuzz/solver_under_test.hpp"

namespace touchstone::fuzz {

/// "touchstone", "exact", "oracle", "fast-cgal", "batch" (touchstone, through solve_batch in rows and in columns), then
/// every method of `baselines` at its usual tolerance.
std::vector<std::string_view> solver_names();

/// The solver of that name, or null.
std::unique_ptr<SolverUnderTest> named_solver(std::string_view name);

}  // namespace touchstone::fuzz
