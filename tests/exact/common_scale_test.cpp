// The spans of a query's coordinates against those of each coordinate's own significand.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>

#include "exact/common_scale.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/slow_build.hpp"

namespace touchstone::tests {
namespace {

using exact::BitSpan;

/// A double of few or many bits, at an exponent that may be extreme, or zero.
double random_coordinate(Rng& rng, int exponent, int spread, int most_bits) {
  if (rng.one_in(6)) return rng.one_in(2) ? 0.0 : -0.0;
  const int bits = rng.one_in(3) ? most_bits : rng.between(1, 20);
  double significand = 1;
  for (int i = 1; i < bits; ++i) significand = 2 * significand + rng.between(0, 1);
  const double x = std::ldexp(significand, exponent + rng.between(-spread, spread) - bits);
  return rng.one_in(2) ? x : -x;
}

}  // namespace

TEST_CASE("the span along an axis is that of all coordinates along it") {
  Rng rng(43);
  std::size_t whole = 0, wide = 0, subnormal = 0;
  const std::size_t count = effort(20000);
  for (std::size_t i = 0; i < count; ++i) {
    Query query;
    query.kind = static_cast<Kind>(rng.between(0, 3));
    const int exponent = rng.one_in(3) ? rng.between(-1074, 1020) : rng.between(-40, 40);
    const int spread = rng.one_in(3) ? 1200 : rng.one_in(2) ? rng.between(0, 60) : rng.between(0, 8);
    const int most_bits = rng.one_in(2) ? 53 : 20;
    BitSpan expected;
    for (std::size_t corner = 0; corner < corner_count(query.kind); ++corner) {
      for (Vec3* x : {&query.start[corner], &query.end[corner]}) {
        do x->y = random_coordinate(rng, exponent, spread, most_bits);
        while (!std::isfinite(x->y));
        expected.add(x->y);
        subnormal += x->y != 0 && std::fabs(x->y) < 0x1p-1022;
      }
    }
    if (expected.bits() == 0) expected = {0, 0};
    const BitSpan span = exact::axis_spans(query)[1];
    REQUIRE(span.low == expected.low);
    REQUIRE(span.high == expected.high);
    (span.bits() <= 62 ? whole : wide) += 1;
  }
  CHECK(whole * 5 > count);
  CHECK(wide * 5 > count);
  CHECK(subnormal * 50 > count);
}

}  // namespace touchstone::tests
