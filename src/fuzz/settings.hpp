// The settings of one run of the engine.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <touchstone/query.hpp>
#include <touchstone/solve.hpp>

#include "families/families.hpp"
#include "fuzz/auditing/claims.hpp"
#include "fuzz/case_name.hpp"
#include "fuzz/judging/failure.hpp"

namespace touchstone::fuzz {

struct Settings {
  std::vector<AnyQuery> given;             ///< unless empty: each of these is asked once, and no family
  std::vector<families::Family> families;  ///< empty: all of straight queries, or of curved ones
  bool curved = false;                     ///< which of the two
  std::vector<Kind> kinds;                 ///< empty: all; kinds that the solver does not support are left out
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> cases;  ///< the most queries of families, or given ones, to start from
  std::optional<double> seconds;       ///< the longest time to search, from when the first thread has its solver
  std::uint64_t climb = 0;             ///< steps of hill climbing from each of them; each step is asked as well
  int threads = 1;                     ///< at least 1; with `cases` and no `seconds` no result depends on it
  Separation separation = {};          ///< what every query asks about; the solvers must have been made for the same
  bool own_separations = false;        ///< each query has a distance of its own instead; only the metric is for all
  Method judge = Method::exact;
  Allowance allowance;
  std::optional<Claims> claims;          ///< of the solver: the nearest straight query that it claims is asked, or none
  std::size_t most_findings = 0;         ///< 0: all
  std::uint64_t shrink_tries = 20'000;   ///< for each finding; 0: examples stay as they were found
  std::optional<double> shrink_seconds;  ///< for all findings together; nothing: no limit
};

/// What the names of this run's cases refer to. The settings must outlive it.
inline CaseSource case_source(const Settings& settings) {
  return {settings.given, settings.separation, settings.own_separations, settings.claims ? &*settings.claims : nullptr};
}

}  // namespace touchstone::fuzz
