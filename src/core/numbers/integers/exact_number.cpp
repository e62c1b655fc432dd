// SPDX-License-Identifier: MIT
#include "numbers/integers/exact_number.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "numbers/integers/gmp_conversions.hpp"

namespace touchstone::numbers {
namespace {

constexpr int kLimbBits = 64;

double scaled(double significand, long exponent) {
  constexpr long kBeyondDoubles = 5000;
  return std::ldexp(significand, static_cast<int>(std::clamp(exponent, -kBeyondDoubles, kBeyondDoubles)));
}

}  // namespace

Approximation approximate(const Exact& x) {
  if (is_zero(x)) return {0.0, 0};
  // The leading 64 bits, cut off (2^-63) and rounded to a double (2^-53).
  const int count = x.limb_count();
  const Exact::Limb top = x.limb(count - 1);
  const int zeros = std::countl_zero(top);
  Exact::Limb bits = top << zeros;
  if (zeros > 0 && count > 1) bits |= x.limb(count - 2) >> (kLimbBits - zeros);
  const double significand = static_cast<double>(bits) * 0x1p-64;
  return {x.sign() < 0 ? -significand : significand,
          (static_cast<long>(x.limb_exponent()) + count) * kLimbBits - zeros};
}

double to_double(const Exact& x) {
  const Approximation a = approximate(x);
  return scaled(a.significand, a.exponent);
}

double approximate_quotient(const Exact& numerator, const Exact& denominator) {
  const Approximation n = approximate(numerator);
  if (n.significand == 0) return 0;
  const Approximation d = approximate(denominator);
  return scaled(n.significand / d.significand, n.exponent - d.exponent);
}

Exact exact_from_integer(const mpz_class& integer) {
  return Exact::from_limbs(mpz_limbs_read(integer.get_mpz_t()), static_cast<int>(mpz_size(integer.get_mpz_t())),
                           sgn(integer) < 0);
}

mpq_class to_rational(const Exact& x) {
  mpz_class magnitude;
  const int count = x.limb_count();
  if (count > 0) {
    mp_limb_t* limbs = mpz_limbs_write(magnitude.get_mpz_t(), count);
    for (int i = 0; i < count; ++i) limbs[i] = x.limb(i);
    mpz_limbs_finish(magnitude.get_mpz_t(), x.sign() < 0 ? -count : count);
  }
  mpq_class rational(magnitude);
  const long shift = static_cast<long>(x.limb_exponent()) * kLimbBits;
  if (shift >= 0) {
    mpq_mul_2exp(rational.get_mpq_t(), rational.get_mpq_t(), static_cast<mp_bitcnt_t>(shift));
  } else {
    mpq_div_2exp(rational.get_mpq_t(), rational.get_mpq_t(), static_cast<mp_bitcnt_t>(-shift));
  }
  return rational;
}

std::string to_string(const Exact& x) {
  if (is_zero(x)) return "0";
  const mpq_class rational = to_rational(x);
  mpz_class numerator = rational.get_num();
  long exponent = 1 - static_cast<long>(mpz_sizeinbase(rational.get_den_mpz_t(), 2));
  constexpr std::size_t kPlainBits = 64;  // an integer of this size is written out
  if (exponent == 0 && mpz_sizeinbase(numerator.get_mpz_t(), 2) > kPlainBits) {
    const mp_bitcnt_t twos = mpz_scan1(numerator.get_mpz_t(), 0);
    numerator >>= twos;
    exponent += static_cast<long>(twos);
  }
  std::string text = numerator.get_str();
  if (exponent != 0) text.append(" * 2^").append(std::to_string(exponent));
  return text;
}

std::string quotient_to_string(const Exact& numerator, const Exact& denominator) {
  return mpq_class(to_rational(numerator) / to_rational(denominator)).get_str();
}

}  // namespace touchstone::numbers
