// The exact ring against GMP's rationals: all lengths, gaps, cancellations, copies and moves.
// SPDX-License-Identifier: MIT
#include "numbers/integers/dyadic.hpp"

#include <gmpxx.h>

#include <utility>
#include <vector>

#include "numbers/integers/gmp_conversions.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"

using namespace touchstone;
using numbers::Dyadic;
using numbers::to_rational;

namespace {

/// Limbs that are zero, all ones, a single bit or random: carries run far.
Dyadic random_dyadic(tests::Rng& rng, int longest) {
  std::vector<Dyadic::Limb> limbs(static_cast<std::size_t>(rng.between(0, longest)));
  for (Dyadic::Limb& limb : limbs) {
    switch (rng.between(0, 3)) {
      case 0: limb = 0; break;
      case 1: limb = ~Dyadic::Limb{0}; break;
      case 2: limb = Dyadic::Limb{1} << rng.between(0, 63); break;
      default: limb = rng.bits(); break;
    }
  }
  const Dyadic integer = Dyadic::from_limbs(limbs.data(), static_cast<int>(limbs.size()), rng.one_in(2));
  return integer * Dyadic::power_of_two(rng.between(-700, 700));
}

void check_form(const Dyadic& x) {
  if (x.is_zero()) return;
  REQUIRE(x.limb(0) != 0);
  REQUIRE(x.limb(x.limb_count() - 1) != 0);
}

}  // namespace

TEST_CASE("arithmetic and order agree with rationals at all lengths") {
  tests::Rng rng(51);
  for (const int longest : {1, 2, 3, 4, 8, 14, 15, 40, 120}) {
    for (int i = 0; i < 1500; ++i) {
      const Dyadic a = random_dyadic(rng, longest);
      Dyadic b = random_dyadic(rng, longest);
      if (rng.one_in(4)) b = a + random_dyadic(rng, 1) * Dyadic::power_of_two(-rng.between(0, 300));  // cancels much
      if (rng.one_in(20)) b = -a;
      const mpq_class p = to_rational(a);
      const mpq_class q = to_rational(b);
      for (const auto& [result, expected] :
           {std::pair<Dyadic, mpq_class>{a + b, p + q}, {a - b, p - q}, {a * b, p * q}}) {
        check_form(result);
        REQUIRE(to_rational(result) == expected);
        REQUIRE(result.sign() == sgn(expected));
      }
      REQUIRE((a < b) == (p < q));
      REQUIRE((a == b) == (p == q));
      REQUIRE((a > b) == (p > q));
      REQUIRE(compare(a, b) == (p > q) - (p < q));
      REQUIRE((a - a).is_zero());
      REQUIRE(to_rational(-a) == -p);
    }
  }
}

TEST_CASE("copies and moves between short and long numbers keep the value") {
  tests::Rng rng(52);
  for (int i = 0; i < 3000; ++i) {
    Dyadic a = random_dyadic(rng, rng.one_in(2) ? 4 : 40);
    Dyadic b = random_dyadic(rng, rng.one_in(2) ? 4 : 40);
    const mpq_class p = to_rational(a);
    const mpq_class q = to_rational(b);
    Dyadic copy = a;
    copy = b;
    REQUIRE(to_rational(copy) == q);
    const Dyadic& alias = copy;
    copy = alias;
    REQUIRE(to_rational(copy) == q);
    Dyadic moved = std::move(b);
    REQUIRE(to_rational(moved) == q);
    moved = std::move(a);
    REQUIRE(to_rational(moved) == p);
    a = copy;  // a moved-from number can be assigned to
    REQUIRE(to_rational(a) == q);
    std::swap(a, moved);
    REQUIRE(to_rational(a) == p);
    REQUIRE(to_rational(moved) == q);
    a = a * a - a;
    REQUIRE(to_rational(a) == p * p - p);
  }
}

TEST_CASE("doubles, integers and powers of two come in exactly") {
  tests::Rng rng(53);
  for (int i = 0; i < 5000; ++i) {
    const double x = std::ldexp(rng.symmetric(), rng.between(-1100, 1024));
    REQUIRE(to_rational(Dyadic(x)) == mpq_class(x));
  }
  for (const double x :
       {0.0, -0.0, 0x1p-1074, -0x1p-1074, 0x1.fffffffffffffp-1023, 0x1p-1022, 0x1.fffffffffffffp1023, 1.0, -1.0}) {
    CHECK(to_rational(Dyadic(x)) == mpq_class(x));
    check_form(Dyadic(x));
  }
  for (const int n : {0, 1, -1, 2147483647, -2147483647 - 1}) CHECK(to_rational(Dyadic(n)) == n);
  for (int e = -200; e <= 200; ++e) {
    CHECK(to_rational(Dyadic::power_of_two(e)) * to_rational(Dyadic::power_of_two(-e)) == 1);
    CHECK(Dyadic::power_of_two(e) + Dyadic::power_of_two(e) == Dyadic::power_of_two(e + 1));
  }
}
