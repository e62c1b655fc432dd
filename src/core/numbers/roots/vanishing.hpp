// Two quaternions that a motion goes between on a straight line: where it is zero, and which way round it turns.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

namespace touchstone::numbers {

/// The time at which (1 - t) a + t b is zero for 0 <= t <= 1, rounded. Whether there is one is decided exactly.
/// @param a, b  finite and not zero
/// @return nothing when it is never zero: unless b is a times a negative number
std::optional<double> zero_between(const std::array<double, 4>& a, const std::array<double, 4>& b);

/// The sign of a . b, exactly; 1 where a component is not finite.
int sign_of_dot(const std::array<double, 4>& a, const std::array<double, 4>& b);

}  // namespace touchstone::numbers
