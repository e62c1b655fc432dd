// Touchstone: do two moving elements ever touch, and when first? No tolerance, no false answer.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>

namespace touchstone {

/// Which code answers. All give the same answer; they differ in speed and in the code they share.
enum class Method : std::uint8_t {
  fast,   ///< the cascade: error-bounded filters, exact arithmetic where they are uncertain
  exact,  ///< exact ring arithmetic alone
  oracle  ///< the independent decider over CGAL's algebraic kernel: slow, shares no decision code with the others
};

/// The first contact of the two elements for t in [0, t_max], decided exactly.
///
/// Any finite coordinates are ordinary input, zero, subnormal and huge ones included. The answer does not depend on
/// the caller's floating-point environment (rounding mode, flush-to-zero), which is left as it was. Safe to call
/// from any thread; allocates nothing when a filter decides.
/// @param t_max  end of the time range, 0 <= t_max <= 1
/// @throws InvalidQuery  for a NaN or infinite coordinate or a t_max outside [0, 1]
Answer solve(const Query& query, double t_max = 1.0);
Answer solve(const EdgeEdge& query, double t_max = 1.0);
Answer solve(const VertexFace& query, double t_max = 1.0);
Answer solve(const PointEdge& query, double t_max = 1.0);
Answer solve(const PointPoint& query, double t_max = 1.0);

/// The same by the method of choice.
Answer solve(const Query& query, Method method, double t_max = 1.0);

/// The same for rational coordinates; Method::fast goes straight to the exact level unless every coordinate is a double.
/// @throws InvalidQuery  also for a fraction that is not a pair of decimal integers or has a zero denominator
Answer solve(const RationalQuery& query, Method method = Method::fast, double t_max = 1.0);

/// Whether the two elements touch at any t in [0, t_max]; no time, and less work where the time would take some.
/// Equal to solve(query, t_max).contact. @throws InvalidQuery as `solve` does.
bool solve_any(const Query& query, double t_max = 1.0);

/// The vectors of the processor that a batch uses: several queries are looked at in one instruction.
enum class VectorWidth : std::uint8_t {
  widest,    ///< the widest of the machine it runs on
  none,      ///< one query at a time
  bits_128,  ///< two doubles: every processor
  bits_256,  ///< four, AVX2
  bits_512   ///< eight, AVX-512
};

/// Whether the machine, and the library as it was built, has vectors of this width.
bool has_vectors(VectorWidth width) noexcept;

struct BatchOptions {
  double t_max = 1.0;
  Method method = Method::fast;
  /// 1: the calling thread; 0: as many as the machine has; at most 1024. The answers are the same for any number.
  int threads = 1;
  VectorWidth vectors = VectorWidth::widest;  ///< The answers are the same for any width, bit for bit.
};

/// The answers to many queries, in input order.
/// @throws InvalidQuery  naming the index of the first query that has no meaning
std::vector<Answer> solve_batch(const std::vector<Query>& queries, const BatchOptions& options = {});

/// The same into caller's memory: answers[i] for queries[i], 0 <= i < count. When it throws, no answer is valid.
void solve_batch(const Query* queries, std::size_t count, Answer* answers, const BatchOptions& options = {});

/// Queries of one kind as a structure of arrays: a column of doubles for each coordinate of each corner.
struct QueryColumns {
  Kind kind = Kind::edge_edge;
  std::size_t count = 0;
  /// start[i][k][q] is coordinate k (0 x, 1 y, 2 z) of corner i of query q at t = 0, 0 <= q < count; `end` at t = 1.
  /// Corners past corner_count(kind) are never read. No alignment is needed.
  std::array<std::array<const double*, 3>, 4> start{};
  std::array<std::array<const double*, 3>, 4> end{};

  Query operator[](std::size_t q) const noexcept;
};

/// The answers to queries in columns: those of `solve` one by one, sooner.
/// @throws InvalidQuery  naming the index of the first query that has no meaning
std::vector<Answer> solve_batch(const QueryColumns& queries, const BatchOptions& options = {});

/// The same into caller's memory: answers[q] for query q, 0 <= q < count. When it throws, no answer is valid.
void solve_batch(const QueryColumns& queries, Answer* answers, const BatchOptions& options = {});

/// How many answers each level decided: what an array of answers cost.
struct LevelCounts {
  std::size_t filter = 0;
  std::size_t bracket = 0;
  std::size_t exact = 0;
  std::size_t oracle = 0;
};
LevelCounts count_levels(const std::vector<Answer>& answers) noexcept;

}  // namespace touchstone
