// SPDX-License-Identifier: MIT
#include "numbers/exact_number.hpp"

#include <CGAL/Gmpq.h>
#include <CGAL/Gmpz.h>

#include <cmath>

namespace touchstone::numbers {
namespace {

std::string digits_of(mpz_srcptr value) {
  std::string digits(mpz_sizeinbase(value, 10) + 2, '\0');  // a sign and the end mark
  mpz_get_str(digits.data(), 10, value);
  digits.resize(std::char_traits<char>::length(digits.c_str()));
  return digits;
}

}  // namespace

Exact exact_from_integer(const CGAL::Gmpz& integer) {
  const int sign = mpz_sgn(integer.mpz());
  if (sign == 0) return Exact(0);
  const Exact magnitude(integer);
  return sign < 0 ? -magnitude : magnitude;
}

Exact power_of_two(long exponent) {
  constexpr long kStep = 1000;  // within the range of normal doubles
  Exact power(1);
  while (exponent > kStep) {
    power = power * Exact(std::ldexp(1.0, kStep));
    exponent -= kStep;
  }
  while (exponent < -kStep) {
    power = power * Exact(std::ldexp(1.0, -kStep));
    exponent += kStep;
  }
  return power * Exact(std::ldexp(1.0, static_cast<int>(exponent)));
}

Approximation approximate(const Exact& x) {
  // Mpzf::to_double takes the two leading limbs; it overflows beyond 2^1024 and loses bits below 2^-1022, so bring
  // such values near 1 first. Each pass moves the exponent by 960, a multiple of the limb size: a copy, no shift.
  constexpr int kStep = 960;
  constexpr double kSmall = 0x1p-900;
  if (is_zero(x)) return {0.0, 0};
  double value = x.to_double();
  long exponent = 0;
  if (!std::isfinite(value) || std::fabs(value) < kSmall) {
    Exact scaled = x;
    const Exact down(std::ldexp(1.0, -kStep));
    const Exact up(std::ldexp(1.0, kStep));
    while (!std::isfinite(value)) {
      scaled = scaled * down;
      exponent += kStep;
      value = scaled.to_double();
    }
    while (std::fabs(value) < kSmall) {
      scaled = scaled * up;
      exponent -= kStep;
      value = scaled.to_double();
    }
  }
  int binary = 0;
  const double significand = std::frexp(value, &binary);
  return {significand, exponent + binary};
}

double approximate_quotient(const Exact& numerator, const Exact& denominator) {
  const Approximation n = approximate(numerator);
  if (n.significand == 0) return 0;
  const Approximation d = approximate(denominator);
  const long exponent = n.exponent - d.exponent;
  const int clamped = exponent > 5000 ? 5000 : exponent < -5000 ? -5000 : static_cast<int>(exponent);
  return std::ldexp(n.significand / d.significand, clamped);
}

std::string to_string(const Exact& x) {
  if (is_zero(x)) return "0";
  const CGAL::Gmpq quotient = static_cast<CGAL::Gmpq>(x);
  CGAL::Gmpz numerator = quotient.numerator();
  long exponent = 1 - static_cast<long>(mpz_sizeinbase(quotient.denominator().mpz(), 2));
  const auto twos = mpz_scan1(numerator.mpz(), 0);
  constexpr long kPlainBits = 64;  // an integer of this size is written out
  if (exponent == 0 && mpz_sizeinbase(numerator.mpz(), 2) > kPlainBits) {
    mpz_tdiv_q_2exp(numerator.mpz(), numerator.mpz(), twos);
    exponent += static_cast<long>(twos);
  }
  std::string text = digits_of(numerator.mpz());
  if (exponent != 0) text.append(" * 2^").append(std::to_string(exponent));
  return text;
}

std::string quotient_to_string(const Exact& numerator, const Exact& denominator) {
  const CGAL::Gmpq quotient = static_cast<CGAL::Gmpq>(numerator) / static_cast<CGAL::Gmpq>(denominator);
  std::string text = digits_of(quotient.numerator().mpz());
  if (mpz_cmp_ui(quotient.denominator().mpz(), 1) != 0) text.append("/").append(digits_of(quotient.denominator().mpz()));
  return text;
}

}  // namespace touchstone::numbers
