// Distances as the exact level alone tells and compares them, without the doubles that are tried first.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

#include "exact/exact.hpp"
#include "numbers/integers/limb_scratch.hpp"

namespace touchstone::tests {

/// As compare_distance, for arguments that are valid.
inline int exactly_compared(const Query& query, double t, const Separation& separation) {
  const numbers::LimbScratch scratch;
  return exact::compare_distance(query, t, separation);
}

/// As distance, for arguments that are valid.
inline Distance exact_distance(const Query& query, double t, Metric metric) {
  const numbers::LimbScratch scratch;
  return exact::distance_at(query, t, metric);
}

}  // namespace touchstone::tests
