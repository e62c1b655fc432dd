// What both files on near roots need: coefficients and values as double-doubles with bounds on their errors.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

#include "numbers/doubles/bounded.hpp"
#include "numbers/integers/fixed_int.hpp"
#include "numbers/integers/small_int.hpp"

namespace touchstone::numbers {

/// x as a double-double. Limbs from the third on count as long as they reach the 106 bits of one: with a top limb of
/// one bit, the next two have 128. What is left out is below 2^-127 |x|. Each of the four sums behind the second half
/// rounds low parts, which are below 5 * 2^-53 |x|, to at most 14 * 2^-106 |x| in all; the bound is below 2^-101 |x|.
/// One limb is exact.
template <int Limbs>
BoundedPair bounded(const FixedInt<Limbs>& x) noexcept {
  constexpr double kRelative = 0x1p-101;
  const bool negative = x.sign() < 0;
  const FixedInt<Limbs> magnitude = negative ? -x : x;
  int top = Limbs - 1;
  while (top > 0 && magnitude.limb(top) == 0) --top;
  const auto half = [](std::uint64_t limb, bool high) {
    return static_cast<double>(static_cast<std::uint32_t>(high ? limb >> 32 : limb));
  };
  double unit = 1;  // of the limb
  for (int i = 0; i < top; ++i) unit *= 0x1p64;
  DoubleDouble sum = two_sum(half(magnitude.limb(top), true) * 0x1p32 * unit, half(magnitude.limb(top), false) * unit);
  for (int i = top - 1; i >= 0 && i >= top - 2; --i) {
    unit *= 0x1p-64;
    for (const bool high : {true, false}) {
      const double term = half(magnitude.limb(i), high) * (high ? 0x1p32 * unit : unit);
      sum = sum + DoubleDouble{term, 0};
    }
  }
  sum = normalised(sum);
  if (negative) sum = {-sum.high, -sum.low};
  return {sum, top == 0 ? 0 : kRelative * std::fabs(sum.high)};
}

inline BoundedPair bounded(SmallInt x) noexcept {
  const std::int64_t low = x.value() & 0xFFFFFFFF;
  return {two_sum(static_cast<double>(x.value() - low), static_cast<double>(low)), 0};
}

inline BoundedPair value_at(const BoundedPair* c, int size, const BoundedPair& t) noexcept {
  BoundedPair value = c[size - 1];
  for (int i = size - 2; i >= 0; --i) value = value * t + c[i];
  return value;
}

}  // namespace touchstone::numbers
