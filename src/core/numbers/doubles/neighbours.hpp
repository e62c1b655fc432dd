// The doubles beside a double.
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>

namespace touchstone::numbers {

/// The least double above x >= 0, and the greatest one below x > 0; x is finite.
inline double after(double x) noexcept { return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) + 1); }
inline double before(double x) noexcept { return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) - 1); }

}  // namespace touchstone::numbers
