// SPDX-License-Identifier: MIT
#include "fuzz/engine.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include <touchstone/error.hpp>

#include "fuzz/answering_solver.hpp"
#include "fuzz/climb.hpp"
#include "fuzz/plan.hpp"
#include "fuzz/shrink.hpp"
#include "fuzz/simplicity.hpp"
#include "numbers/float_environment.hpp"

namespace touchstone::fuzz {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// What the threads of one run share.
struct Shared {
  std::atomic<bool> stop = false;
  std::atomic<std::uint64_t> next = 0;  ///< piece or finding to work on
  std::atomic<std::uint64_t> queries = 0;
  std::atomic<std::uint64_t> given_asked = 0;
  std::array<std::atomic<std::uint64_t>, kFailureClasses> failures{};

  /// The time counts from here: a solver's program may take as long to start as there is for the search.
  void start_clock() {
    std::call_once(started_once_, [this] {
      start_ = Clock::now();
      started_ = true;
    });
  }
  double seconds() const { return started_ ? seconds_since(start_) : 0; }

 private:
  std::once_flag started_once_;
  std::atomic<bool> started_ = false;
  Clock::time_point start_;
};

/// A solver with what asking it needs.
struct Asked {
  SolverUnderTest& solver;
  AnsweringSolver* whole = dynamic_cast<AnsweringSolver*>(&solver);
};

/// One thread's search.
class Searcher {
 public:
  Searcher(const Settings& settings, const Plan& plan, const GivenPlan& given, Shared& shared)
      : settings_(settings), plan_(plan), given_(given), shared_(shared) {}

  void work(const Asked& asked) {
    asked_ = &asked;
    shared_.start_clock();
    if (!settings_.given.empty()) {
      work_on_given();
      return;
    }
    while (!shared_.stop) {
      const auto piece = plan_.piece(shared_.next++);
      if (!piece) return;
      for (std::uint64_t i = 0; i < piece->count && !over(); ++i) {
        start_from({{piece->family, piece->kind, settings_.seed, piece->first + i}});
      }
    }
  }

  Findings findings;
  FailureTable table;

 private:
  bool over() {
    if (settings_.seconds && shared_.seconds() >= *settings_.seconds) shared_.stop = true;
    return shared_.stop;
  }

  void work_on_given() {
    const std::uint64_t count = given_.to_ask.size();
    for (std::uint64_t i = shared_.next++; i < count && !over(); i = shared_.next++) {
      const std::uint64_t position = given_.to_ask[i];
      ++shared_.given_asked;
      start_from({{{}, settings_.given[position].kind, settings_.seed, position}, 0, true});
    }
  }

  void start_from(CaseName name) {
    const Query query = start_of_case(name, settings_.given);
    look_at(name, query);
    if (settings_.climb == 0) return;
    Climb climb = name.given ? Climb(query, families::rng_of(name.start)) : Climb(name.start);
    for (name.step = 1; name.step <= settings_.climb && !over(); ++name.step) look_at(name, climb.next());
  }

  void look_at(const CaseName& name, const Query& query) {
    const Answer truth = solve(query, settings_.judge);
    const auto failure = failure_on(query, asked_->solver, asked_->whole, truth, settings_.early, reply_);
    shared_.queries.fetch_add(1, std::memory_order_relaxed);
    table.add_case(name);
    if (!failure) return;
    shared_.failures[FailureTable::index(failure->failure)].fetch_add(1, std::memory_order_relaxed);
    table.add_failure(name, failure->failure);
    findings.add(*failure, name, query, reply_, truth);
  }

  const Asked* asked_ = nullptr;
  const Settings& settings_;
  const Plan& plan_;
  const GivenPlan& given_;
  Shared& shared_;
  Reply reply_;
};

/// Runs `work(i)` on a thread of its own for every i below `count`, and meanwhile calls `look` a few times a second, until
/// it returns false, which ends the others. An exception of a thread ends the others and is thrown here.
template <class Work, class Look>
void on_threads(std::size_t count, Shared& shared, Work work, Look look) {
  std::mutex mutex;
  std::condition_variable done;
  std::size_t running = count;
  std::exception_ptr error;
  std::vector<std::jthread> threads;
  struct StopAtEnd {
    std::atomic<bool>& stop;
    ~StopAtEnd() { stop = true; }
  } const stop_at_end{shared.stop};  // before the threads are waited for, also when `look` throws
  for (std::size_t i = 0; i < count; ++i) {
    threads.emplace_back([&, i] {
      std::exception_ptr mine;
      try {
        const numbers::DefaultFloatEnvironment environment;
        work(i);
      } catch (...) {
        mine = std::current_exception();
        shared.stop = true;
      }
      const std::lock_guard lock(mutex);
      if (mine && !error) error = mine;
      --running;
      done.notify_one();
    });
  }
  bool watched = true;
  std::unique_lock lock(mutex);
  while (!done.wait_for(lock, std::chrono::milliseconds(100), [&] { return running == 0; })) {
    lock.unlock();
    if (watched && !look()) {
      watched = false;
      shared.stop = true;
    }
    lock.lock();
  }
  lock.unlock();
  threads.clear();
  if (error) std::rethrow_exception(error);
}

Progress progress_of(const Shared& shared) {
  Progress progress;
  progress.queries = shared.queries;
  progress.seconds = shared.seconds();
  for (std::size_t i = 0; i < kFailureClasses; ++i) progress.failures[i] = shared.failures[i];
  return progress;
}

std::string kind_names(const std::vector<Kind>& kinds) {
  std::string names;
  for (const Kind kind : kinds) names.append(names.empty() ? "" : ", ").append(kind_name(kind));
  return names;
}

std::vector<Kind> supported_kinds(const SolverUnderTest& solver, const std::vector<Kind>& wanted) {
  std::vector<Kind> kinds;
  for (const Kind kind : families::kKinds) {
    const bool is_wanted = wanted.empty() || std::find(wanted.begin(), wanted.end(), kind) != wanted.end();
    if (is_wanted && solver.supports(kind)) kinds.push_back(kind);
  }
  if (!kinds.empty()) return kinds;
  const std::string names = kind_names(wanted);
  throw InvalidQuery(solver.name() + " takes no queries" + (names.empty() ? "" : " of this kind: " + names));
}

GivenPlan what_to_ask(const SolverUnderTest& solver, const std::vector<Kind>& kinds, const Settings& settings) {
  GivenPlan plan = plan_of_given(settings.given, settings.kinds, kinds, settings.cases);
  if (settings.given.empty() || plan.wanted > plan.not_taken) return plan;
  if (plan.wanted == 0)
    throw InvalidQuery("no query that is given is of the kind asked for: " + kind_names(settings.kinds));
  throw InvalidQuery(solver.name() + " takes no queries of the kinds that are given");
}

std::vector<families::Family> wanted_families(const Settings& settings) {
  if (!settings.families.empty()) return settings.families;
  std::vector<families::Family> all;
  for (const families::FamilyInfo& family : families::all_families()) all.push_back(family.family);
  return all;
}

std::size_t thread_count(const Settings& settings) { return static_cast<std::size_t>(std::max(settings.threads, 1)); }

/// @returns false when the watch ended it
bool shrink_all(std::vector<Finding>& findings, const SolverFactory& make_solver, const Settings& settings,
                const Progress& found, const Watch& watch) {
  const Clock::time_point start = Clock::now();
  Shared shared;
  std::atomic<std::size_t> shrunk = 0;
  bool watched_to_the_end = true;
  const auto stop = [&] {
    if (settings.shrink_seconds && seconds_since(start) >= *settings.shrink_seconds) shared.stop = true;
    return shared.stop.load();
  };
  on_threads(
      std::min(thread_count(settings), findings.size()), shared,
      [&](std::size_t) {
        const auto solver = make_solver();
        for (std::size_t i = shared.next++; i < findings.size() && !stop(); i = shared.next++) {
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

void shrink_finding(Finding& finding, SolverUnderTest& solver, const Settings& settings,
                    const std::function<bool()>& stop) {
  if (settings.shrink_tries == 0) return;
  const Asked asked{solver};
  Example best = finding.example;
  const auto still_fails = [&](const Query& query) {
    const Answer truth = solve(query, settings.judge);
    // What depends on the answer alone comes first: asking the solver may be dear.
    if (truth.nature != finding.degeneracy.nature || truth.feature_a != finding.degeneracy.feature_a ||
        truth.feature_b != finding.degeneracy.feature_b || degeneracy_of(query, truth) != finding.degeneracy) {
      return false;
    }
    Reply reply;
    const auto failure = failure_on(query, asked.solver, asked.whole, truth, settings.early, reply);
    if (!failure || failure->failure != finding.failure) return false;
    best = {finding.example.name, query, std::move(reply), truth, failure->detail, difficulty(query)};
    return true;
  };
  ShrinkLimits limits;
  limits.tries = settings.shrink_tries;
  limits.stop = stop;
  shrink(finding.example.query, still_fails, limits);
  finding.example = std::move(best);  // the last one that failed is the simplest
}

std::optional<Finding> run_case(SolverUnderTest& solver, const CaseName& name, const Settings& settings,
                                const std::function<bool()>& stop) {
  const numbers::DefaultFloatEnvironment environment;
  supported_kinds(solver, {name.start.kind});
  const Asked asked{solver};
  const Query query = query_of_case(name, settings.given);
  const Answer truth = solve(query, settings.judge);
  Reply reply;
  const auto failure = failure_on(query, asked.solver, asked.whole, truth, settings.early, reply);
  if (!failure) return std::nullopt;
  Findings findings;
  findings.add(*failure, name, query, reply, truth);
  Finding finding = std::move(findings.take(1).front());
  shrink_finding(finding, solver, settings, stop);
  return finding;
}

Outcome run(const SolverFactory& make_solver, const Settings& settings, const Watch& watch) {
  auto first_solver = make_solver();
  const std::vector<Kind> kinds = supported_kinds(*first_solver, settings.kinds);
  const GivenPlan given = what_to_ask(*first_solver, kinds, settings);
  first_solver.reset();
  const Plan plan(wanted_families(settings), kinds, settings.cases);
  Shared shared;
  std::vector<Searcher> searchers;
  for (std::size_t i = 0; i < thread_count(settings); ++i) searchers.emplace_back(settings, plan, given, shared);

  Outcome outcome;
  on_threads(
      searchers.size(), shared,
      [&](std::size_t i) {
        const auto solver = make_solver();
        searchers[i].work({*solver});
      },
      [&] {
        if (watch && !watch(progress_of(shared))) outcome.stopped = true;
        return !outcome.stopped;
      });
  const Progress found = progress_of(shared);
  outcome.queries = found.queries;
  outcome.seconds = found.seconds;
  outcome.given = given.wanted;
  outcome.given_asked = shared.given_asked;
  outcome.given_not_taken = given.not_taken;
  Findings findings;
  for (Searcher& searcher : searchers) {
    outcome.table.merge(searcher.table);
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
