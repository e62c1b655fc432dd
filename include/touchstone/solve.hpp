// Touchstone: do two moving elements ever touch, and when first? No tolerance, no false answer.
// SPDX-License-Identifier: MIT
#pragma once

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

struct BatchOptions {
  double t_max = 1.0;
  Method method = Method::fast;
  int threads = 1;  ///< 1: the calling thread; 0: as many as the machine has; at most 1024. The answers are the same for any number.
};

/// The answers to many queries, in input order.
/// @throws InvalidQuery  naming the index of the first query that has no meaning
std::vector<Answer> solve_batch(const std::vector<Query>& queries, const BatchOptions& options = {});

/// The same into caller's memory: answers[i] for queries[i], 0 <= i < count. When it throws, no answer is valid.
void solve_batch(const Query* queries, std::size_t count, Answer* answers, const BatchOptions& options = {});

/// How many answers each level decided: what an array of answers cost.
struct LevelCounts {
  std::size_t filter = 0;
  std::size_t bracket = 0;
  std::size_t exact = 0;
  std::size_t oracle = 0;
};
LevelCounts count_levels(const std::vector<Answer>& answers) noexcept;

}  // namespace touchstone
