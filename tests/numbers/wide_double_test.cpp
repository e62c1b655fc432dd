// Doubles of any exponent, against exact numbers: the true one is within the error.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "numbers/exact_number.hpp"
#include "numbers/wide_double.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using numbers::Exact;
using numbers::WideDouble;

namespace {

/// A number in doubles and as it is.
struct Both {
  WideDouble wide;
  Exact exact;
};

Both both(double x) { return {WideDouble(x), Exact(x)}; }
Both operator+(const Both& a, const Both& b) { return {a.wide + b.wide, a.exact + b.exact}; }
Both operator-(const Both& a, const Both& b) { return {a.wide - b.wide, a.exact - b.exact}; }
Both operator*(const Both& a, const Both& b) { return {a.wide * b.wide, a.exact * b.exact}; }

Exact magnitude(const Exact& x) { return x.sign() < 0 ? -x : x; }

/// Whether the true number is within the error.
bool holds(const Both& x) {
  const Exact unit = numbers::power_of_two(x.wide.exponent());
  const Exact off = magnitude(x.exact - Exact(x.wide.value()) * unit);
  return (off - Exact(x.wide.error()) * unit).sign() <= 0;
}

/// Of 53 bits or few, at both ends of the range of doubles, or one of a few numbers that are far apart.
double coordinate(tests::Rng& rng, const std::array<int, 3>& exponents) {
  switch (rng.between(0, 5)) {
    case 0: return 0;
    case 1: return std::ldexp(rng.symmetric(), rng.between(-1074, 1023));
    case 2: return std::ldexp(rng.between(-3, 3), -1074);
    case 3: return std::numeric_limits<double>::max() * (rng.one_in(2) ? 1 : -1);
    default: return std::ldexp(rng.one_in(2) ? rng.symmetric() : rng.between(-3, 3), rng.pick(exponents));
  }
}

struct Tally {
  int certain = 0, uncertain = 0, zero = 0;
};

void check(const Both& x, Tally& tally) {
  REQUIRE(holds(x));
  const int sign = x.wide.sign(), exact = x.exact.sign();
  if (sign != 0) REQUIRE(sign == exact);
  (exact == 0 ? tally.zero : sign != 0 ? tally.certain : tally.uncertain) += 1;
}

}  // namespace

TEST_CASE("a coordinate in wide doubles is exact") {
  tests::Rng rng(81);
  for (int i = 0; i < 3000; ++i) {
    const double x = coordinate(rng, {-1000, 0, 900});
    const WideDouble wide(x);
    REQUIRE(wide.error() == 0);
    REQUIRE((Exact(wide.value()) * numbers::power_of_two(wide.exponent()) - Exact(x)).is_zero());
    REQUIRE(wide.sign() == (x > 0) - (x < 0));
    if (x == 0) continue;
    int bits = 0;
    (void)std::frexp(x, &bits);
    REQUIRE(wide.bits() == bits);
  }
}

TEST_CASE("sums of products in wide doubles are within their error, and certain signs are right") {
  tests::Rng rng(82);
  Tally tally;
  for (std::size_t i = 0; i < tests::effort(60000); ++i) {
    const std::array<int, 3> exponents = {rng.between(-1000, 900), rng.between(-60, 60), rng.between(-60, 60)};
    const auto number = [&] { return both(coordinate(rng, exponents)); };
    const Both a = number(), b = number(), c = number(), d = number(), e = number(), f = number();
    const Both p = a * b - c * d, q = rng.one_in(2) ? a * d - b * c : e * f + a * b;
    const Both r = p - (rng.one_in(3) ? a * b : q), s = (r + q) * e;
    for (const Both& x : {p, q, r, s, s - p * f, (s + q * f) * d, p * q, e * (r - q)}) check(x, tally);
    const Both halved = {half(s.wide), s.exact * numbers::power_of_two(-1)};
    const Both doubled = {twice(s.wide), s.exact + s.exact};
    check(halved, tally);
    check(doubled, tally);
    check(halved + halved - s, tally);
  }
  CHECK(tally.certain > 2 * tally.uncertain);
  CHECK(tally.uncertain * 1000 > tally.certain);
  CHECK(tally.zero * 20 > tally.certain);
}

TEST_CASE("the error in wide doubles is small where nothing cancels") {
  tests::Rng rng(83);
  for (int i = 0; i < 3000; ++i) {
    const std::array<int, 3> exponents = {rng.between(-1000, 900), rng.between(-60, 60), rng.between(-60, 60)};
    const auto number = [&] { return WideDouble(std::ldexp(1 + rng.unit(), rng.pick(exponents))); };
    const WideDouble sum = (number() * number() + number() * number()) * number() + number() * number() * number();
    REQUIRE(sum.error() <= 0x1p-48 * sum.value());
  }
}

TEST_CASE("a term far below the others in wide doubles leaves a sign open, and no wrong one") {
  int open = 0;
  for (int exponent = -2100; exponent <= 0; ++exponent) {
    const Both one = both(1), tiny = both(std::ldexp(1, exponent / 2)) * both(std::ldexp(1, exponent - exponent / 2));
    const Both sum = (one + tiny) - one;
    REQUIRE(holds(sum));
    REQUIRE(sum.wide.sign() >= 0);
    open += sum.wide.sign() == 0;
  }
  CHECK(open > 2000);
}

TEST_CASE("what a sum of wide doubles leaves out may exceed what is left of it") {
  const double x = 1.9;
  for (const int shift : {0, 40}) {
    const Both nothing = both(std::ldexp(1, shift)) - both(std::ldexp(1, shift));
    const Both kept = nothing + both(std::ldexp(1, shift - 959));
    const Both tiny = (both(x) * both(x) + both(x) * both(x)) * both(std::ldexp(1, shift - 961));
    const Both sum = kept - tiny;
    REQUIRE(sum.exact.sign() < 0);
    REQUIRE(sum.wide.exponent() == shift);
    REQUIRE(holds(sum));
    REQUIRE(sum.wide.sign() <= 0);
  }
}
