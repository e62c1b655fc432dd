// The queries that `touchstone bench` measures.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>

#include "cli/bench/bench.hpp"

namespace touchstone::cli {

/// Queries of one kind and source: all of them, those with contact, or those without.
struct BenchSet {
  std::string name;  ///< "simulation/edge-edge/hits"
  std::vector<Query> queries;
  std::vector<Answer> answers;
};

/// The sets of simulation-like candidates, random doubles, the bundled (degenerate) queries and the given files, in
/// this order. Empty sets are left out, and so are queries whose coordinates are not all doubles.
std::vector<BenchSet> bench_sets(const BenchOptions& options);

}  // namespace touchstone::cli
