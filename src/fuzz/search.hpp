// The search of one run: each thread takes pieces of the plan, asks the solver and collects failures.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>

#include <touchstone/query.hpp>

#include "certify/time_errors.hpp"
#include "fuzz/case_name.hpp"
#include "fuzz/judging/failure.hpp"
#include "fuzz/judging/findings.hpp"
#include "fuzz/judging/judged_solver.hpp"
#include "fuzz/plan.hpp"
#include "fuzz/settings.hpp"

namespace touchstone::fuzz {

/// The state that the threads of one search share.
struct SearchState {
  std::atomic<bool> stop = false;
  std::atomic<std::uint64_t> next = 0;  ///< the next piece of the plan, or the next given query
  std::atomic<std::uint64_t> queries = 0;
  std::atomic<std::uint64_t> given_asked = 0;
  std::atomic<std::uint64_t> allowed = 0;      ///< replies that are no failures by Allowance alone
  std::atomic<std::uint64_t> not_claimed = 0;  ///< queries that were not asked, by Settings::claims
  std::array<std::atomic<std::uint64_t>, kFailureClasses> failures{};

  /// Starts the clock, once. A solver's program may take as long to start as there is for the search, so that time
  /// counts from the first thread that has its solver.
  void start_clock();

  double seconds() const;  ///< since then; 0 before

 private:
  std::once_flag started_once_;
  std::atomic<bool> started_ = false;
  std::chrono::steady_clock::time_point start_;
};

/// The search of one thread.
class Searcher {
 public:
  /// The references must outlive the searcher.
  Searcher(const Settings& settings, const Plan& plan, const GivenPlan& given, SearchState& state)
      : settings_(settings), plan_(plan), given_(given), state_(state) {}

  /// Asks until the plan is done or the search is to stop.
  void search(const JudgedSolver& solver);

  Findings findings;
  FailureTable table;
  certify::TimeErrors early;  ///< of the claimed times that are no failures
  double solver_seconds = 0;

 private:
  bool over();
  void ask_families(const JudgedSolver& solver);
  void ask_given(const JudgedSolver& solver);
  void start_from(CaseName name, const JudgedSolver& solver);
  void ask(const CaseName& name, const Asked& asked, const JudgedSolver& solver);

  const Settings& settings_;
  const Plan& plan_;
  const GivenPlan& given_;
  SearchState& state_;
};

}  // namespace touchstone::fuzz
