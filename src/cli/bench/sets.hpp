// The queries that `touchstone bench` measures.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <touchstone/answer.hpp>
#include <touchstone/curved_query.hpp>
#include <touchstone/query.hpp>

#include "cli/bench/bench.hpp"

namespace touchstone::cli {

/// Queries of one kind and source: all of them, those with contact, or those without.
struct BenchSet {
  std::string name;  ///< "simulation/edge-edge/hits"
  std::vector<Query> queries;
  std::vector<CurvedQuery> curved;  ///< of curved motion; `queries` are then their straight twins, see the report layer
  std::vector<Answer> answers;      ///< to the curved queries, if there are any

  bool is_curved() const noexcept { return !curved.empty(); }
};

/// The sets of simulation-like candidates, random doubles, the bundled (degenerate) queries and the given files, in
/// this order; the scenes along the axes, as they are and turned; then those of curved motion: pairs of the scenes
/// link-chain and nut-and-bolt, the bundled ones, and those of the given files. Empty sets are left out, and so are
/// queries whose coordinates are not all doubles, or those of their twins.
/// @param is_selected  whether the sets of a source are; scenes along the axes and of bodies are only then made
std::vector<BenchSet> bench_sets(const BenchOptions& options,
                                 const std::function<bool(const std::string&)>& is_selected);

}  // namespace touchstone::cli
