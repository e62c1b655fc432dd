// The solvers of the project itself, by name.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include <touchstone/separation.hpp>

#include "fuzz/solver_under_test.hpp"

namespace touchstone::fuzz {

/// "touchstone", "exact", "oracle", "fast-cgal", "batch" (touchstone, through solve_batch in rows and in columns), then
/// every method of `baselines` at its usual tolerance, those for curved queries last: with a separation > 0 those that
/// take one, which are Euclidean.
std::vector<std::string_view> solver_names(const Separation& separation = {});

/// The solver of that name, asked about the separation; null when there is none.
std::unique_ptr<SolverUnderTest> named_solver(std::string_view name, const Separation& separation = {});

}  // namespace touchstone::fuzz
