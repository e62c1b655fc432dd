// Interval arithmetic whose ends are rounded outwards: each operation's result is moved by one double, which is more
// than its rounding error. Overflow gives infinite ends, and a NaN compares false.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchstone::solver {

inline double rounded_up(double x) noexcept { return std::nextafter(x, std::numeric_limits<double>::infinity()); }
inline double rounded_down(double x) noexcept { return std::nextafter(x, -std::numeric_limits<double>::infinity()); }

struct Interval {
  double low = 0, high = 0;

  Interval() noexcept = default;
  Interval(double x) noexcept : low(x), high(x) {}
  Interval(double from, double to) noexcept : low(from), high(to) {}

  /// 1, -1, or 0 where both signs are possible.
  int sign() const noexcept { return low > 0 ? 1 : high < 0 ? -1 : 0; }
  /// All numbers within a radius of one of these.
  Interval grown(double radius) const noexcept { return {rounded_down(low - radius), rounded_up(high + radius)}; }

  friend Interval operator-(const Interval& a) noexcept { return {-a.high, -a.low}; }
  friend Interval operator+(const Interval& a, const Interval& b) noexcept {
    return {rounded_down(a.low + b.low), rounded_up(a.high + b.high)};
  }
  friend Interval operator-(const Interval& a, const Interval& b) noexcept { return a + -b; }
  friend Interval operator*(const Interval& a, const Interval& b) noexcept {
    const double products[4] = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
    double least = products[0], greatest = products[0];
    for (const double x : products) {
      if (std::isnan(x)) return {x, x};
      least = std::min(least, x);
      greatest = std::max(greatest, x);
    }
    return {rounded_down(least), rounded_up(greatest)};
  }
  /// For b > 0.
  friend Interval operator/(const Interval& a, const Interval& b) noexcept {
    if (!(b.low > 0)) return {std::nan(""), std::nan("")};
    return {rounded_down(a.low / (a.low < 0 ? b.low : b.high)), rounded_up(a.high / (a.high < 0 ? b.high : b.low))};
  }
};

}  // namespace touchstone::solver
