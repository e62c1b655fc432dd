// Many queries, on one thread or several: the same answers in the same order.
// SPDX-License-Identifier: MIT
#include <touchstone/error.hpp>
#include <touchstone/solve.hpp>

#include <string>

#include "numbers/float_environment.hpp"
#include "solver/cascade.hpp"
#include "solver/validate.hpp"

#ifdef TOUCHSTONE_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace touchstone {
namespace {

constexpr int kMaxThreads = 1024;

void validate_batch(const Query* queries, std::size_t count, const BatchOptions& options) {
  if (options.threads < 0 || options.threads > kMaxThreads) {
    throw InvalidQuery("threads is " + std::to_string(options.threads) + "; it must be in [0, " +
                       std::to_string(kMaxThreads) + "], 0 for as many as the machine has");
  }
  solver::validate_t_max(options.t_max);
  for (std::size_t i = 0; i < count; ++i) {
    try {
      solver::validate(queries[i].kind, queries[i].start.data(), queries[i].end.data(), options.t_max);
    } catch (const InvalidQuery& error) {
      throw InvalidQuery("query " + std::to_string(i) + ": " + error.what());
    }
  }
}

void answer_range(const Query* queries, std::size_t first, std::size_t last, Answer* answers, const BatchOptions& options) {
  const numbers::DefaultFloatEnvironment environment;  // each thread has its own
  for (std::size_t i = first; i < last; ++i) answers[i] = solver::answer(queries[i], options.method, options.t_max);
}

}  // namespace

void solve_batch(const Query* queries, std::size_t count, Answer* answers, const BatchOptions& options) {
  {
    const numbers::DefaultFloatEnvironment environment;
    validate_batch(queries, count, options);
  }
#ifdef TOUCHSTONE_WITH_TBB
  const int threads = options.threads == 0 ? tbb::info::default_concurrency() : options.threads;
  if (threads > 1) {
    constexpr std::size_t kGrain = 64;  // a few microseconds of work when filters decide
    tbb::task_arena arena(threads);
    arena.execute([&] {
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, kGrain), [&](const tbb::blocked_range<std::size_t>& range) {
        answer_range(queries, range.begin(), range.end(), answers, options);
      });
    });
    return;
  }
#endif
  answer_range(queries, 0, count, answers, options);
}

std::vector<Answer> solve_batch(const std::vector<Query>& queries, const BatchOptions& options) {
  std::vector<Answer> answers(queries.size());
  solve_batch(queries.data(), queries.size(), answers.data(), options);
  return answers;
}

LevelCounts count_levels(const std::vector<Answer>& answers) noexcept {
  LevelCounts counts;
  for (const Answer& answer : answers) {
    switch (answer.level) {
      case Level::filter: ++counts.filter; break;
      case Level::bracket: ++counts.bracket; break;
      case Level::exact: ++counts.exact; break;
      case Level::oracle: ++counts.oracle; break;
    }
  }
  return counts;
}

}  // namespace touchstone
