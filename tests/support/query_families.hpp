// The query families and the seeded generator behind them, by the names that the tests use.
// SPDX-License-Identifier: MIT
#pragma once

#include "families/families.hpp"
#include "families/linear_motion.hpp"
#include "seeded/rng.hpp"

namespace touchstone::tests {

using namespace families;
using seeded::splitmix64;

}  // namespace touchstone::tests
