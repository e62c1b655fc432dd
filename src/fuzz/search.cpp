// SPDX-License-Identifier: MIT
#include "fuzz/search.hpp"

#include <variant>

namespace touchstone::fuzz {

void SearchState::start_clock() {
  std::call_once(started_once_, [this] {
    start_ = std::chrono::steady_clock::now();
    started_ = true;
  });
}

double SearchState::seconds() const {
  return started_ ? std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count() : 0;
}

void Searcher::search(const JudgedSolver& solver) {
  state_.start_clock();
  if (settings_.given.empty()) {
    ask_families(solver);
  } else {
    ask_given(solver);
  }
}

bool Searcher::over() {
  if (settings_.seconds && state_.seconds() >= *settings_.seconds) state_.stop = true;
  return state_.stop;
}

void Searcher::ask_families(const JudgedSolver& solver) {
  while (!state_.stop) {
    const auto piece = plan_.piece(state_.next++);
    if (!piece) return;
    for (std::uint64_t i = 0; i < piece->count && !over(); ++i) {
      start_from({{piece->family, piece->kind, settings_.seed, piece->first_case + i}}, solver);
    }
  }
}

void Searcher::ask_given(const JudgedSolver& solver) {
  const std::uint64_t count = given_.to_ask.size();
  for (std::uint64_t i = state_.next++; i < count && !over(); i = state_.next++) {
    const std::uint64_t position = given_.to_ask[i];
    ++state_.given_asked;
    start_from({{{}, kind_of(settings_.given[position]), settings_.seed, position}, 0, true}, solver);
  }
}

void Searcher::start_from(CaseName name, const JudgedSolver& solver) {
  const CaseSource source = case_source(settings_);
  Asked asked = start_of_case(name, source);
  ask(name, asked, solver);
  if (settings_.climb == 0) return;
  Climb climb = climb_from(name, source);
  for (name.step = 1; name.step <= settings_.climb && !over(); ++name.step) {
    asked.query = climb.next();
    ask(name, asked, solver);
  }
}

void Searcher::ask(const CaseName& name, const Asked& asked, const JudgedSolver& solver) {
  if (const auto* const straight = std::get_if<Query>(&asked.query); settings_.claims && straight != nullptr) {
    if (!is_claimed(*straight, *settings_.claims, asked.separation)) {
      state_.not_claimed.fetch_add(1, std::memory_order_relaxed);
      return;
    }
  }
  const Answer truth = solver.truth(asked);
  const auto [reply, failure, allowed, seconds] = solver.ask(asked, truth);
  solver_seconds += seconds;
  state_.queries.fetch_add(1, std::memory_order_relaxed);
  table.add_case(name);
  if (allowed) state_.allowed.fetch_add(1, std::memory_order_relaxed);
  if (!failure) {
    if (reply.contact && reply.toi && truth.contact && *reply.toi <= truth.toi) early.add(*reply.toi, truth.toi);
    return;
  }
  state_.failures[FailureTable::index(failure->failure)].fetch_add(1, std::memory_order_relaxed);
  table.add_failure(name, failure->failure);
  findings.add(*failure, name, asked, reply, truth);
}

}  // namespace touchstone::fuzz
