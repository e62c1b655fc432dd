// SPDX-License-Identifier: MIT
#include "numbers/fraction.hpp"

#include <gmp.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>

namespace touchstone::numbers {
namespace {

/// A GMP integer that frees itself.
struct Integer {
  mpz_t value;
  explicit Integer(std::string_view decimal) { mpz_init_set_str(value, std::string(decimal).c_str(), 10); }
  ~Integer() { mpz_clear(value); }
  Integer(const Integer&) = delete;
  Integer& operator=(const Integer&) = delete;
};

std::optional<std::int64_t> small_integer(std::string_view text) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

constexpr int kSignificandBits = 53;
constexpr int kLeastExponent = -1074;  // of the last bit of a subnormal
constexpr int kGreatestExponent = 1024;

std::optional<double> exact_double_of_any_length(std::string_view numerator, std::string_view denominator) {
  Integer num(numerator);
  Integer den(denominator);
  if (mpz_sgn(den.value) == 0) return std::nullopt;
  if (mpz_sgn(num.value) == 0) return 0.0;
  if (mpz_divisible_p(num.value, den.value)) {
    mpz_divexact(num.value, num.value, den.value);
    mpz_set_si(den.value, 1);
  } else {
    Integer gcd("0");
    mpz_gcd(gcd.value, num.value, den.value);
    mpz_divexact(num.value, num.value, gcd.value);
    mpz_divexact(den.value, den.value, gcd.value);
  }
  if (mpz_sgn(den.value) < 0) {
    mpz_neg(num.value, num.value);
    mpz_neg(den.value, den.value);
  }
  const auto den_twos = mpz_scan1(den.value, 0);
  if (den_twos + 1 != mpz_sizeinbase(den.value, 2)) return std::nullopt;  // not a power of two
  const auto num_twos = mpz_scan1(num.value, 0);
  const auto bits = static_cast<long>(mpz_sizeinbase(num.value, 2) - num_twos);
  const long last = static_cast<long>(num_twos) - static_cast<long>(den_twos);
  if (bits > kSignificandBits || last < kLeastExponent || last + bits > kGreatestExponent) return std::nullopt;
  mpz_tdiv_q_2exp(num.value, num.value, num_twos);
  return std::ldexp(mpz_get_d(num.value), static_cast<int>(last));  // exact: at most 53 bits, exponents in range
}

}  // namespace

bool is_decimal_integer(std::string_view text) noexcept {
  if (!text.empty() && text.front() == '-') text.remove_prefix(1);
  if (text.empty()) return false;
  for (const char c : text) {
    if (c < '0' || c > '9') return false;
  }
  return true;
}

std::optional<double> exact_double(std::string_view numerator, std::string_view denominator) {
  constexpr std::int64_t exact_limit = std::int64_t{1} << kSignificandBits;
  const auto num = small_integer(numerator);
  const auto den = small_integer(denominator);
  if (num && den && *den > 0 && (*den & (*den - 1)) == 0 && *num <= exact_limit && *num >= -exact_limit) {
    // A quotient of two doubles by a power of two of at most 2^62: exact, far from underflow.
    return static_cast<double>(*num) / static_cast<double>(*den);
  }
  if (!is_decimal_integer(numerator) || !is_decimal_integer(denominator)) return std::nullopt;
  return exact_double_of_any_length(numerator, denominator);
}

}  // namespace touchstone::numbers
