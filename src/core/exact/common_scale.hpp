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

/// Over a query's coordinates along one axis; no bits where all are zero. Let all be below 2^high. Where all are
/// multiples of 2^(high - 62), as most are where this is asked, they are integers of 62 bits in that unit: it is less
/// work to look at these integers than at each significand.
inline BitSpan span_along(const Query& query, double Vec3::*axis) noexcept {
  const std::size_t count = corner_count(query.kind);
  double largest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    largest = std::max({largest, std::fabs(query.start[i].*axis), std::fabs(query.end[i].*axis)});
  }
  BitSpan span = {0, 0};
  if (largest == 0) return span;
  constexpr int kBits = 62;
  constexpr double kLeast = 0x1p-900, kGreatest = 0x1p900;  // so that both powers are ordinary
  if (largest > kLeast && largest < kGreatest) {
    const int high = static_cast<int>(std::bit_cast<std::uint64_t>(largest) >> 52) - 1022;  // largest < 2^high
    const auto power = [](int exponent) {
      return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52);
    };
    const double unit = power(high - kBits), per_unit = power(kBits - high);
    std::int64_t any = 0;
    bool whole = true;
    for (std::size_t i = 0; i < count; ++i) {
      for (const double x : {query.start[i].*axis, query.end[i].*axis}) {
        const auto integer = static_cast<std::int64_t>(x * per_unit);
        any |= integer;
        whole = whole && static_cast<double>(integer) * unit == x;  // not where the product underflows to 0, either
      }
    }
    if (whole) return {high - kBits + std::countr_zero(static_cast<std::uint64_t>(any)), high};
  }
  span = {};
  for (std::size_t i = 0; i < count; ++i) {
    span.add(query.start[i].*axis);
    span.add(query.end[i].*axis);
  }
  return span;
}

/// The same along each axis.
inline std::array<BitSpan, 3> axis_spans(const Query& query) noexcept {
  return {span_along(query, &Vec3::x), span_along(query, &Vec3::y), span_along(query, &Vec3::z)};
}

/// Over all axes; no bits where there are none along any.
inline BitSpan common_span(const std::array<BitSpan, 3>& axes) noexcept {
  BitSpan span;
  for (const BitSpan& axis : axes) {
    if (axis.bits() > 0) span = {std::min(span.low, axis.low), std::max(span.high, axis.high)};
  }
  return span.bits() == 0 ? BitSpan{0, 0} : span;
}

inline BitSpan coordinate_span(const Query& query) noexcept { return common_span(axis_spans(query)); }

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
