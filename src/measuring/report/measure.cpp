// SPDX-License-Identifier: MIT
#include "report/measure.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "families/body_scenes.hpp"
#include "report/timing.hpp"

namespace touchstone::report {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::array<double, 5> percentiles(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  constexpr std::array<double, 5> kQuantiles{0.5, 0.9, 0.99, 0.999, 1};
  std::array<double, 5> result{};
  for (std::size_t i = 0; i < kQuantiles.size(); ++i) {
    // The least value that so many are no greater than.
    const double rank = std::ceil(kQuantiles[i] * static_cast<double>(values.size()));
    result[i] = values[std::max<std::size_t>(1, static_cast<std::size_t>(rank)) - 1];
  }
  return result;
}

template <class AnyQuery>
Answer exact_answer(const AnyQuery& query, const Separation& separation) {
  return solve(query, {.separation = separation, .method = Method::exact});
}

/// The first contact of all pairs of elements, each by itself: without boxes and trees.
Answer exact_answer(const baselines::MovingBodies& step, const Separation& separation) {
  Answer first;
  for (const BodyPair& pair : families::every_pair(step.bodies)) {
    const Answer answer = exact_answer(query_of(step.bodies, pair, step.motions), separation);
    if (answer.contact && answer.toi < first.toi) first = answer;
  }
  return first;
}

void count(const ContestantReply& reply, const Answer& truth, Result& result, std::vector<std::int64_t>& errors) {
  result.contacts += truth.contact;
  switch (judge(reply.claim, truth)) {
    case Verdict::missed: ++result.missed; break;
    case Verdict::phantom: ++result.phantom; break;
    case Verdict::late: ++result.late; break;
    case Verdict::holds: break;
  }
  if (truth.contact && reply.claim.toi) errors.push_back(signed_ulps(*reply.claim.toi, truth.toi));
  if (result.contestant.may_be_wrong()) return;
  switch (reply.level) {
    case Level::filter: ++result.levels.filter; break;
    case Level::bracket: ++result.levels.bracket; break;
    case Level::exact: ++result.levels.exact; break;
    case Level::oracle: ++result.levels.oracle; break;
  }
}

/// Asks queries one by one until the budget is spent, judges the replies, and gives each query's microseconds.
template <class AnyQuery>
std::vector<double> first_round(const QuerySet& set, const std::vector<AnyQuery>& queries, double budget,
                                Result& result) {
  std::vector<double> microseconds;
  std::vector<std::int64_t> errors;
  const auto begin = Clock::now();
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const auto start = Clock::now();
    const ContestantReply reply = ask(result.contestant, queries[i], set.separation);
    microseconds.push_back(1e6 * seconds_since(start));
    count(reply, set.truth[i], result, errors);
    if (seconds_since(begin) > budget) break;
  }
  result.asked = microseconds.size();
  result.time_error = time_error(std::move(errors));
  return microseconds;
}

void another_round(const QuerySet& set, const Result& result, std::vector<double>& microseconds) {
  set.with_queries([&](const auto& queries) {
    for (std::size_t i = 0; i < result.asked; ++i) {
      const auto start = Clock::now();
      ask(result.contestant, queries[i], set.separation);
      microseconds[i] = std::min(microseconds[i], 1e6 * seconds_since(start));
    }
  });
}

/// Mean microseconds a query.
double pass(const QuerySet& set, const Result& result, double least) {
  const auto ask = [&] {
    set.with_queries([&](const auto& queries) { ask_all(result.contestant, queries, result.asked, set.separation); });
  };
  return 1e6 * seconds_of_call(ask, least) / static_cast<double>(result.asked);
}

}  // namespace

SetResults measure(QuerySet set, const std::vector<Contestant>& contestants, const Effort& effort, const Pulse& pulse) {
  std::vector<Answer> truth;
  set.with_queries([&](const auto& queries) {
    for (const auto& query : queries) {
      if (truth.size() % 1024 == 0 || set.is_of_bodies()) pulse();
      truth.push_back(exact_answer(query, set.separation));
    }
  });
  set.truth = std::move(truth);
  SetResults all;
  std::vector<std::vector<double>> singles;
  for (const Contestant& contestant : contestants) {
    pulse();
    Result& result = all.results.emplace_back();
    result.contestant = contestant;
    singles.emplace_back();
    if (contestant.supports(set.kind)) {
      const bool in_full = effort.ours_in_full && !contestant.may_be_wrong();
      const double budget = in_full ? std::numeric_limits<double>::infinity() : effort.budget;
      set.with_queries([&](const auto& queries) { singles.back() = first_round(set, queries, budget, result); });
    }
  }
  for (int round = 0; round < std::max(effort.passes, effort.tries - 1); ++round) {
    for (std::size_t i = 0; i < all.results.size(); ++i) {
      Result& result = all.results[i];
      if (result.asked == 0) continue;
      pulse();
      if (round < effort.passes) result.passes.push_back(pass(set, result, effort.least_pass));
      if (round < effort.tries - 1) another_round(set, result, singles[i]);
    }
  }
  for (std::size_t i = 0; i < all.results.size(); ++i) {
    if (all.results[i].asked == 0) continue;
    all.results[i].mean = median(all.results[i].passes);
    all.results[i].percentiles = percentiles(std::move(singles[i]));
  }
  all.set = std::move(set);
  return all;
}

}  // namespace touchstone::report
