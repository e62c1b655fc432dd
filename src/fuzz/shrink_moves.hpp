// The ways in which the shrinker changes a query.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fuzz/shrink.hpp"

namespace touchstone::fuzz {

/// Offers one sort of simpler queries, as often as they are taken.
using Move = void (*)(Shrinking&);

/// All moves. Those that change most come first.
const std::vector<Move>& shrink_moves();

}  // namespace touchstone::fuzz
