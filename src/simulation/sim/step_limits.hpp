// How long a run may be, and how short a substep.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace touchstone::sim {

// Steps: their number is exact in a double.
constexpr std::uint64_t kMostSteps = 1'000'000'000'000;

// A substep is 2^-24 of a step at least. Fractions of a step are sums of such powers of two, and exact in a double.
constexpr int kMostHalvings = 24;

}  // namespace touchstone::sim
