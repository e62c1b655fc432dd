// What narrowing a gap and following an answer across it both need.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace touchstone::exact {

constexpr int kTimeBits = 6;         // f: where V_0 has a root near the contact, its denominator is at most 2^f
constexpr int kMostVolumeBits = 40;  // of v: V_0 at t0 and its derivatives, times 2^(3 f + 3), fit one word
constexpr double kLeastVolume = 4;   // v is at least that
constexpr double kQuadraticNorm = 2;
constexpr double kSlack = 1 + 0x1p-20;  // for the rounding of bounds

/// The least n with x <= 2^n, for x >= 1; or one more.
inline int bits_of(double x) noexcept { return std::ilogb(x) + 1; }

}  // namespace touchstone::exact
