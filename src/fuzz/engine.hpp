// The differential engine: queries of many families, a solver under test, the exact answer as judge.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "certify/time_errors.hpp"
#include "fuzz/judging/failure.hpp"
#include "fuzz/judging/findings.hpp"
#include "fuzz/settings.hpp"
#include "fuzz/solver_under_test.hpp"

namespace touchstone::fuzz {

/// The progress of a run.
struct Progress {
  std::uint64_t queries = 0;  ///< asked and judged
  double seconds = 0;
  std::array<std::uint64_t, kFailureClasses> failures{};
  std::size_t to_shrink = 0;  ///< findings; 0 while the search goes on
  std::size_t shrunk = 0;
};

/// Called a few times a second on the thread that called `run`. False ends the run, which then returns its findings so
/// far.
using Watch = std::function<bool(const Progress&)>;

/// Makes a solver. Each thread that asks queries calls it for a solver of its own, and destroys that before the thread
/// ends; the caller of `run` calls it once.
using SolverFactory = std::function<std::unique_ptr<SolverUnderTest>()>;

struct SearchOutcome {
  std::uint64_t queries = 0;          ///< asked and judged
  double seconds = 0;                 ///< of the search
  std::uint64_t given = 0;            ///< given queries of a wanted kind
  std::uint64_t given_asked = 0;      ///< those of them that were asked before the search ended
  std::uint64_t given_not_taken = 0;  ///< those of them whose kind the solver does not support
  std::uint64_t allowed = 0;          ///< replies that are no failures by Allowance::late, near or classes alone
  std::uint64_t not_claimed = 0;      ///< queries that were not asked, by Settings::claims
  certify::TimeErrors early;          ///< how far the claimed times that are no failures lie before the exact ones
  double solver_seconds = 0;          ///< that the solver took to answer, summed over the threads
  FailureTable table;
  std::vector<Finding> findings;
  std::size_t kinds_of_failure = 0;  ///< number of findings, those beyond `most_findings` included
  bool stopped = false;              ///< by the watch
};

/// @throws InvalidQuery  when the solver supports none of the kinds, or no given query is of one of them; exceptions of
/// the factory pass through
SearchOutcome run(const SolverFactory& make_solver, const Settings& settings, const Watch& watch = {});

}  // namespace touchstone::fuzz
