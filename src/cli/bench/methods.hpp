// The methods that `touchstone bench` compares: each is a pass over a set of queries.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include <touchstone/answer.hpp>
#include <touchstone/curved_query.hpp>
#include <touchstone/query.hpp>
#include <touchstone/solve.hpp>

namespace touchstone::cli {

enum class BenchMethod : std::uint8_t {
  floor,              ///< reads the query and computes V's four Bernstein coefficients in doubles; decides nothing
  straight,           ///< solve of the straight twins, for curved queries only
  touchstone,         ///< solve
  contact,            ///< solve with Wanted::contact
  time,               ///< solve with Wanted::time
  batch,              ///< solve_batch on one thread
  columns,            ///< the same with the coordinates in columns
  cgal,               ///< solve with Method::fast_cgal
  exact,              ///< solve with Method::exact
  oracle,             ///< solve with Method::oracle
  prove,              ///< solve, and the text of the proof of its answer
  thick_polynomial,   ///< the baseline of that name, for a Euclidean separation > 0
  thick_advancement,  ///< the same
};
inline constexpr std::array<BenchMethod, 13> kBenchMethods{BenchMethod::floor,
                                                           BenchMethod::straight,
                                                           BenchMethod::touchstone,
                                                           BenchMethod::contact,
                                                           BenchMethod::time,
                                                           BenchMethod::batch,
                                                           BenchMethod::columns,
                                                           BenchMethod::cgal,
                                                           BenchMethod::exact,
                                                           BenchMethod::oracle,
                                                           BenchMethod::prove,
                                                           BenchMethod::thick_polynomial,
                                                           BenchMethod::thick_advancement};

/// Whether the method is a baseline, whose answers have neither a level nor a guarantee.
constexpr bool is_baseline(BenchMethod method) noexcept {
  return method == BenchMethod::thick_polynomial || method == BenchMethod::thick_advancement;
}

/// Whether the method is asked straight queries, also in place of curved ones, as their twins.
constexpr bool is_of_straight(BenchMethod method) noexcept {
  return method == BenchMethod::floor || method == BenchMethod::straight;
}

/// Whether the method answers queries with this separation, straight or curved.
bool takes(BenchMethod method, bool curved, const Separation& separation) noexcept;

std::string_view bench_method_name(
    BenchMethod method) noexcept;  ///< "touchstone_batch" for batch, "touchstone_cgal" for cgal

/// The most queries of a set that a method gets. A slow method gets a few, spread evenly over the set.
std::size_t most_queries(BenchMethod method) noexcept;

/// Every n-th query, such that there are at most `most`.
template <class AnyQuery>
std::vector<AnyQuery> spread(const std::vector<AnyQuery>& queries, std::size_t most) {
  std::vector<AnyQuery> some;
  const std::size_t step = std::max<std::size_t>(1, (queries.size() + most - 1) / most);
  for (std::size_t i = 0; i < queries.size(); i += step) some.push_back(queries[i]);
  return some;
}

/// Asks every query once. `columns` holds the same queries, for the method that wants them so; `answers` has room for
/// the answers.
void ask_all(BenchMethod method, const std::vector<Query>& queries, const QueryColumns& columns,
             const Separation& separation, std::vector<Answer>& answers);

/// The same for curved queries.
void ask_all(BenchMethod method, const std::vector<CurvedQuery>& queries, const Separation& separation,
             std::vector<Answer>& answers);

/// Microseconds that the slowest query takes, the clock's own time included: each gets three tries and the shortest
/// counts, which drops interrupts. Negative for batch and columns, which have no single query.
double slowest_microseconds(BenchMethod method, const std::vector<Query>& queries, const Separation& separation);
double slowest_microseconds(BenchMethod method, const std::vector<CurvedQuery>& queries, const Separation& separation);

}  // namespace touchstone::cli
