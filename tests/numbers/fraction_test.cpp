// Fractions that are doubles, and fractions that are not.
// SPDX-License-Identifier: MIT
#include <gmpxx.h>

#include <cmath>
#include <limits>
#include <string>

#include "numbers/fraction.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"

using namespace touchstone;
using numbers::exact_double;

TEST_CASE("every finite double comes back from its fraction, whatever the common factor") {
  tests::Rng rng(11);
  const auto check = [&](double x) {
    const mpq_class q(x);
    const mpz_class factor = mpz_class(1) << static_cast<unsigned>(rng.between(0, 70));
    for (const mpz_class& scale : {mpz_class(1), mpz_class(3), mpz_class(-7), factor}) {
      const mpz_class numerator = q.get_num() * scale;
      const mpz_class denominator = q.get_den() * scale;
      INFO(std::hexfloat << x << " as " << numerator.get_str() << "/" << denominator.get_str());
      const auto back = exact_double(numerator.get_str(), denominator.get_str());
      REQUIRE(back.has_value());
      REQUIRE(*back == x);
    }
  };
  for (const double x : {0.0, 1.0, -1.0, 0.1, 0x1p-1074, 0x1.fffffffffffffp-1023, 0x1p-1022, 0x1.fffffffffffffp1023,
                         0x1p53 + 2, 0x1p62, 0x1p63, 0x1p64}) {
    check(x);
    check(-x);
  }
  for (int i = 0; i < 3000; ++i) check(std::ldexp(rng.symmetric(), rng.between(-1080, 1024)));
}

TEST_CASE("a fraction that no double holds gives nothing") {
  const std::string two_to_1024 = mpz_class(mpz_class(1) << 1024).get_str();
  const std::string two_to_1075 = mpz_class(mpz_class(1) << 1075).get_str();
  CHECK_FALSE(exact_double("1", "3"));
  CHECK_FALSE(exact_double("9007199254740993", "1"));  // 2^53 + 1
  CHECK_FALSE(exact_double("-9007199254740993", "2"));
  CHECK_FALSE(exact_double("9223372036854775807", "1"));
  CHECK_FALSE(exact_double(two_to_1024, "1"));  // too large
  CHECK_FALSE(exact_double("1", two_to_1075));  // half the smallest subnormal
  CHECK_FALSE(exact_double("3", two_to_1075));
  CHECK(exact_double("2", two_to_1075) == 0x1p-1074);
  CHECK(exact_double("3", "6") == 0.5);
  CHECK(exact_double("-3", "-6") == 0.5);
  CHECK(exact_double("1", "-2") == -0.5);
  CHECK(exact_double("0", "-7") == 0.0);
}

TEST_CASE("what is no fraction gives nothing") {
  for (const char* bad : {"", "-", "+1", " 1", "1 ", "1.5", "0x10", "1e3", "--1", "nan", "1/2"}) {
    INFO("'" << bad << "'");
    CHECK_FALSE(numbers::is_decimal_integer(bad));
    CHECK_FALSE(exact_double(bad, "1"));
    CHECK_FALSE(exact_double("1", bad));
  }
  CHECK_FALSE(exact_double("1", "0"));
  CHECK_FALSE(exact_double("0", "0"));
  CHECK_FALSE(exact_double("1", "-000"));
  CHECK_FALSE(numbers::is_decimal_integer(std::string_view("1\0", 2)));
  CHECK(numbers::is_decimal_integer("-007"));
}
