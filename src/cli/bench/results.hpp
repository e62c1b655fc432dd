// The results of `touchstone bench`, for a person and for a program.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <touchstone/solve.hpp>

#include "cli/bench/bench.hpp"
#include "cli/bench/methods.hpp"
#include "solver/ladder.hpp"

namespace touchstone::cli {

/// One method on one set.
struct BenchResult {
  std::string set;  ///< "simulation/edge-edge/hits"
  BenchMethod method = BenchMethod::floor;
  std::size_t queries = 0;   ///< that were asked
  std::size_t contacts = 0;  ///< among all of the set
  std::size_t set_size = 0;
  std::vector<double> nanoseconds;          ///< a query, one a repetition
  double ratio = 0;                         ///< of the median to the floor's median on the same set
  std::optional<double> ratio_to_straight;  ///< of curved sets: to the median of the straight twins
  double slowest_microseconds = 0;          ///< negative: not measured
  LevelCounts levels;                       ///< of this method's answers; floor has none

  /// How many queries each rung of solver::kLadder decides; only of `touchstone` on a straight set about touching.
  std::array<std::size_t, solver::kLadder.size()> rungs{};

  double median() const;
};

std::string bench_table(const std::vector<BenchResult>& results);
std::string bench_csv(const std::vector<BenchResult>& results);
std::string bench_json(const std::vector<BenchResult>& results, const BenchOptions& options);

}  // namespace touchstone::cli
