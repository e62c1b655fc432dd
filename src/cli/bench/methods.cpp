// SPDX-License-Identifier: MIT
#include "cli/bench/methods.hpp"

#include <algorithm>
#include <chrono>

#include <touchstone/curved.hpp>

#include "baselines/separation_baseline.hpp"
#include "filters/apart/same_side.hpp"
#include "proofs/proof_text.hpp"
#include "report/do_not_optimize.hpp"

namespace touchstone::cli {
namespace {

const baselines::SeparationBaseline* baseline_of(BenchMethod method) {
  return is_baseline(method) ? baselines::find_separation_method(bench_method_name(method)) : nullptr;
}

/// Of the solver itself.
Method method_of(BenchMethod method) {
  switch (method) {
    case BenchMethod::cgal: return Method::fast_cgal;
    case BenchMethod::exact: return Method::exact;
    case BenchMethod::oracle: return Method::oracle;
    default: return Method::fast;
  }
}

Wanted answers_of(BenchMethod method) {
  if (method == BenchMethod::contact) return Wanted::contact;
  return method == BenchMethod::time ? Wanted::time : Wanted::all;
}

/// Of the solver itself, which takes a method or what is wanted.
template <class AnyQuery>
Answer answer_by(BenchMethod method, const AnyQuery& query, const Separation& separation) {
  const Wanted wanted = answers_of(method);
  return wanted == Wanted::all ? solve(query, {.separation = separation, .method = method_of(method)})
                               : solve(query, {.separation = separation, .wanted = wanted});
}

/// Kinds without a V have fewer corners, and zeros in place of the others: the cost is the same.
void ask_floor(const Query& query) {
  report::do_not_optimize(filters::coplanarity_coefficients(filters::frame_of(query)));
}

/// Contact and time alone.
Answer answer_of(const baselines::Result& result) {
  Answer answer;
  answer.contact = result.contact;
  answer.toi = result.toi;
  return answer;
}

template <class AnyQuery>
Answer answer_and_proof(const AnyQuery& query, const Separation& separation) {
  const Answer answer = solve(query, {.separation = separation});
  std::string text;
  proofs::append_proof_of(text, 0, query, answer, separation);
  report::do_not_optimize(text);
  return answer;
}

constexpr double kWholeStep = 1;

void ask(BenchMethod method, const Query& query, const Separation& separation, Answer& answer) {
  if (const auto* const baseline = baseline_of(method)) {
    answer = answer_of(baseline->solve(query, separation.distance, kWholeStep, baseline->usual_tolerance));
    return;
  }
  if (method == BenchMethod::prove) {
    answer = answer_and_proof(query, separation);
    return;
  }
  if (separation.distance > 0 && method != BenchMethod::floor) {
    answer = answer_by(method, query, separation);
    return;
  }
  switch (method) {
    case BenchMethod::floor: ask_floor(query); return;
    case BenchMethod::straight:
    case BenchMethod::touchstone:
    case BenchMethod::batch:
    case BenchMethod::columns: answer = solve(query); return;
    case BenchMethod::contact: answer = solve(query, {.wanted = Wanted::contact}); return;
    case BenchMethod::time: answer = solve(query, {.wanted = Wanted::time}); return;
    case BenchMethod::cgal: answer = solve(query, {.method = Method::fast_cgal}); return;
    case BenchMethod::exact: answer = solve(query, {.method = Method::exact}); return;
    case BenchMethod::oracle: answer = solve(query, {.method = Method::oracle}); return;
    case BenchMethod::prove:
    case BenchMethod::thick_polynomial:
    case BenchMethod::thick_advancement: return;
  }
}

}  // namespace

std::string_view bench_method_name(BenchMethod method) noexcept {
  switch (method) {
    case BenchMethod::floor: return "floor";
    case BenchMethod::straight: return "straight";
    case BenchMethod::touchstone: return "touchstone";
    case BenchMethod::contact: return "touchstone_contact";
    case BenchMethod::time: return "touchstone_time";
    case BenchMethod::batch: return "touchstone_batch";
    case BenchMethod::columns: return "touchstone_columns";
    case BenchMethod::cgal: return "touchstone_cgal";
    case BenchMethod::exact: return "exact";
    case BenchMethod::oracle: return "oracle";
    case BenchMethod::prove: return "prove";
    case BenchMethod::thick_polynomial: return "thick_polynomial";
    case BenchMethod::thick_advancement: return "thick_advancement";
  }
  return {};
}

bool takes(BenchMethod method, bool curved, const Separation& separation) noexcept {
  const bool by_cgal = method == BenchMethod::cgal || method == BenchMethod::oracle;
  if (by_cgal && !has_method(Method::oracle)) return false;
  if (curved) return !is_baseline(method) && method != BenchMethod::columns && answers_of(method) == Wanted::all;
  if (method == BenchMethod::straight) return false;
  return !is_baseline(method) || (separation.distance > 0 && separation.metric == Metric::euclidean);
}

std::size_t most_queries(BenchMethod method) noexcept {
  constexpr std::size_t kAll = 100'000;
  if (method == BenchMethod::oracle) return 20;
  return method == BenchMethod::exact || method == BenchMethod::prove ? 1000 : kAll;
}

namespace {

void ask_all_apart(BenchMethod method, const std::vector<Query>& queries, const QueryColumns& columns,
                   const Separation& separation, std::vector<Answer>& answers) {
  BatchOptions options;
  options.separation = separation;
  if (const auto* const baseline = baseline_of(method)) {
    const auto function = baseline->solve;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      report::do_not_optimize(function(queries[i], separation.distance, kWholeStep, baseline->usual_tolerance));
    }
  } else if (method == BenchMethod::batch) {
    solve_batch(queries.data(), queries.size(), answers.data(), options);
  } else if (method == BenchMethod::columns) {
    solve_batch(columns, answers.data(), options);
  } else if (method == BenchMethod::prove) {
    for (std::size_t i = 0; i < queries.size(); ++i) answers[i] = answer_and_proof(queries[i], separation);
  } else {
    for (std::size_t i = 0; i < queries.size(); ++i) answers[i] = answer_by(method, queries[i], separation);
  }
}

}  // namespace

void ask_all(BenchMethod method, const std::vector<Query>& queries, const QueryColumns& columns,
             const Separation& separation, std::vector<Answer>& answers) {
  if (separation.distance > 0 && method != BenchMethod::floor) {
    ask_all_apart(method, queries, columns, separation, answers);
    report::do_not_optimize(answers);
    return;
  }
  // Each method has a loop of its own, so that no query pays for the choice.
  switch (method) {
    case BenchMethod::floor:
      for (const Query& query : queries) ask_floor(query);
      break;
    case BenchMethod::straight:
    case BenchMethod::touchstone:
      for (std::size_t i = 0; i < queries.size(); ++i) answers[i] = solve(queries[i]);
      break;
    case BenchMethod::contact:
      for (std::size_t i = 0; i < queries.size(); ++i) answers[i] = solve(queries[i], {.wanted = Wanted::contact});
      break;
    case BenchMethod::time:
      for (std::size_t i = 0; i < queries.size(); ++i) answers[i] = solve(queries[i], {.wanted = Wanted::time});
      break;
    case BenchMethod::batch: solve_batch(queries.data(), queries.size(), answers.data()); break;
    case BenchMethod::columns: solve_batch(columns, answers.data()); break;
    case BenchMethod::cgal:
      for (std::size_t i = 0; i < queries.size(); ++i) answers[i] = solve(queries[i], {.method = Method::fast_cgal});
      break;
    case BenchMethod::exact:
    case BenchMethod::oracle:
    case BenchMethod::prove:
      for (std::size_t i = 0; i < queries.size(); ++i) ask(method, queries[i], separation, answers[i]);
      break;
    case BenchMethod::thick_polynomial:
    case BenchMethod::thick_advancement: break;
  }
  report::do_not_optimize(answers);
}

void ask_all(BenchMethod method, const std::vector<CurvedQuery>& queries, const Separation& separation,
             std::vector<Answer>& answers) {
  if (method == BenchMethod::batch) {
    BatchOptions options;
    options.separation = separation;
    solve_batch(queries.data(), queries.size(), answers.data(), options);
  } else if (method == BenchMethod::prove) {
    for (std::size_t i = 0; i < queries.size(); ++i) answers[i] = answer_and_proof(queries[i], separation);
  } else {
    for (std::size_t i = 0; i < queries.size(); ++i) answers[i] = answer_by(method, queries[i], separation);
  }
  report::do_not_optimize(answers);
}

namespace {

void ask(BenchMethod method, const CurvedQuery& query, const Separation& separation, Answer& answer) {
  answer = method == BenchMethod::prove ? answer_and_proof(query, separation) : answer_by(method, query, separation);
}

template <class AnyQuery>
double slowest(BenchMethod method, const std::vector<AnyQuery>& queries, const Separation& separation) {
  using Clock = std::chrono::steady_clock;
  if (method == BenchMethod::batch || method == BenchMethod::columns) return -1;
  double greatest = 0;
  Answer answer;
  for (const AnyQuery& query : queries) {
    double best = 0;
    for (int attempt = 0; attempt < 3; ++attempt) {
      const auto start = Clock::now();
      ask(method, query, separation, answer);
      report::do_not_optimize(answer);
      const double taken = std::chrono::duration<double, std::micro>(Clock::now() - start).count();
      if (attempt == 0 || taken < best) best = taken;
    }
    greatest = std::max(greatest, best);
  }
  return greatest;
}

}  // namespace

double slowest_microseconds(BenchMethod method, const std::vector<Query>& queries, const Separation& separation) {
  return slowest(method, queries, separation);
}
double slowest_microseconds(BenchMethod method, const std::vector<CurvedQuery>& queries, const Separation& separation) {
  return slowest(method, queries, separation);
}

}  // namespace touchstone::cli
