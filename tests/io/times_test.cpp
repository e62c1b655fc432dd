// Doubles as text.
// SPDX-License-Identifier: MIT
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>

#include "io/times.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"

using namespace touchstone;

TEST_CASE("hexfloats are those of printf, and survive a round trip") {
  constexpr std::uint64_t kSeed = 5;
  CAPTURE(kSeed);
  tests::Rng rng(kSeed);
  std::vector<double> values = {
      0.0, -0.0, 1.0, 0.5, DBL_MAX, DBL_MIN, std::numeric_limits<double>::denorm_min(), std::nextafter(DBL_MIN, 0.0)};
  while (values.size() < 20'000) {
    const double value = std::bit_cast<double>(rng.bits());
    if (std::isfinite(value)) values.push_back(value);
    values.push_back(rng.unit());
    values.push_back(std::ldexp(rng.symmetric(), -1050));
  }
  for (const double value : values) {
    char expected[64];
    std::snprintf(expected, sizeof expected, "%a", value);
    const std::string text = io::hexfloat(value);
    REQUIRE(text == expected);
    const auto back = io::parse_finite_double(text);
    REQUIRE(back);
    REQUIRE(std::bit_cast<std::uint64_t>(*back) == std::bit_cast<std::uint64_t>(value));
  }
}

TEST_CASE("decimals are read to the nearest double") {
  CHECK(io::parse_finite_double("0.1") == 0.1);
  CHECK(io::parse_finite_double("-12.5e-1") == -1.25);
  CHECK(io::parse_finite_double("1") == 1.0);
  CHECK(io::parse_finite_double("0X1.8P-2") == 0.375);
  CHECK(io::parse_finite_double("-0x.8p0") == -0.5);
  CHECK(io::parse_finite_double("9007199254740993") == 9007199254740992.0);  // a tie goes to even
  CHECK(io::parse_finite_double("0x1.00000000000008p0") == 1.0);
  CHECK(io::parse_finite_double("0x1.000000000000081p0") == std::nextafter(1.0, 2.0));
}

TEST_CASE("what is no finite number is refused") {
  for (const char* text : {"",      " ",     " 1",       "1 ",     "nan",   "NaN",     "inf",  "-inf", "infinity",
                           "0xinf", "1e999", "0x1p5000", "1e-999", "1e+-5", "0x1p+-5", "--1",  "-",    "+1",
                           "0x",    "0x-1",  "1,5",      "1.0f",   "one",   "-nan",    "0x1p", "1e"}) {
    CAPTURE(text);
    CHECK_FALSE(io::parse_finite_double(text));
  }
}

TEST_CASE("a number beyond the doubles' range rounds to 0 or infinity, and a message says so") {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  CHECK(io::parse_rounded_double("1e-400") == 0.0);
  CHECK(std::signbit(*io::parse_rounded_double("-1e-400")));
  CHECK(io::parse_rounded_double("0x1p5000") == kInfinity);
  CHECK(io::parse_rounded_double("-1e400") == -kInfinity);
  CHECK(io::parse_rounded_double("1" + std::string(800, '0') + "e-790") == 1e10);
  CHECK(io::parse_rounded_double("0.1") == 0.1);
  for (const char* text : {"", "inf", "nan", "-inf", "1e", "+1", "1 "}) CHECK_FALSE(io::parse_rounded_double(text));
  CHECK(io::fault_of_double("1e-400") == "is closer to 0 than any double that is not 0");
  CHECK(io::fault_of_double("-1e400") == "is beyond the greatest double");
  CHECK(io::fault_of_double("nan") == "is no finite number");
  CHECK(io::fault_of_double("x") == "is no finite number");
  CHECK(io::fault_of_double("0.1").empty());
}

TEST_CASE("a hexfloat is plainly a double when it is written as one") {
  for (const double value : {0.0, 1.0, 0.375, -0.1, 0x1.fffffffffffffp-1, 0x1p-999, 1e100}) {
    CHECK(io::is_plainly_a_double(io::hexfloat(value)));
  }
  for (const char* text :
       {"0.5", "1", "0x1.00000000000000p0", "0x1.00000000000008p0", "0x1p-1075", "0x.8p0", "0x3p0", ""}) {
    CAPTURE(text);
    CHECK_FALSE(io::is_plainly_a_double(text));
  }
}
