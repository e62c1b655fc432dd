// Which test of the filters decides a query, in the order that a user gets.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/query.hpp>

#include "exact/exact.hpp"
#include "filters/filters.hpp"

namespace touchstone::tests {

/// The decision over the whole step, same_side first as `solve` does.
inline filters::Decision decision_by_filters(const Query& query) {
  if (filters::same_side(query)) return {filters::Outcome::no_contact, filters::Test::same_side};
  Answer ignored;
  return filters::decide_by_filters({query, 1, exact::coplanarity_at}, ignored);
}

inline filters::Test deciding_test(const Query& query) { return decision_by_filters(query).test; }

}  // namespace touchstone::tests
