// Integers of one machine word whose sums and products stay in one word: the user must leave room for them. Degenerate
// input mostly has coordinates of few bits, and then this is the cheapest exact arithmetic.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

#include "numbers/integers/fixed_int.hpp"

namespace touchstone::numbers {

class SmallInt {
 public:
  SmallInt() noexcept = default;  ///< 0
  explicit SmallInt(int value) noexcept : value_(value) {}
  static SmallInt integer(std::int64_t value) noexcept {
    SmallInt result;
    result.value_ = value;
    return result;
  }

  /// x * 2^-exponent, which must be an integer below 2^63 in absolute value.
  static SmallInt scaled(double x, int exponent) noexcept {
    return integer(static_cast<std::int64_t>(FixedInt<1>::scaled(x, exponent).limb(0)));
  }

  std::int64_t value() const noexcept { return value_; }
  int sign() const noexcept { return (value_ > 0) - (value_ < 0); }
  bool is_zero() const noexcept { return value_ == 0; }

  friend SmallInt operator+(SmallInt a, SmallInt b) noexcept { return integer(a.value_ + b.value_); }
  friend SmallInt operator-(SmallInt a, SmallInt b) noexcept { return integer(a.value_ - b.value_); }
  friend SmallInt operator-(SmallInt a) noexcept { return integer(-a.value_); }
  friend SmallInt operator*(SmallInt a, SmallInt b) noexcept { return integer(a.value_ * b.value_); }

  /// The same number with more limbs.
  template <int Limbs>
  FixedInt<Limbs> widened() const noexcept {
    return FixedInt<1>::integer(value_).template widened<Limbs>();
  }

 private:
  std::int64_t value_ = 0;
};

inline int sign_of(SmallInt x) noexcept { return x.sign(); }
inline bool is_zero(SmallInt x) noexcept { return x.is_zero(); }
/// Within a relative error of 2^-53.
inline double to_double(SmallInt x) noexcept { return static_cast<double>(x.value()); }

/// a b, where the product may need more room than its factors.
template <int Limbs>
FixedInt<2 * Limbs> wide_product(const FixedInt<Limbs>& a, const FixedInt<Limbs>& b) noexcept {
  return a * b;
}
inline FixedInt<2> wide_product(SmallInt a, SmallInt b) noexcept { return a.widened<1>() * b.widened<1>(); }

}  // namespace touchstone::numbers
