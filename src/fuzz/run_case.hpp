// One case alone, and the shrinking of one finding.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>

#include "fuzz/case_name.hpp"
#include "fuzz/judging/findings.hpp"
#include "fuzz/settings.hpp"
#include "fuzz/solver_under_test.hpp"

namespace touchstone::fuzz {

/// What one query shows.
struct CaseOutcome {
  std::optional<Finding> finding;
  bool allowed = false;  ///< the reply is wrong, and no failure by Allowance alone
};

/// The failure that one query shows, if any, with its example shrunk as far as the settings allow.
/// @param stop  called often while the example shrinks; true ends the shrinking
/// @throws InvalidQuery  when the solver does not support the query's kind
CaseOutcome run_case(SolverUnderTest& solver, const CaseName& name, const Settings& settings,
                     const std::function<bool()>& stop = {});

/// Shrinks the finding's example. Its failure class and its kind of degeneracy stay the same.
void shrink_finding(Finding& finding, SolverUnderTest& solver, const Settings& settings,
                    const std::function<bool()>& stop);

}  // namespace touchstone::fuzz
