// Constant directions of planes, with few bits.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>

#include "filters/step_frame.hpp"

namespace touchstone::proofs {

using DoubleVector = filters::Vector;

/// Bits of the coordinates of a direction: few first, because they make short proofs.
inline constexpr int kDirectionBits[] = {7, 20, 52};

inline constexpr DoubleVector kAxes[] = {{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}};

/// The direction with integer coordinates of at most `bits` bits in place of its own, not all of them even; nothing for
/// one that is zero or not finite.
inline std::optional<DoubleVector> rounded(const DoubleVector& direction, int bits) {
  const double largest = std::max({std::fabs(direction[0]), std::fabs(direction[1]), std::fabs(direction[2])});
  if (!(largest > 0) || !(largest < HUGE_VAL)) return std::nullopt;
  int exponent;
  std::frexp(largest, &exponent);
  DoubleVector result;
  std::uint64_t ones = 0;  // the bits of all three
  for (std::size_t k = 0; k < 3; ++k) {
    result[k] = std::nearbyint(std::ldexp(direction[k], bits - exponent));
    ones |= static_cast<std::uint64_t>(std::fabs(result[k]));
  }
  const double unit = static_cast<double>(std::uint64_t{1} << std::countr_zero(ones));
  for (std::size_t k = 0; k < 3; ++k) result[k] /= unit;
  return result;
}

/// Calls try_one with the direction rounded to few bits, then to more, until it returns true. @returns whether it did
template <class F>
bool try_rounded(const DoubleVector& direction, F&& try_one) {
  for (const int bits : kDirectionBits) {
    const auto integers = rounded(direction, bits);
    if (!integers) return false;
    if (try_one(*integers)) return true;
  }
  return false;
}

}  // namespace touchstone::proofs
