// Numbers as text, exactly: every finite decimal and every hexfloat is a rational.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace touchstone::numbers {

/// More decimal digits than this in the numerator or the denominator are refused. The longest denominator that a double
/// needs, 2^1074, has 324.
inline constexpr std::size_t kMostWrittenDigits = 4096;

/// numerator / denominator; the denominator is positive. Decimal integers, not always in lowest terms.
struct WrittenFraction {
  std::string numerator;
  std::string denominator;
};

/// The exact value of "-12.5e-1" or "0x1.8p-2": an optional '-', digits with at most one point, and an optional
/// exponent.
/// @returns nothing for other text, and for a number with more than kMostWrittenDigits
std::optional<WrittenFraction> exact_value(std::string_view number);

/// Whether `number` spells exactly a double. False for what exact_value() does not read.
bool is_exactly_a_double(std::string_view number);

}  // namespace touchstone::numbers
