// The differential engine: queries of many families, a solver under test, the exact answer as judge.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <touchstone/query.hpp>
#include <touchstone/solve.hpp>

#include "families/families.hpp"
#include "fuzz/failure.hpp"
#include "fuzz/findings.hpp"
#include "fuzz/solver_under_test.hpp"

namespace touchstone::fuzz {

struct Settings {
  std::vector<Query> given;                ///< unless empty, each of these once, and no family
  std::vector<families::Family> families;  ///< empty: all
  std::vector<Kind> kinds;                 ///< empty: all; those that the solver does not support are left out
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> cases;  ///< how many families' or given queries to start from, at most
  std::optional<double> seconds;       ///< how long to search, at most, from when the first thread has its solver
  std::uint64_t climb = 0;             ///< steps of hill climbing from each of them; each step is asked as well
  int threads = 1;                     ///< at least 1; with `cases` and no `seconds` nothing depends on it
  Method judge = Method::exact;
  EarlyLimit early;
  std::size_t most_findings = 0;         ///< 0: all
  std::uint64_t shrink_tries = 20'000;   ///< for each finding; 0: examples stay as they were found
  std::optional<double> shrink_seconds;  ///< for all of them; nothing: no limit
};

/// How far a run has come.
struct Progress {
  std::uint64_t queries = 0;  ///< asked and judged
  double seconds = 0;
  std::array<std::uint64_t, kFailureClasses> failures{};
  std::size_t to_shrink = 0;  ///< findings; 0 while the search goes on
  std::size_t shrunk = 0;
};

/// Called a few times a second, on the thread that called `run`; false ends the run, with what it has found.
using Watch = std::function<bool(const Progress&)>;

/// Called by every thread that asks, for a solver of its own that is asked by no other thread and destroyed before the
/// thread ends; and once by the caller of `run`.
using SolverFactory = std::function<std::unique_ptr<SolverUnderTest>()>;

struct Outcome {
  std::uint64_t queries = 0;          ///< asked and judged
  double seconds = 0;                 ///< of the search
  std::uint64_t given = 0;            ///< of the queries that were given, those of a kind that is wanted
  std::uint64_t given_asked = 0;      ///< how many of these were asked before the search ended
  std::uint64_t given_not_taken = 0;  ///< and how many are of a kind that the solver does not take
  FailureTable table;
  std::vector<Finding> findings;
  std::size_t kinds_of_failure = 0;  ///< how many findings there are, those beyond `most_findings` included
  bool stopped = false;              ///< by the watch
};

/// @throws InvalidQuery  when the solver supports none of the kinds or nothing given is of one; and what the factory
/// throws
Outcome run(const SolverFactory& make_solver, const Settings& settings, const Watch& watch = {});

/// What one query shows: the failure, if there is one, with its example shrunk as far as the settings allow.
/// @param stop  asked often while it shrinks; true ends that
std::optional<Finding> run_case(SolverUnderTest& solver, const CaseName& name, const Settings& settings,
                                const std::function<bool()>& stop = {});

/// Shrinks the finding's example: the failing class and the kind of degeneracy stay what they are.
void shrink_finding(Finding& finding, SolverUnderTest& solver, const Settings& settings,
                    const std::function<bool()>& stop);

}  // namespace touchstone::fuzz
