// SPDX-License-Identifier: MIT
#include "cli/bench/methods.hpp"

#include <algorithm>
#include <chrono>

#include "filters/same_side.hpp"
#include "report/do_not_optimize.hpp"

namespace touchstone::cli {
namespace {

/// Kinds without a V have fewer corners, and zeros in place of the others: the cost is the same.
void ask_floor(const Query& query) {
  report::do_not_optimize(filters::coplanarity_coefficients(filters::frame_of(query)));
}

void ask(BenchMethod method, const Query& query, Answer& answer) {
  switch (method) {
    case BenchMethod::floor: ask_floor(query); return;
    case BenchMethod::touchstone:
    case BenchMethod::batch:
    case BenchMethod::columns: answer = solve(query); return;
    case BenchMethod::cgal: answer = solve(query, Method::fast_cgal); return;
    case BenchMethod::exact: answer = solve(query, Method::exact); return;
    case BenchMethod::oracle: answer = solve(query, Method::oracle); return;
  }
}

}  // namespace

std::string_view bench_method_name(BenchMethod method) noexcept {
  switch (method) {
    case BenchMethod::floor: return "floor";
    case BenchMethod::touchstone: return "touchstone";
    case BenchMethod::batch: return "touchstone_batch";
    case BenchMethod::columns: return "touchstone_columns";
    case BenchMethod::cgal: return "touchstone_cgal";
    case BenchMethod::exact: return "exact";
    case BenchMethod::oracle: return "oracle";
  }
  return {};
}

std::size_t most_queries(BenchMethod method) noexcept {
  constexpr std::size_t kAll = 100'000;
  return method == BenchMethod::oracle ? 20 : method == BenchMethod::exact ? 1000 : kAll;
}

std::vector<Query> spread(const std::vector<Query>& queries, std::size_t most) {
  std::vector<Query> some;
  const std::size_t step = std::max<std::size_t>(1, (queries.size() + most - 1) / most);
  for (std::size_t i = 0; i < queries.size(); i += step) some.push_back(queries[i]);
  return some;
}

void ask_all(BenchMethod method, const std::vector<Query>& queries, const QueryColumns& columns,
             std::vector<Answer>& answers) {
  // Each method has a loop of its own, so that no query pays for the choice.
  switch (method) {
    case BenchMethod::floor:
      for (const Query& query : queries) ask_floor(query);
      break;
    case BenchMethod::touchstone:
      for (std::size_t i = 0; i < queries.size(); ++i) answers[i] = solve(queries[i]);
      break;
    case BenchMethod::batch: solve_batch(queries.data(), queries.size(), answers.data()); break;
    case BenchMethod::columns: solve_batch(columns, answers.data()); break;
    case BenchMethod::cgal:
      for (std::size_t i = 0; i < queries.size(); ++i) answers[i] = solve(queries[i], Method::fast_cgal);
      break;
    case BenchMethod::exact:
    case BenchMethod::oracle:
      for (std::size_t i = 0; i < queries.size(); ++i) ask(method, queries[i], answers[i]);
      break;
  }
  report::do_not_optimize(answers);
}

double slowest_microseconds(BenchMethod method, const std::vector<Query>& queries) {
  using Clock = std::chrono::steady_clock;
  if (method == BenchMethod::batch || method == BenchMethod::columns) return -1;
  double slowest = 0;
  Answer answer;
  for (const Query& query : queries) {
    double best = 0;
    for (int attempt = 0; attempt < 3; ++attempt) {
      const auto start = Clock::now();
      ask(method, query, answer);
      report::do_not_optimize(answer);
      const double taken = std::chrono::duration<double, std::micro>(Clock::now() - start).count();
      if (attempt == 0 || taken < best) best = taken;
    }
    slowest = std::max(slowest, best);
  }
  return slowest;
}

}  // namespace touchstone::cli
