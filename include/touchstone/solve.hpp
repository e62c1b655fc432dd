// Touchstone: do two moving elements ever touch, and when first? No tolerance, no false answer.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>
#include <touchstone/vector_width.hpp>

namespace touchstone {

/// The code that answers. All methods give the same contact, times, nature and features; the weights of each are within
/// 2^-50 of the true ones. The methods differ in speed and in the code that they share.
enum class Method : std::uint8_t {
  fast,      ///< error-bounded filters, and the library's own exact arithmetic where the filters are uncertain
  exact,     ///< the library's own exact arithmetic alone
  oracle,    ///< an independent decider over CGAL's algebraic kernel: slow; shares no decision code with the others
  fast_cgal  ///< the same filters as `fast`, and CGAL (number types and algebraic kernel) where they are uncertain
};

/// The first contact of the two elements for t in [0, t_max], decided exactly, by Method::fast.
///
/// Every finite coordinate is ordinary input: zero, subnormal and huge values too. The answer does not depend on the
/// caller's floating-point environment (rounding mode, flush-to-zero), and the environment is left unchanged. Any
/// number of threads may call it. It allocates no memory when a filter decides.
/// @param query  the two elements and their motion
/// @param t_max  the end of the time range, 0 <= t_max <= 1
/// @return the answer
/// @throws InvalidQuery  for a NaN or infinite coordinate or a t_max outside [0, 1]
Answer solve(const Query& query, double t_max = 1.0);

/// The same for an edge-edge query.
Answer solve(const EdgeEdge& query, double t_max = 1.0);

/// The same for a vertex-face query.
Answer solve(const VertexFace& query, double t_max = 1.0);

/// The same for a point-edge query.
Answer solve(const PointEdge& query, double t_max = 1.0);

/// The same for a point-point query.
Answer solve(const PointPoint& query, double t_max = 1.0);

/// The same by the method of your choice.
/// @throws InvalidQuery  also for a value that is none of Method's
Answer solve(const Query& query, Method method, double t_max = 1.0);

/// The same for rational coordinates, by Method::fast. When some coordinate is not a double, no filter applies and the
/// exact level decides.
/// @param query  the two elements and their motion
/// @param t_max  the end of the time range, 0 <= t_max <= 1
/// @return the answer
/// @throws InvalidQuery  for a fraction that is not a pair of decimal integers, a zero denominator, or a t_max outside
///                       [0, 1]
Answer solve(const RationalQuery& query, double t_max = 1.0);

/// The same for rational coordinates, by the method of your choice. When some coordinate is not a double, the exact
/// level decides for Method::fast and Method::exact, and CGAL for the other two.
/// @throws InvalidQuery  also for a value that is none of Method's
Answer solve(const RationalQuery& query, Method method, double t_max = 1.0);

/// The first time in [0, t_max] at which the two elements are within a separation of each other, decided exactly, by
/// Method::fast. With distance 0 it is solve(query, t_max).
/// @param query       the two elements and their motion
/// @param separation  the distance that they are to keep, and its metric
/// @param t_max       the end of the time range, 0 <= t_max <= 1
/// @return the answer
/// @throws InvalidQuery  for a NaN or infinite coordinate, a t_max outside [0, 1], a distance that is negative or not
///                       finite, or an unknown metric
Answer solve(const Query& query, const Separation& separation, double t_max = 1.0);

/// The same by the method of your choice.
Answer solve(const Query& query, const Separation& separation, Method method, double t_max = 1.0);

/// The same for rational coordinates, by Method::fast.
Answer solve(const RationalQuery& query, const Separation& separation, double t_max = 1.0);

/// The same for rational coordinates, by the method of your choice.
Answer solve(const RationalQuery& query, const Separation& separation, Method method, double t_max = 1.0);

/// The same as solve(query, t_max), without what is not wanted of a contact. Measured: for degenerate contacts the time
/// alone takes five sixths of the time of all; for ordinary ones it takes as long as all, and the contact alone takes
/// five sevenths.
/// @param query   the two elements and their motion
/// @param wanted  what is computed
/// @param t_max   the end of the time range, 0 <= t_max <= 1
/// @return the answer; what is not wanted is as without contact, except that unwanted times are NaN
/// @throws InvalidQuery  as solve(query, t_max); also for a value that is none of Wanted's
Answer solve(const Query& query, Wanted wanted, double t_max = 1.0);

/// The same as solve(query, separation, t_max), without what is not wanted of a contact.
Answer solve(const Query& query, const Separation& separation, Wanted wanted, double t_max = 1.0);

/// Whether the two elements touch at any t in [0, t_max]: the `contact` of solve(query, t_max). It is cheaper than
/// `solve`, because it does not compute the time.
/// @param query  the two elements and their motion
/// @param t_max  the end of the time range, 0 <= t_max <= 1
/// @return whether they touch
/// @throws InvalidQuery  for a NaN or infinite coordinate or a t_max outside [0, 1]
bool solve_any(const Query& query, double t_max = 1.0);

/// Whether the two elements are within a separation of each other at any t in [0, t_max]: the `contact` of
/// solve(query, separation, t_max).
/// @param query       the two elements and their motion
/// @param separation  the distance that they are to keep, and its metric
/// @param t_max       the end of the time range, 0 <= t_max <= 1
/// @return whether they come so near
/// @throws InvalidQuery  as solve(query, separation, t_max)
bool solve_any(const Query& query, const Separation& separation, double t_max = 1.0);

/// A bare number in braces, solve(query, {0.001}), would be t_max. For a separation write Separation{0.001}.
/// @param query  the two elements and their motion
/// @param bare   a number without a name
/// @param t_max  the end of the time range
template <class AnyQuery>
Answer solve(const AnyQuery& query, std::initializer_list<double> bare, double t_max = 1.0) = delete;

/// The same for solve_any(query, {0.001}).
/// @param query  the two elements and their motion
/// @param bare   a number without a name
/// @param t_max  the end of the time range
template <class AnyQuery>
bool solve_any(const AnyQuery& query, std::initializer_list<double> bare, double t_max = 1.0) = delete;

/// The options of a batch. `threads` and `vectors` change no answer.
struct BatchOptions {
  double t_max = 1.0;            ///< the end of the time range of every query, 0 <= t_max <= 1
  Method method = Method::fast;  ///< the code that answers

  /// The number of threads, 1 to 1024; 0 takes as many as the machine has. With 1 the calling thread does all the work.
  int threads = 1;

  /// The SIMD width. Only batches in columns by Method::fast or Method::fast_cgal use it.
  VectorWidth vectors = VectorWidth::widest;

  /// The separation of every query. It changes the answers.
  Separation separation = {};

  /// A distance for each query, in place of separation.distance, which must then be 0: for elements of different
  /// thickness. Null, or the first of distance_count doubles; the metric is separation.metric.
  const double* distances = nullptr;
  std::size_t distance_count = 0;  ///< the number of distances: that of the queries, or 0 without distances

  /// What is computed of contacts. The rest of each answer is as without contact; unwanted times are NaN.
  Wanted wanted = Wanted::all;
};

/// The answers to many queries, in input order.
/// @param queries  the queries, of one kind or of several
/// @param options  how they are answered
/// @return answers[i] for queries[i]
/// @throws InvalidQuery  for options without meaning, or naming the index of the first query without meaning
std::vector<Answer> solve_batch(const std::vector<Query>& queries, const BatchOptions& options = {});

/// The same into the caller's memory. When it throws, no answer is valid.
/// @param queries  the first of `count` queries
/// @param count    the number of queries
/// @param answers  room for `count` answers; answers[i] becomes the answer to queries[i]
/// @param options  how they are answered
/// @throws InvalidQuery  for options without meaning, or naming the index of the first query without meaning
void solve_batch(const Query* queries, std::size_t count, Answer* answers, const BatchOptions& options = {});

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

}  // namespace touchstone
