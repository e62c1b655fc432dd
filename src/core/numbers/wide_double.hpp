// Doubles of any exponent, each with a bound on its error.
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace touchstone::numbers {

/// A number within error 2^exponent of value 2^exponent. Coordinates have 1 <= |value| < 2; whoever computes with them
/// keeps |value| + error <= 2^64.
///
/// A sum or a product is off by a relative 2^-52 of its value at most, in any rounding mode. The bound's own roundings,
/// at most 6 of terms that are not negative, lose less than a relative 2^-49 of it. What underflows, and a term that is
/// left out of a sum, are below kLeftOut: 2^64 2^kLeast, and 2^-1022.
class WideDouble {
 public:
  WideDouble() noexcept = default;  ///< 0
  explicit WideDouble(double x) noexcept {
    if (x == 0) return;
    constexpr double kSubnormal = 0x1p64;
    const bool subnormal = std::fabs(x) < 0x1p-1022;
    const auto bits = std::bit_cast<std::uint64_t>(subnormal ? kSubnormal * x : x);
    exponent_ = static_cast<long>(bits >> 52 & 0x7FF) - (subnormal ? 1023 + 64 : 1023);
    value_ = std::bit_cast<double>((bits & 0x800FFFFFFFFFFFFF) | 0x3FF0000000000000);
  }

  double value() const noexcept { return value_; }
  double error() const noexcept { return error_; }
  long exponent() const noexcept { return exponent_; }

  /// 0 when uncertain.
  int sign() const noexcept { return value_ > error_ ? 1 : value_ < -error_ ? -1 : 0; }

  /// The exponent of the value, 2^(bits() - 1) <= |value| < 2^bits(); that of 0 is below all others.
  long bits() const noexcept {
    const auto biased = static_cast<long>(std::bit_cast<std::uint64_t>(value_) >> 52 & 0x7FF);
    return value_ == 0 ? kExponentOfZero : exponent_ + biased - 1022;
  }
  /// 2^exponent.
  static WideDouble power(long exponent) noexcept { return {1, 0, exponent}; }

  friend WideDouble operator+(const WideDouble& a, const WideDouble& b) noexcept {
    return a.exponent_ >= b.exponent_ ? sum(a, b, 1, 1) : sum(b, a, 1, 1);
  }
  friend WideDouble operator-(const WideDouble& a, const WideDouble& b) noexcept {
    return a.exponent_ >= b.exponent_ ? sum(a, b, 1, -1) : sum(b, a, -1, 1);
  }
  friend WideDouble operator*(const WideDouble& a, const WideDouble& b) noexcept {
    const double value = a.value_ * b.value_;
    const double error = std::fabs(a.value_) * b.error_ + a.error_ * (std::fabs(b.value_) + b.error_);
    return {value, bound(error, value), a.exponent_ + b.exponent_};
  }
  friend WideDouble twice(WideDouble x) noexcept {
    ++x.exponent_;
    return x;
  }
  friend WideDouble half(WideDouble x) noexcept {
    --x.exponent_;
    return x;
  }

 private:
  WideDouble(double value, double error, long exponent) noexcept : value_(value), error_(error), exponent_(exponent) {}

  static WideDouble sum(const WideDouble& greater, const WideDouble& other, double sign, double sign_other) noexcept {
    const long difference = other.exponent_ - greater.exponent_;
    const double unit =
        difference < kLeast ? 0 : std::bit_cast<double>(static_cast<std::uint64_t>(1023 + difference) << 52);
    const double value = sign * greater.value_ + sign_other * unit * other.value_;
    return {value, bound(greater.error_ + unit * other.error_, value), greater.exponent_};
  }
  static double bound(double error, double value) noexcept {
    constexpr double kRounding = 0x1p-52, kLeftOut = 0x1p-880;
    return (1 + 0x1p-48) * (error + kRounding * std::fabs(value)) + kLeftOut;
  }

  static constexpr long kLeast = -960;
  static constexpr long kExponentOfZero = -(1L << 24);  // leaves room to add to it

  double value_ = 0, error_ = 0;
  long exponent_ = kExponentOfZero;
};

}  // namespace touchstone::numbers
