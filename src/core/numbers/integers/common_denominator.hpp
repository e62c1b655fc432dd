// Rational coordinates brought to integers, and integers freed of a common factor.
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "numbers/integers/exact_number.hpp"

namespace touchstone::numbers {

/// The fractions (numerator, denominator) times the least common multiple of their denominators: integers in the
/// fractions' proportions. Texts are decimal integers and no denominator is zero.
std::vector<Exact> over_common_denominator(const std::vector<std::pair<std::string_view, std::string_view>>& fractions);

/// Integers in the same proportions, with the same signs, without a common factor.
std::vector<Exact> without_common_factor(const std::vector<Exact>& numbers);

}  // namespace touchstone::numbers
