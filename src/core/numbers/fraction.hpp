// Rational coordinates as text, and the doubles that some of them are.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

namespace touchstone::numbers {

/// Whether `text` is an optional '-' followed by one or more decimal digits.
bool is_decimal_integer(std::string_view text) noexcept;

/// The double whose exact value is numerator/denominator, or nothing when no double has that value.
/// Both must be decimal integers of any length and the denominator not zero (checked: returns nothing otherwise).
/// Fast when both fit in 64 bits and the denominator is a power of two.
std::optional<double> exact_double(std::string_view numerator, std::string_view denominator);

}  // namespace touchstone::numbers
