// How many bits the coordinates of a query have as integers over a common power of two. SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

#include <touchstone/query.hpp>

namespace touchstone::exact {

/// x is an integer multiple of 2^low, and |x| < 2^(low + bits).
struct BitSpan {
  int low = std::numeric_limits<int>::max();
  int high = std::numeric_limits<int>::min();

  int bits() const noexcept { return high > low ? high - low : 0; }

  void add(double x) noexcept {
    const auto pattern = std::bit_cast<std::uint64_t>(x);
    const std::uint64_t fraction = pattern & 0x000FFFFFFFFFFFFF;
    const int biased = static_cast<int>(pattern >> 52) & 0x7FF;
    const std::uint64_t significand = biased == 0 ? fraction : fraction | 0x0010000000000000;
    if (significand == 0) return;
    const int exponent = (biased == 0 ? 1 : biased) - 1075;
    low = std::min(low, exponent + std::countr_zero(significand));
    high = std::max(high, exponent + static_cast<int>(std::bit_width(significand)));
  }
};

/// Over all coordinates of a query; no bits when all are zero.
inline BitSpan coordinate_span(const Query& query) noexcept {
  BitSpan span;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    for (const Vec3* x : {&query.start[i], &query.end[i]}) {
      span.add(x->x);
      span.add(x->y);
      span.add(x->z);
    }
  }
  if (span.bits() == 0) span.low = span.high = 0;
  return span;
}

}  // namespace touchstone::exact
