// Touchstone: do two moving elements ever touch, and when first? No tolerance, no false answer.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include <touchstone/answer.hpp>
#include <touchstone/names.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>
#include <touchstone/vector_width.hpp>

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

/// The code that answers. All methods give the same contact, times, nature and features; the weights of each are within
/// 2^-50 of the true ones. The methods differ in speed and in the code that they share.
enum class Method : std::uint8_t {
  fast,      ///< error-bounded filters, and the library's own exact arithmetic where the filters are uncertain
  exact,     ///< the library's own exact arithmetic alone
  oracle,    ///< an independent decider over CGAL's algebraic kernel: slow; shares no decision code with the others
  fast_cgal  ///< the same filters as `fast`, and CGAL (number types and algebraic kernel) where they are uncertain
};

/// "fast", "exact", "oracle", "fast-cgal".
template <>
Names names_of<Method>() noexcept;

/// Whether this build of the library has the method: oracle and fast_cgal need CGAL (TOUCHSTONE_WITH_CGAL).
bool has_method(Method method) noexcept;

/// What is asked about a query, and how it is answered. In C++20: solve(query, {.separation = {0.001}}).
struct SolveOptions {
  double t_max = 1.0;            ///< the end of the time range, 0 <= t_max <= 1
  Separation separation = {};    ///< contact is to be within this of each other; with distance 0, to touch
  Method method = Method::fast;  ///< the code that answers
  Wanted wanted = Wanted::all;   ///< what is computed of a contact; the rest is as without contact, times are NaN
};

/// The first contact of the two elements for t in [0, t_max], decided exactly: the first time at which they touch or,
/// with a separation, at which they are within that of each other.
///
/// Every finite coordinate is ordinary input: zero, subnormal and huge values too. The answer does not depend on the
/// caller's floating-point environment (rounding mode, flush-to-zero), and the environment is left unchanged. Any
/// number of threads may call it. It allocates no memory when a filter decides. Measured for ordinary contacts:
/// Wanted::contact takes five sevenths of the time of Wanted::all. Measured for degenerate ones: Wanted::time takes
/// five sixths of it.
/// @param query    the two elements and their motion
/// @param options  what is asked, and how it is answered
/// @return the answer
/// @throws InvalidQuery  for a NaN or infinite coordinate, a t_max outside [0, 1], a distance that is negative or not
///                       finite, or a value that is none of its enum's
Answer solve(const Query& query, const SolveOptions& options);

/// The same about touching in [0, 1], by Method::fast.
Answer solve(const Query& query);

/// The same for rational coordinates. When some coordinate is not a double, no filter applies: the exact level decides
/// for Method::fast and Method::exact, and CGAL for the other two.
/// @param query    the two elements and their motion
/// @param options  what is asked, and how it is answered
/// @return the answer
/// @throws InvalidQuery  also for a fraction that is not a pair of decimal integers, and a zero denominator
Answer solve(const RationalQuery& query, const SolveOptions& options);

/// The same about touching in [0, 1], by Method::fast.
Answer solve(const RationalQuery& query);

/// The same about touching in [0, t_max], for queries of every sort. A number in braces calls the function above: it
/// becomes the first member of SolveOptions, which is t_max too.
template <class AnyQuery, class Number, class = std::enable_if_t<std::is_arithmetic_v<Number>>,
          class = decltype(solve(std::declval<const AnyQuery&>(), std::declval<const SolveOptions&>()))>
Answer solve(const AnyQuery& query, Number t_max) {
  SolveOptions options;
  options.t_max = static_cast<double>(t_max);
  return solve(query, options);
}

/// The options of a batch: those of each query (SolveOptions), and how many queries are answered. `threads` and
/// `vectors` change no answer.
struct BatchOptions : SolveOptions {
  /// The number of threads, 1 to 1024; 0 takes as many as the machine has. With 1 the calling thread does all the work.
  int threads = 1;

  /// The SIMD width. Only batches in columns by Method::fast or Method::fast_cgal use it.
  VectorWidth vectors = VectorWidth::widest;

  /// A distance for each query, in place of separation.distance, which must then be 0: for elements of different
  /// thickness. Null, or a pointer to the first of separation_count doubles; the metric is separation.metric.
  const double* separations = nullptr;
  std::size_t separation_count = 0;  ///< the number of separations: that of the queries, or 0 without any
};

/// The answers to many queries, in input order.
/// @param queries  the queries, of one kind or of several
/// @param options  how they are answered
/// @return answers[i] for queries[i]
/// @throws InvalidQuery  for options without meaning, or naming the index of the first query without meaning
std::vector<Answer> solve_batch(const std::vector<Query>& queries, const BatchOptions& options = {});

/// The same into the caller's memory. When it throws, no answer is valid.
/// @param queries  a pointer to the first of `count` queries
/// @param count    the number of queries
/// @param answers  room for `count` answers; answers[i] becomes the answer to queries[i]
/// @param options  how they are answered
/// @throws InvalidQuery  for options without meaning, or naming the index of the first query without meaning
void solve_batch(const Query* queries, std::size_t count, Answer* answers, const BatchOptions& options = {});

/// The same for rational coordinates; the vectors' width has no effect.
std::vector<Answer> solve_batch(const std::vector<RationalQuery>& queries, const BatchOptions& options = {});
void solve_batch(const RationalQuery* queries, std::size_t count, Answer* answers,
                 const BatchOptions& options = {});  ///< the same into the caller's memory

/// Queries of one kind as a structure of arrays: one column of doubles for each coordinate of each corner.
struct QueryColumns {
  Kind kind = Kind::edge_edge;  ///< which elements
  std::size_t count = 0;        ///< the number of queries, and the length of each column

  /// The columns at t = 0: start[i][k][q] is coordinate k (0 x, 1 y, 2 z) of corner i of query q, 0 <= q < count.
  /// Columns of corners past corner_count(kind) are never read. No alignment is needed.
  std::array<std::array<const double*, 3>, 4> start{};

  /// The columns at t = 1, in the same order.
  std::array<std::array<const double*, 3>, 4> end{};

  /// Query q, 0 <= q < count.
  Query operator[](std::size_t q) const noexcept;
};

/// The answers to queries in columns. They equal the answers of `solve` to the same queries, and are computed faster.
/// @param queries  the columns
/// @param options  how they are answered
/// @return answers[q] for query q
/// @throws InvalidQuery  for options without meaning, or naming the index of the first query without meaning
std::vector<Answer> solve_batch(const QueryColumns& queries, const BatchOptions& options = {});

/// The same into the caller's memory. When it throws, no answer is valid.
/// @param queries  the columns
/// @param answers  room for queries.count answers; answers[q] becomes the answer to query q
/// @param options  how they are answered
/// @throws InvalidQuery  for options without meaning, or naming the index of the first query without meaning
void solve_batch(const QueryColumns& queries, Answer* answers, const BatchOptions& options = {});

/// The number of answers that each level decided.
struct LevelCounts {
  std::size_t filter = 0;   ///< answers of Level::filter
  std::size_t bracket = 0;  ///< answers of Level::bracket
  std::size_t exact = 0;    ///< answers of Level::exact
  std::size_t oracle = 0;   ///< answers of Level::oracle
};

/// Counts the levels of `answers`.
LevelCounts count_levels(const std::vector<Answer>& answers) noexcept;

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
