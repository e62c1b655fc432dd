// Numbers as text, exactly.
// SPDX-License-Identifier: MIT
#include "numbers/written_number.hpp"

#include <string>

#include "support/catch.hpp"

using namespace touchstone::numbers;

namespace {

std::string value_of(const std::string& text) {
  const auto value = exact_value(text);
  return value ? value->numerator + "/" + value->denominator : "none";
}

}  // namespace

TEST_CASE("a written number is an exact fraction") {
  CHECK(value_of("0.1") == "1/10");
  CHECK(value_of("-12.50e-1") == "-125/100");
  CHECK(value_of("0.50000000000000000001") == "50000000000000000001/100000000000000000000");
  CHECK(value_of("1.5E+3") == "1500/1");
  CHECK(value_of(".25") == "25/100");
  CHECK(value_of("7.") == "7/1");
  CHECK(value_of("0x1.8p-2") == "24/64");
  CHECK(value_of("-0X.Ap4") == "-10/1");
  CHECK(value_of("0x1p-1074").size() == 2 + 324);
  CHECK(value_of("1e-400") == "1/1" + std::string(400, '0'));
}

TEST_CASE("zero is zero, however it is written") {
  for (const char* text : {"0", "-0", "0.000", "0e99999999999999999999", "-0x0p-99999", ".0", "000"}) {
    CAPTURE(text);
    CHECK(value_of(text) == "0/1");
    CHECK(is_exactly_a_double(text));
  }
}

TEST_CASE("zeros at the ends of a number are not counted as digits") {
  const std::string zeros(10'000, '0');
  CHECK(value_of("0.5" + zeros) == "5/10");
  CHECK(value_of(zeros + "5") == "5/1");
  CHECK(value_of("5" + zeros + "e-10000") == "5/1");
  CHECK(value_of("0." + zeros + "5e10000") == "5/10");
  CHECK(value_of("0x1" + zeros + "p-40000") == "1/1");
}

TEST_CASE("a number with too many digits is refused before it is computed") {
  CHECK(value_of("1e4095").size() == 4096 + 2);
  CHECK(value_of("1e4096") == "none");
  CHECK(value_of("1e-4095").size() == 4096 + 2);
  CHECK(value_of("1e-4096") == "none");
  CHECK(value_of("1" + std::string(4095, '1')).size() == 4096 + 2);
  CHECK(value_of("1" + std::string(4096, '1')) == "none");
  CHECK(value_of("0x1p13000") != "none");
  for (const char* text : {"1e999999999999999999999", "-1e-999999999999999999999", "0x1p999999999", "0x1p-14000"}) {
    CAPTURE(text);
    CHECK(value_of(text) == "none");
  }
  CHECK(value_of("0x" + std::string(4097, 'f')) == "none");
}

TEST_CASE("what is no finite number has no value") {
  for (const char* text : {"",   "-",    "+1",  "--1", "1..2", "1.2.3", "e5", "1e", "1e+-5", "1e5.5",
                           "0x", "0x1p", "0xg", "1f",  "nan",  "inf",   " 1", "1 ", "1,5",   "."}) {
    CAPTURE(text);
    CHECK(value_of(text) == "none");
    CHECK_FALSE(is_exactly_a_double(text));
  }
}

TEST_CASE("doubles are told from numbers beside them") {
  for (const char* text : {"0.5", "1e22", "0x1.fffffffffffffp+1023", "0x1p-1074", "9007199254740992", "0.375"}) {
    CAPTURE(text);
    CHECK(is_exactly_a_double(text));
  }
  for (const char* text :
       {"0.1", "1e23", "0x1p1024", "0x1p-1075", "9007199254740993", "0x1.00000000000008p0", "1e-400"}) {
    CAPTURE(text);
    CHECK_FALSE(is_exactly_a_double(text));
  }
}
