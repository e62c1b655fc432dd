// The ways in which the shrinker changes a query.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fuzz/shrinking/shrink.hpp"

namespace touchstone::fuzz {

/// Offers one sort of simpler queries, as often as they are taken.
template <class Q>
using Move = void (*)(Shrinking<Q>&);

/// All moves. Those that change most come first.
template <class Q>
const std::vector<Move<Q>>& shrink_moves();
template <>
const std::vector<Move<Query>>& shrink_moves<Query>();
template <>
const std::vector<Move<CurvedQuery>>& shrink_moves<CurvedQuery>();

}  // namespace touchstone::fuzz
