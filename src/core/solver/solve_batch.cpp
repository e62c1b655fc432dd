// Many queries, on one thread or several: the same answers in the same order.
// SPDX-License-Identifier: MIT
#include <touchstone/curved.hpp>
#include <touchstone/error.hpp>
#include <touchstone/solve.hpp>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <functional>
#include <string>
#include <type_traits>

#include "filters/apart/same_side.hpp"
#include "filters/columns/same_side_columns.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "solver/cascade.hpp"
#include "solver/columns_of.hpp"
#include "solver/survivors.hpp"
#include "solver/validate.hpp"
#include "threads/for_each_range.hpp"

namespace touchstone {
inline namespace TOUCHSTONE_ABI {
namespace {

constexpr std::size_t kBlock = 64;  // how many queries a kernel is given at a time; a few microseconds of work

/// Whether the distance is not 0, by its bits: where the caller's environment reads subnormals as zeros, a comparison
/// would take a subnormal distance for none.
bool is_set(double distance) noexcept { return (std::bit_cast<std::uint64_t>(distance) << 1U) != 0; }

void validate_options(const BatchOptions& options) {
  threads::validate_threads(options.threads);
  solver::validate_method(options.method);
  solver::validate_wanted(options.wanted);
  solver::validate_vector_width(options.vectors);
  solver::validate_t_max(options.t_max);
  solver::validate(options.separation);
}

/// @throws InvalidQuery  for a list of separations without meaning
void validate_separations(const BatchOptions& options, std::size_t count) {
  if (options.separations == nullptr && options.separation_count == 0) return;
  if (options.separations == nullptr) {
    throw InvalidQuery("separation_count is " + std::to_string(options.separation_count) +
                       ", but separations is null; it must point to the first distance");
  }
  if (options.separation_count != count) {
    throw InvalidQuery("there are " + std::to_string(options.separation_count) + " separations for " +
                       std::to_string(count) + " queries; there must be one for each query");
  }
  if (is_set(options.separation.distance)) {
    throw InvalidQuery("there are both a separation for all queries and one for each; give one of them");
  }
  for (std::size_t i = 0; i < count; ++i) {
    try {
      solver::validate_distance(options.separations[i]);
    } catch (const InvalidQuery& error) {
      throw InvalidQuery("query " + std::to_string(i) + ": " + error.what());
    }
  }
}

/// The separation of query i.
Separation separation_of(const BatchOptions& options, std::size_t i) {
  return options.separations == nullptr ? options.separation
                                        : Separation{options.separations[i], options.separation.metric};
}

bool has_separation(const BatchOptions& options) {
  return options.separations != nullptr || is_set(options.separation.distance);
}

/// Answers queries [first, last), at most kBlock of which kernel(first, count, proved) tests at a time. Where it proves
/// nothing, answer_later(i) takes query i.
template <class Kernel, class AnswerLater>
void answer_columns(const Kernel& kernel, std::size_t first, std::size_t last, Answer* answers,
                    const AnswerLater& answer_later) {
  Answer no_contact;
  no_contact.level = Level::filter;
  std::int64_t proved[kBlock];
  for (std::size_t begin = first; begin < last; begin += kBlock) {
    const std::size_t size = std::min(kBlock, last - begin);
    kernel(begin, size, proved);
    for (std::size_t i = 0; i < size; ++i) {
      if (proved[i] != 0) {
        answers[begin + i] = no_contact;
      } else {
        answer_later(begin + i);
      }
    }
  }
}

/// Answers all queries, query_at(i) being query i; answer_range as for for_each_range, and it may throw InvalidQuery.
/// @throws InvalidQuery  naming the index of the first query that has no meaning
template <class QueryAt, class AnswerRange>
void answer_all(std::size_t count, const BatchOptions& options, const QueryAt& query_at,
                const AnswerRange& answer_range) {
  const numbers::DefaultFloatEnvironment environment;
  validate_options(options);
  validate_separations(options, count);
  try {
    threads::for_each_range(count, kBlock, options.threads, std::cref(answer_range));  // allocates nothing
  } catch (const InvalidQuery&) {
    for (std::size_t i = 0; i < count; ++i) {
      try {
        solver::validate(query_at(i), options.t_max);
      } catch (const InvalidQuery& error) {
        throw InvalidQuery("query " + std::to_string(i) + ": " + error.what());
      }
    }
    throw;
  }
}

template <class AnyQuery>
void solve_list(const AnyQuery* queries, std::size_t count, Answer* answers, const BatchOptions& options) {
  const auto query_at = [queries](std::size_t i) -> const AnyQuery& { return queries[i]; };
  const bool with_separation = has_separation(options);
  answer_all(count, options, query_at, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      if constexpr (!std::is_same_v<AnyQuery, RationalQuery>) {  // which have no shorter way without a separation
        if (!with_separation) {
          answers[i] = solver::answer(queries[i], options.method, options.t_max, options.wanted);
          continue;
        }
      }
      answers[i] = solver::answer(queries[i], separation_of(options, i), options.method, options.t_max, options.wanted);
    }
  });
}

template <class AnyQuery>
std::vector<Answer> solve_list(const std::vector<AnyQuery>& queries, const BatchOptions& options) {
  std::vector<Answer> answers(queries.size());
  solve_list(queries.data(), queries.size(), answers.data(), options);
  return answers;
}

}  // namespace

bool has_vectors(VectorWidth width) noexcept { return filters::has_kernel(width); }

Query QueryColumns::operator[](std::size_t q) const noexcept {
  Query query;
  query.kind = kind;
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    query.start[i] = {start[i][0][q], start[i][1][q], start[i][2][q]};
    query.end[i] = {end[i][0][q], end[i][1][q], end[i][2][q]};
  }
  return query;
}

void solve_batch(const Query* queries, std::size_t count, Answer* answers, const BatchOptions& options) {
  solve_list(queries, count, answers, options);
}

void solve_batch(const QueryColumns& queries, Answer* answers, const BatchOptions& options) {
  solver::validate_kind(queries.kind);
  const auto query_at = [&queries](std::size_t i) { return queries[i]; };
  const bool with_separation = has_separation(options);
  const auto answer_one = [&](std::size_t i) {
    return with_separation
               ? solver::answer(queries[i], separation_of(options, i), options.method, options.t_max, options.wanted)
               : solver::answer(queries[i], options.method, options.t_max, options.wanted);
  };
  const filters::Columns columns = solver::columns_of(queries);
  const bool filters_first = options.method == Method::fast || options.method == Method::fast_cgal;
  const bool with_kernel = filters_first && filters::has_cubic(queries.kind);
  answer_all(queries.count, options, query_at, [&](std::size_t first, std::size_t last) {
    if (!with_kernel) {
      for (std::size_t i = first; i < last; ++i) answers[i] = answer_one(i);
    } else if (with_separation) {
      const auto kernel = filters::clearance_kernel(queries.kind, options.separation.metric, options.vectors);
      double same[kBlock];
      std::fill_n(same, kBlock, options.separation.distance);
      const auto prove = [&](std::size_t begin, std::size_t size, std::int64_t* proved) {
        kernel(columns, options.separations == nullptr ? same : options.separations + begin, begin, size, proved);
      };
      answer_columns(prove, first, last, answers, [&](std::size_t i) { answers[i] = answer_one(i); });
    } else {
      const auto kernel = filters::same_side_kernel(queries.kind, options.vectors);
      const auto prove = [&](std::size_t begin, std::size_t size, std::int64_t* proved) {
        kernel(columns, begin, size, proved);
      };
      solver::Survivors survivors(queries, columns, options, answers);
      answer_columns(prove, first, last, answers, [&](std::size_t i) { survivors.add(i); });
      survivors.answer_waiting();
    }
  });
}

void solve_batch(const RationalQuery* queries, std::size_t count, Answer* answers, const BatchOptions& options) {
  solve_list(queries, count, answers, options);
}

void solve_batch(const CurvedQuery* queries, std::size_t count, Answer* answers, const BatchOptions& options) {
  solve_list(queries, count, answers, options);
}

std::vector<Answer> solve_batch(const std::vector<Query>& queries, const BatchOptions& options) {
  return solve_list(queries, options);
}

std::vector<Answer> solve_batch(const std::vector<RationalQuery>& queries, const BatchOptions& options) {
  return solve_list(queries, options);
}

std::vector<Answer> solve_batch(const std::vector<CurvedQuery>& queries, const BatchOptions& options) {
  return solve_list(queries, options);
}

std::vector<Answer> solve_batch(const QueryColumns& queries, const BatchOptions& options) {
  std::vector<Answer> answers(queries.count);
  solve_batch(queries, answers.data(), options);
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

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
