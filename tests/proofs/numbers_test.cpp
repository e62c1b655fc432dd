// The text of exact numbers.
// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include "numbers/integers/common_denominator.hpp"
#include "proofs/proof_text.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using proofs::Exact;

namespace {

std::string text_of(const Exact& x) {
  std::string text;
  proofs::append_number(text, x);
  return text;
}

}  // namespace

TEST_CASE("numbers are short decimal integers or hexfloats") {
  CHECK(text_of(Exact(0)) == "0");
  CHECK(text_of(Exact(-12)) == "-12");
  CHECK(text_of(Exact(281474976710655.0)) == "281474976710655");
  CHECK(text_of(Exact(281474976710656.0)) == "0x1p48");
  CHECK(text_of(Exact(0.75)) == "0xcp-4");
  CHECK(text_of(Exact(-0x1p-1074)) == "-0x4p-1076");
  CHECK(text_of(Exact(0x1p1023) * Exact(0x1p1023)) == "0x4p2044");
  CHECK(text_of(Exact(0x1p600) + Exact(0x1p-600)) == "0x1" + std::string(299, '0') + "1p-600");
}

TEST_CASE("a hexfloat of a double reads back as this double") {
  for (double x = 0x1.921fb54442d18p-1060; x < 1e300; x *= 1717.25) {
    const std::string text = text_of(Exact(x));
    CAPTURE(text);
    CHECK(std::stod(text) == x);
  }
}

TEST_CASE("integers without a common factor keep their proportions and signs") {
  using numbers::without_common_factor;
  using List = std::vector<Exact>;
  CHECK(without_common_factor({}).empty());
  CHECK(without_common_factor({Exact(0), Exact(0)}) == List{Exact(0), Exact(0)});
  CHECK(without_common_factor({Exact(0), Exact(-7)}) == List{Exact(0), Exact(-1)});
  CHECK(without_common_factor({Exact(-15.0), Exact(0), Exact(22.5)}) == List{Exact(-2), Exact(0), Exact(3)});
  CHECK(without_common_factor({Exact(0x1p-900), Exact(0x3p-901)}) == List{Exact(2), Exact(3)});
  CHECK(without_common_factor({Exact(0x1p900), Exact(-0x5p902)}) == List{Exact(1), Exact(-20)});
}
