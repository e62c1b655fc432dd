// Distances as the exact level alone compares them, without the doubles that compare_distance tries first.
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

}  // namespace touchstone::tests
