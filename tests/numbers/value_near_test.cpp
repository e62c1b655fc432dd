// The sign of a polynomial at a root in doubles: it is certain only when it is right.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstdio>

#include "numbers/roots/real_root.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"

using namespace touchstone;
using numbers::Exact;

namespace {

/// q(t), exactly.
Exact value_at(const std::array<Exact, 4>& q, const Exact& t) { return ((q[3] * t + q[2]) * t + q[1]) * t + q[0]; }

}  // namespace

TEST_CASE("the value of a polynomial near a time is within its bound, and the bound is not idle") {
  tests::Rng rng(41);
  double worst = 0;
  for (int i = 0; i < 200000; ++i) {
    // Coefficients as far off as they may be, and the time anywhere up to the next double.
    const double lower = rng.one_in(2) ? 1 - std::ldexp(rng.unit(), -rng.between(1, 53)) : rng.unit();
    const Exact time = Exact(lower) + Exact(rng.unit()) * (Exact(std::nextafter(lower, 2.0)) - Exact(lower));
    std::array<double, 4> rounded;
    std::array<Exact, 4> exact;
    for (std::size_t k = 0; k < 4; ++k) {
      rounded[k] = std::ldexp(rng.symmetric(), -rng.between(0, 2));
      exact[k] = Exact(rounded[k]) * (Exact(1) + Exact(0x1p-51 * rng.symmetric()));
    }
    const numbers::ValueNear near = numbers::value_near(rounded.data(), 4, lower);
    const double ratio =
        std::fabs(numbers::approximate_quotient(value_at(exact, time) - Exact(near.value), Exact(near.error)));
    worst = std::max(worst, ratio);
  }
  std::printf("value near a time: worst observed error / bound = %.4f\n", worst);
  CHECK(worst <= 1);
  CHECK(worst >= 0.125);
}

TEST_CASE("coefficients near underflow give no wrong sign") {
  // Roots k / 8 and cubics of small multiples of the least double, whose products are rounded to whole multiples.
  tests::Rng rng(42);
  const Exact least = numbers::power_of_two(-1074);
  long not_zero = 0;
  for (int i = 0; i < 20000; ++i) {
    const int k = rng.between(1, 7);
    const auto root = numbers::RealRoot::rational(Exact(k), Exact(8), 1);
    numbers::Polynomial<Exact, 3> q;
    std::array<Exact, 4> whole;
    for (int j = 0; j < 4; ++j) {
      whole[static_cast<std::size_t>(j)] = Exact(rng.between(-4, 4));
      q[j] = least * whole[static_cast<std::size_t>(j)];
    }
    const int truth = numbers::sign_of(value_at(whole, Exact(k / 8.0)));
    REQUIRE(root.sign_at(q) == truth);
    not_zero += truth != 0;
  }
  CHECK(not_zero > 10000);
}

TEST_CASE("coefficients near overflow give no wrong sign") {
  tests::Rng rng(43);
  const auto root = numbers::RealRoot::rational(Exact(1), Exact(3), 1);
  for (int i = 0; i < 20000; ++i) {
    numbers::Polynomial<Exact, 3> q;
    Exact scaled(0);  // 27 q(1 / 3)
    for (int j = 0; j < 4; ++j) {
      q[j] = Exact(rng.symmetric()) * numbers::power_of_two(1023 + rng.between(-1, 60));
      Exact weight(1);
      for (int n = j; n < 3; ++n) weight = weight * Exact(3);
      scaled = scaled + q[j] * weight;
    }
    REQUIRE(root.sign_at(q) == numbers::sign_of(scaled));
  }
}
