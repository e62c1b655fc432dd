// An order that depends on a seed alone.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "seeded/rng.hpp"

namespace touchstone::seeded {

/// Puts things into an order that depends on the seed alone, so that the first n are a fair sample.
template <class Thing>
void shuffle(std::vector<Thing>& things, std::uint64_t seed) {
  Rng random(seed);
  for (std::size_t i = things.size(); i > 1; --i) std::swap(things[i - 1], things[random.below(i)]);
}

}  // namespace touchstone::seeded
