// Powers of two for the coordinates of a query: how many bits they have as integers, and what makes them of ordinary
// size.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
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

/// The same along each axis.
inline std::array<BitSpan, 3> axis_spans(const Query& query) noexcept {
  std::array<BitSpan, 3> spans;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    for (const Vec3* x : {&query.start[i], &query.end[i]}) {
      spans[0].add(x->x);
      spans[1].add(x->y);
      spans[2].add(x->z);
    }
  }
  for (BitSpan& span : spans) {
    if (span.bits() == 0) span.low = span.high = 0;
  }
  return spans;
}

/// The power of two that makes the largest of some doubles of ordinary size; 0 where it is of ordinary size already.
/// Products of ordinary size keep the double estimates of roots useful. They are exact either way.
class OrdinarySize {
 public:
  void add(double x) noexcept { largest_ = std::max(largest_, std::fabs(x)); }
  void add(const Vec3& x) noexcept {
    for (const double c : {x.x, x.y, x.z}) add(c);
  }

  int power() const noexcept {
    constexpr int kOrdinary = 200;
    int exponent = 0;
    if (largest_ > 0) std::frexp(largest_, &exponent);
    return exponent > kOrdinary || exponent < -kOrdinary ? -exponent : 0;
  }

 private:
  double largest_ = 0;
};

}  // namespace touchstone::exact
