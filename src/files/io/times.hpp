// Times and other doubles as text that survives a round trip.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace touchstone::io {

/// As printf("%a") writes it in the C locale, whatever the caller's locale: "0x1.8p-2", "0x0p+0". Finite values only.
std::string hexfloat(double value);

/// The double that `text` spells, a hexfloat ("0x1.8p-2") or a decimal ("0.375", "3.75e-1"), correctly rounded.
/// Nothing for anything else: blanks, text after the number, "nan", "inf", values beyond the doubles' range.
std::optional<double> parse_finite_double(std::string_view text) noexcept;

/// The same, except that a number beyond the doubles' range gives the zero or infinity that it rounds to.
std::optional<double> parse_rounded_double(std::string_view text) noexcept;

/// The reason why parse_finite_double refuses `text`, for a message after the text: "is no number". Empty if it does
/// not.
std::string_view fault_of_double(std::string_view text) noexcept;

/// Whether the digits alone show that `number`, which parse_finite_double reads, spells exactly a double: a hexfloat of
/// at most 53 bits, as hexfloat() writes it. False where the digits alone do not show it.
bool is_plainly_a_double(std::string_view number) noexcept;

}  // namespace touchstone::io
