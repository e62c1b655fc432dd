// SPDX-License-Identifier: MIT
#include "fuzz/engine.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <utility>

#include <touchstone/error.hpp>

#include "fuzz/judging/judged_solver.hpp"
#include "fuzz/plan.hpp"
#include "fuzz/run_case.hpp"
#include "fuzz/search.hpp"
#include "fuzz/worker_threads.hpp"

namespace touchstone::fuzz {
namespace {

Progress progress_of(const SearchState& state) {
  Progress progress;
  progress.queries = state.queries;
  progress.seconds = state.seconds();
  for (std::size_t i = 0; i < kFailureClasses; ++i) progress.failures[i] = state.failures[i];
  return progress;
}

GivenPlan given_to_ask(const SolverUnderTest& solver, const std::vector<Kind>& kinds, const Settings& settings) {
  GivenPlan plan = plan_of_given(settings.given, settings.kinds, kinds, settings.cases);
  if (settings.given.empty() || plan.selected > plan.not_taken) return plan;
  if (plan.selected == 0)
    throw InvalidQuery("no query that is given is of the kind asked for: " + kind_names(settings.kinds));
  throw InvalidQuery(solver.name() + " takes no queries of the kinds that are given");
}

std::vector<families::Family> selected_families(const Settings& settings) {
  if (!settings.families.empty()) return settings.families;
  std::vector<families::Family> all;
  if (settings.curved) {
    for (const families::FamilyInfo& family : families::curved_families()) all.push_back(family.family);
    return all;
  }
  for (const families::FamilyInfo& family : families::all_families()) {
    // Those are special for their own distances only.
    if (family.group != families::Group::separation || settings.own_separations) all.push_back(family.family);
  }
  return all;
}

std::size_t thread_count(const Settings& settings) { return static_cast<std::size_t>(std::max(settings.threads, 1)); }

/// Shrinks the example of every finding, as many at a time as there are threads.
/// @returns false when the watch ended it
bool shrink_all(std::vector<Finding>& findings, const SolverFactory& make_solver, const Settings& settings,
                const Progress& found, const Watch& watch) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  std::atomic<bool> stopped = false;
  std::atomic<std::size_t> next = 0;
  std::atomic<std::size_t> shrunk = 0;
  bool watched_to_the_end = true;
  const auto stop = [&] {
    const std::chrono::duration<double> elapsed = Clock::now() - start;
    if (settings.shrink_seconds && elapsed.count() >= *settings.shrink_seconds) stopped = true;
    return stopped.load();
  };
  run_on_threads(
      std::min(thread_count(settings), findings.size()), stopped,
      [&](std::size_t) {
        const auto solver = make_solver();
        for (std::size_t i = next++; i < findings.size() && !stop(); i = next++) {
          shrink_finding(findings[i], *solver, settings, stop);
          ++shrunk;
        }
      },
      [&] {
        Progress progress = found;
        progress.to_shrink = findings.size();
        progress.shrunk = shrunk;
        if (watch && !watch(progress)) watched_to_the_end = false;
        return watched_to_the_end;
      });
  return watched_to_the_end;
}

}  // namespace

SearchOutcome run(const SolverFactory& make_solver, const Settings& settings, const Watch& watch) {
  auto first_solver = make_solver();
  const std::vector<Kind> kinds = supported_kinds(*first_solver, settings.kinds);
  const GivenPlan given = given_to_ask(*first_solver, kinds, settings);
  const std::vector<families::Family> families = selected_families(settings);
  for (const AnyQuery& query : settings.given) check_sort(*first_solver, is_curved(query));
  for (const families::Family family : families) {
    if (settings.given.empty()) check_sort(*first_solver, families::is_curved(family));
  }
  first_solver.reset();
  const Plan plan(families, kinds, settings.cases);
  SearchState state;
  std::vector<Searcher> searchers;
  for (std::size_t i = 0; i < thread_count(settings); ++i) searchers.emplace_back(settings, plan, given, state);

  SearchOutcome outcome;
  run_on_threads(
      searchers.size(), state.stop,
      [&](std::size_t i) {
        const auto solver = make_solver();
        searchers[i].search(JudgedSolver(*solver, settings));
      },
      [&] {
        if (watch && !watch(progress_of(state))) outcome.stopped = true;
        return !outcome.stopped;
      });
  const Progress found = progress_of(state);
  outcome.queries = found.queries;
  outcome.seconds = found.seconds;
  outcome.allowed = state.allowed;
  outcome.not_claimed = state.not_claimed;
  outcome.given = given.selected;
  outcome.given_asked = state.given_asked;
  outcome.given_not_taken = given.not_taken;
  Findings findings;
  for (Searcher& searcher : searchers) {
    outcome.table.merge(searcher.table);
    outcome.early.merge(searcher.early);
    outcome.solver_seconds += searcher.solver_seconds;
    findings.merge(std::move(searcher.findings));
  }
  outcome.kinds_of_failure = findings.size();
  outcome.findings = findings.take(settings.most_findings);
  if (!outcome.stopped && !outcome.findings.empty()) {
    outcome.stopped = !shrink_all(outcome.findings, make_solver, settings, found, watch);
  }
  return outcome;
}

}  // namespace touchstone::fuzz
