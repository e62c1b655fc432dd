// The exact ring against GMP's rationals.
// SPDX-License-Identifier: MIT
#include <gmpxx.h>

#include <cmath>

#include "numbers/integers/common_denominator.hpp"
#include "numbers/integers/exact_number.hpp"
#include "numbers/integers/gmp_conversions.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"

using namespace touchstone;
using numbers::Exact;

namespace {

mpq_class rational(const Exact& x) { return numbers::to_rational(x); }

mpq_class power_of_two(long exponent) {
  const mpz_class power = mpz_class(1) << static_cast<mp_bitcnt_t>(std::labs(exponent));
  return exponent >= 0 ? mpq_class(power) : mpq_class(mpz_class(1), power);
}

}  // namespace

TEST_CASE("sums, products and signs agree with rationals at all magnitudes") {
  tests::Rng rng(21);
  for (int i = 0; i < 2000; ++i) {
    double x[4];
    for (double& v : x) v = std::ldexp(rng.symmetric(), rng.between(-1074, 1023));
    const Exact e = Exact(x[0]) * Exact(x[1]) - Exact(x[2]) * Exact(x[3]);
    const mpq_class q = mpq_class(x[0]) * mpq_class(x[1]) - mpq_class(x[2]) * mpq_class(x[3]);
    REQUIRE(rational(e) == q);
    REQUIRE(numbers::sign_of(e) == sgn(q));
    REQUIRE(numbers::is_zero(e) == (q == 0));
  }
}

TEST_CASE("powers of two have any exponent") {
  for (const long exponent : {0L, 1L, -1L, 1023L, -1074L, 1024L, -1075L, 5000L, -5000L, 123457L, -123457L}) {
    INFO(exponent);
    CHECK(rational(numbers::power_of_two(exponent)) == power_of_two(exponent));
  }
}

TEST_CASE("an approximation is within 2^-52 at any magnitude") {
  tests::Rng rng(22);
  for (int i = 0; i < 2000; ++i) {
    const Exact x = Exact(rng.symmetric()) * Exact(1 + rng.unit()) * numbers::power_of_two(rng.between(-9000, 9000)) +
                    numbers::power_of_two(rng.between(-9000, 9000));
    const auto [significand, exponent] = numbers::approximate(x);
    REQUIRE(std::fabs(significand) >= 0.5);
    REQUIRE(std::fabs(significand) <= 1);
    const mpq_class truth = rational(x);
    const mpq_class error = abs(mpq_class(significand) * power_of_two(exponent) - truth);
    REQUIRE(error <= abs(truth) * power_of_two(-52));
  }
  CHECK(numbers::approximate(Exact(0)).significand == 0);
}

TEST_CASE("a quotient is within 2^-50 at any magnitude") {
  tests::Rng rng(23);
  for (int i = 0; i < 2000; ++i) {
    const int exponent = rng.between(-6000, 6000);
    const Exact n = Exact(rng.symmetric()) * Exact(rng.symmetric()) * numbers::power_of_two(exponent);
    const Exact d =
        Exact(1 + rng.unit()) * Exact(-1 - rng.unit()) * numbers::power_of_two(exponent + rng.between(-900, 900));
    if (numbers::is_zero(n)) continue;
    const mpq_class truth = rational(n) / rational(d);
    const double quotient = numbers::approximate_quotient(n, d);
    REQUIRE(abs(mpq_class(quotient) - truth) <= abs(truth) * power_of_two(-50));
  }
  CHECK(numbers::approximate_quotient(Exact(0), Exact(3)) == 0);
}

TEST_CASE("numbers as text") {
  CHECK(numbers::to_string(Exact(0)) == "0");
  CHECK(numbers::to_string(Exact(-3)) == "-3");
  CHECK(numbers::to_string(Exact(0.75)) == "3 * 2^-2");
  CHECK(numbers::to_string(Exact(0x1p-1074) * Exact(0x1p-1074)) == "1 * 2^-2148");
  CHECK(numbers::to_string(numbers::power_of_two(100) * Exact(-5)) == "-5 * 2^100");
  CHECK(numbers::quotient_to_string(Exact(6), Exact(-18)) == "-1/3");
  CHECK(numbers::quotient_to_string(Exact(0.5), Exact(0.25)) == "2");
}

TEST_CASE("integers keep their sign, and fractions their proportions") {
  CHECK(numbers::exact_from_integer(mpz_class(0)) == Exact(0));
  CHECK(numbers::exact_from_integer(mpz_class(-7)) == Exact(-7));
  CHECK(rational(numbers::exact_from_integer(mpz_class("-36893488147419103232"))) == -power_of_two(65));
  const auto integers =
      numbers::over_common_denominator({{"1", "3"}, {"-1", "2"}, {"0", "5"}, {"4", "-7"}, {"2", "1"}});
  const mpq_class unit = rational(integers[4]) / 2;
  CHECK(unit > 0);
  const mpq_class expected[] = {mpq_class(1, 3), mpq_class(-1, 2), 0, mpq_class(-4, 7)};
  for (std::size_t i = 0; i < 4; ++i) CHECK(rational(integers[i]) == expected[i] * unit);
}
