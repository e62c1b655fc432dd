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

}  // namespace touchstone::io
