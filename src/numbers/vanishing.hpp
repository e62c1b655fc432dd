// Where a vector that moves on a straight line is zero.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

namespace touchstone::numbers {

/// The time at which (1 - t) a + t b is zero for 0 <= t <= 1, rounded. Whether there is one is decided exactly.
/// @param a, b  finite and not zero
/// @return nothing when it is never zero: unless b is a times a negative number
std::optional<double> zero_between(const std::array<double, 4>& a, const std::array<double, 4>& b);

}  // namespace touchstone::numbers
