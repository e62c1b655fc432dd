// One query set, every contestant: how often each is wrong and how long it takes.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <touchstone/solve.hpp>

#include "report/contestant.hpp"
#include "report/sets/query_set.hpp"
#include "report/time_error.hpp"

namespace touchstone::report {

inline constexpr std::array<const char*, 5> kPercentileNames{"50 %", "90 %", "99 %", "99.9 %", "slowest"};

/// The result of one contestant on one set. Every number is about the first `asked` queries of the set.
struct Result {
  Contestant contestant;
  std::size_t asked = 0;  ///< 0: it does not take this kind, and the rest has no meaning
  std::size_t contacts = 0;
  std::size_t missed = 0;
  std::size_t phantom = 0;
  std::size_t late = 0;
  std::optional<TimeError> time_error;
  std::vector<double> passes;           ///< mean microseconds a query, of each pass
  double mean = 0;                      ///< the median of the passes
  std::array<double, 5> percentiles{};  ///< microseconds of single queries
  LevelCounts levels;                   ///< of the solver's own methods

  std::size_t wrong() const noexcept { return missed + phantom + late; }
  bool has_errors() const noexcept { return wrong() > 0 || (time_error && time_error->greatest_size > 0); }
  double wrong_fraction() const noexcept { return fraction_of(wrong(), asked); }
  double missed_fraction() const noexcept { return fraction_of(missed, contacts); }
  double phantom_fraction() const noexcept { return fraction_of(phantom, asked - contacts); }
  double late_fraction() const noexcept { return fraction_of(late, contacts); }

  /// 0 when no query was asked.
  static double fraction_of(std::size_t count, std::size_t whole) noexcept {
    return whole == 0 ? 0 : static_cast<double>(count) / static_cast<double>(whole);
  }
};

struct SetResults {
  QuerySet set;
  int exponent = 0;             ///< of the varied quantity, in powers of two: the scale of the coordinates, for example
  std::vector<Result> results;  ///< one for each contestant, in their order
};

struct Effort {
  double budget = 0.2;  ///< seconds that one contestant may take for one pass over a set; it is asked fewer queries
                        ///< when that is not enough, one at least
  int passes = 5;
  double least_pass = 0.005;  ///< seconds; queries are asked again until then
  int tries = 3;              ///< of each single query; the shortest counts, which drops interrupts
  bool ours_in_full = false;  ///< the methods of the solver itself are asked the whole set, however long it takes
};

/// Called often during the work; may throw to end it.
using Pulse = std::function<void()>;

/// Fills in `set.truth` by Method::exact and measures. Contestants take turns pass by pass: a machine that gets slower
/// or busy does so for all of them.
SetResults measure(QuerySet set, const std::vector<Contestant>& contestants, const Effort& effort, const Pulse& pulse);

}  // namespace touchstone::report
