// Hill climbing: from a query towards queries on which the filters are only just certain.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

#include "families/families.hpp"
#include "fuzz/any_query.hpp"

namespace touchstone::fuzz {

/// The most steps that a case's name may ask for.
constexpr std::uint64_t kMostClimbSteps = 1'000'000;

/// A walk. Each step changes one or two numbers of the query. The change stays when it brings the magnitude of
/// `filter_margin` nearer to 1, in proportion, because there the error bounds are tested. Otherwise the next step
/// starts from the same query again. Step k depends on the case and k only.
class Climb {
 public:
  explicit Climb(const families::CaseId& start);

  /// From any query. @param separation  what is asked about: filters for separations have margins of their own
  Climb(const AnyQuery& start, const families::Rng& random, const Separation& separation = {});

  /// The next query, kept or not: each of them is worth asking.
  AnyQuery next();

 private:
  double height_of(const AnyQuery& query) const;
  void step_to_zero(AnyQuery& query);

  families::Rng rng_;
  Separation separation_;
  AnyQuery current_;
  double height_;  ///< |log2 of |margin||
};

}  // namespace touchstone::fuzz
