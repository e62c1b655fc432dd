// SPDX-License-Identifier: MIT
#include <tight_inclusion/interval.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <touchstone/error.hpp>

namespace ticcd {

namespace {

/// The finest denominator of a NumCCD made from a double, 2^62: twice a number in [0, 1] still fits into 64 bits.
constexpr int kFinestPower = 62;

constexpr std::uint64_t kOne = 1;

/// The same number with the least denominator.
NumCCD reduced(NumCCD number) {
  if (number.numerator == 0) return {0, 0};
  while (number.denom_power > 0 && (number.numerator & kOne) == 0) {
    number.numerator >>= 1;
    --number.denom_power;
  }
  return number;
}

}  // namespace

std::uint64_t power(const std::uint64_t a, const std::uint8_t b) {
  if (a == 0) return 0;
  if (b > 63 || (a << b) >> b != a) {
    throw touchstone::InvalidQuery(std::to_string(a) + " times 2^" + std::to_string(b) + " is 2^64 or more");
  }
  return a << b;
}

std::uint8_t reduction(const std::uint64_t n, std::uint64_t& result) {
  std::uint8_t t = 0;
  result = n;
  while (result != 0 && (result & kOne) == 0) {
    result >>= 1;
    ++t;
  }
  return t;
}

NumCCD::NumCCD(Scalar x) {
  if (!(x >= 0 && x <= 1)) {
    throw touchstone::InvalidQuery("a parameter is " + std::to_string(x) + "; it must be in [0, 1]");
  }
  // Multiplying by a power of two is exact, and no product is greater than 2^62.
  *this = reduced({static_cast<std::uint64_t>(std::ceil(std::ldexp(x, kFinestPower))), kFinestPower});
}

Scalar NumCCD::value() const { return std::ldexp(static_cast<Scalar>(numerator), -static_cast<int>(denom_power)); }

NumCCD NumCCD::operator+(const NumCCD& other) const {
  const NumCCD a = reduced(*this), b = reduced(other);
  const std::uint8_t finer = std::max(a.denom_power, b.denom_power);
  const std::uint64_t k = power(a.numerator, static_cast<std::uint8_t>(finer - a.denom_power));
  const std::uint64_t l = power(b.numerator, static_cast<std::uint8_t>(finer - b.denom_power));
  if (k + l >= k) return reduced({k + l, finer});
  // The sum has 65 bits. It fits when its last bit is a zero that the denominator can give up.
  if (((k + l) & kOne) != 0 || finer == 0) {
    throw touchstone::InvalidQuery("the numerator of the sum is 2^64 or more");
  }
  return reduced({(k >> 1) + (l >> 1) + (k & l & kOne), static_cast<std::uint8_t>(finer - 1)});
}

bool NumCCD::operator<(const NumCCD& other) const {
  // k / 2^n < k' / 2^(n + d)  exactly when  k < the least integer that is not less than k' / 2^d;
  // k / 2^(n + d) < k' / 2^n  exactly when  the greatest integer that is not greater than k / 2^d is less than k'.
  const int d = static_cast<int>(other.denom_power) - static_cast<int>(denom_power);
  if (d >= 64) return numerator == 0 && other.numerator != 0;
  if (d <= -64) return other.numerator != 0;
  if (d >= 0) {
    const std::uint64_t rest = other.numerator & ((kOne << d) - 1);
    return numerator < (other.numerator >> d) + (rest != 0 ? 1 : 0);
  }
  return (numerator >> -d) < other.numerator;
}

bool NumCCD::is_sum_leq_1(const NumCCD& num1, const NumCCD& num2) {
  const NumCCD one(1, 0);
  if (one < num1 || one < num2) return false;
  NumCCD coarse = reduced(num1), fine = reduced(num2);
  if (fine.denom_power < coarse.denom_power) std::swap(coarse, fine);
  // Both are in [0, 1], and fine <= 1 - coarse is asked, over the denominator of `coarse`.
  return fine <= NumCCD(coarse.denominator() - coarse.numerator, coarse.denom_power);
}

std::pair<Interval, Interval> Interval::bisect() const {
  NumCCD middle = lower + upper;
  if (middle.numerator % 2 == 0 && middle.denom_power == 0) {
    middle.numerator /= 2;
  } else if (middle.denom_power == std::numeric_limits<std::uint8_t>::max()) {
    throw touchstone::InvalidQuery("the interval cannot be bisected further");
  } else {
    ++middle.denom_power;
  }
  return {Interval(lower, middle), Interval(middle, upper)};
}

bool Interval::overlaps(const Scalar r1, const Scalar r2) const { return upper.value() >= r1 && lower.value() <= r2; }

Array3 width(const Interval3& x) {
  return {x[0].upper.value() - x[0].lower.value(), x[1].upper.value() - x[1].lower.value(),
          x[2].upper.value() - x[2].lower.value()};
}

}  // namespace ticcd
