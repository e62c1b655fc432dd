// Hill climbing: from a family's query towards those on which the filters are only just certain.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <touchstone/query.hpp>

#include "families/families.hpp"

namespace touchstone::fuzz {

/// The most steps that a case's name may ask for.
constexpr std::uint64_t kMostClimbSteps = 1'000'000;

/// A walk whose every step changes a coordinate or two. The change stays when it brings the magnitude of
/// `filter_margin` nearer to 1, in proportion, where the error bounds are put to the test; else the next step starts
/// from where this one did. Step k depends on the case and k only.
class Climb {
 public:
  explicit Climb(const families::CaseId& start);

  /// From any query.
  Climb(const Query& start, const families::Rng& random);

  /// The next query looked at, kept or not: each is worth asking.
  Query next();

 private:
  families::Rng rng_;
  Query current_;
  double height_;  ///< |log2 of |margin||
};

}  // namespace touchstone::fuzz
