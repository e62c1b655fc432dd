// Brackets of roots that are known by construction, some of them very close to others: how small they get, and that
// they keep the root.
// SPDX-License-Identifier: MIT
#include <vector>

#include "numbers/roots/root_bracket.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"

using namespace touchstone;
using numbers::Exact;
using numbers::power_of_two;
using numbers::RootBracket;

namespace {

/// (t - m)^degree - 2 s^degree, which has the irrational root m + 2^(1/degree) s; and for degree 2 also m - 2^(1/2) s.
struct Surd {
  int degree;
  Exact m, s;

  Exact power(const Exact& x) const { return degree == 2 ? x * x : x * x * x; }
  Exact at(const Exact& t) const { return power(t - m) - Exact(2) * power(s); }
  std::vector<Exact> coefficients() const {
    const Exact c0 = degree == 2 ? m * m : -(m * m * m);
    if (degree == 2) return {c0 - Exact(2) * s * s, Exact(-2) * m, Exact(1)};
    return {c0 - Exact(2) * s * s * s, Exact(3) * m * m, Exact(-3) * m, Exact(1)};
  }
};

/// p (c - t)
std::vector<Exact> times_linear(const std::vector<Exact>& p, const Exact& c) {
  std::vector<Exact> product(p.size() + 1, Exact(0));
  for (std::size_t i = 0; i < p.size(); ++i) {
    product[i] = product[i] + c * p[i];
    product[i + 1] = product[i + 1] - p[i];
  }
  return product;
}

/// Narrows the bracket until it is smaller than 2^exponent, and says how many calls it took; 1000 when it does not end.
int calls_until(RootBracket& bracket, const std::vector<Exact>& p, long exponent) {
  int calls = 0;
  while (bracket.high() - bracket.low() >= power_of_two(exponent) && calls < 1000) {
    const Exact before = bracket.high() - bracket.low();
    bracket.narrow({p.data(), static_cast<int>(p.size())});
    REQUIRE(Exact(2) * (bracket.high() - bracket.low()) <= before);
    ++calls;
  }
  return calls;
}

/// A number in (1/4, 1/2) with so many random bits.
Exact random_middle(tests::Rng& rng, int doubles) {
  Exact m(0.25);
  for (int i = 0; i < doubles; ++i) m = m + Exact(rng.uniform(0, 1)) * power_of_two(-3 - 53L * i);
  return m;
}

}  // namespace

TEST_CASE("a bracket closes quickly in on a root, however near another one is") {
  tests::Rng rng(58);
  for (const int degree : {2, 3}) {
    for (const long apart : {1L, 30L, 100L, 400L, 1000L}) {
      for (int i = 0; i < 20; ++i) {
        const Surd surd = {degree, random_middle(rng, 1 + i % 8), power_of_two(-3 - apart)};
        INFO("degree " << degree << ", 2^-" << apart << " apart, case " << i);
        std::vector<Exact> p = surd.coefficients();
        // The root above m, and for a square also the one below it: between m and where there is no other.
        RootBracket above(surd.m, Exact(0.875), sign_of(surd.at(surd.m)));
        if (degree == 2 && i % 3 == 1) p = times_linear(p, Exact(1));
        if (degree == 2 && i % 3 == 2) p = times_linear(p, Exact(1) + power_of_two(-40));
        const long target = -apart - 500;
        CHECK(calls_until(above, p, target) <= 14);
        CHECK(above.low() > surd.m);
        CHECK(sign_of(surd.at(above.low())) < 0);
        CHECK(sign_of(surd.at(above.high())) > 0);
        if (degree == 2) {
          RootBracket below(Exact(0), surd.m, 1);
          CHECK(calls_until(below, p, target) <= 14);
          CHECK(below.high() < surd.m);
          CHECK(sign_of(surd.at(below.low())) > 0);
          CHECK(sign_of(surd.at(below.high())) < 0);
        }
      }
    }
  }
}

TEST_CASE("a bracket closes quickly in on one of two near roots beside which there is a third") {
  tests::Rng rng(60);
  for (const long third : {20L, 200L, 700L}) {
    for (const long apart : {230L, 400L, 1500L}) {
      if (apart <= third) continue;
      for (int i = 0; i < 10; ++i) {
        const Surd surd = {2, random_middle(rng, 1 + i % 4), power_of_two(-3 - apart)};
        INFO("2^-" << apart << " apart, the third 2^-" << third << " away, case " << i);
        const Exact away = i % 2 == 0 ? power_of_two(-third) : -power_of_two(-third);
        const std::vector<Exact> p = times_linear(surd.coefficients(), surd.m + away);
        // From the side where the third root is not, and all three look like one.
        const bool below = i % 2 == 0;
        RootBracket bracket(below ? Exact(0) : surd.m, below ? surd.m : Exact(1), 1);
        CHECK(calls_until(bracket, p, -apart - 500) <= 25);
        CHECK(sign_of(surd.at(bracket.low())) * sign_of(surd.at(bracket.high())) < 0);
        CHECK((below ? surd.m - bracket.high() : bracket.low() - surd.m) > Exact(0));
      }
    }
  }
}

TEST_CASE("a bracket becomes the root where that is dyadic, and then shows every sign there") {
  const Exact root = Exact(0.375) + power_of_two(-200);
  // (t - root) (t^2 + 1)
  const std::vector<Exact> p = {-root, Exact(1), -root, Exact(1)};
  RootBracket bracket(Exact(0), Exact(1), -1);
  CHECK(calls_until(bracket, p, -100000) < 1000);
  CHECK(bracket.low() == root);
  CHECK(bracket.high() == root);
  const std::vector<Exact> zero_there = {Exact(-3) * root, Exact(3)};
  CHECK(bracket.sign_over({zero_there.data(), 2}) == 0);
  const std::vector<Exact> beside = {-root - power_of_two(-5000), Exact(1)};
  CHECK(bracket.sign_over({beside.data(), 2}) == -1);
  CHECK(bracket.compare({p.data(), 4}, root) == 0);
  CHECK(bracket.compare({p.data(), 4}, root + power_of_two(-3000)) == -1);
  CHECK(bracket.compare({p.data(), 4}, root - power_of_two(-3000)) == 1);
}

TEST_CASE("a sign over a bracket is that of every point in it, or uncertain") {
  tests::Rng rng(59);
  int certain = 0;
  int uncertain = 0;
  for (int i = 0; i < 5000; ++i) {
    const int size = 2 + static_cast<int>(rng.below(3));
    std::vector<Exact> q;
    for (int k = 0; k < size; ++k) q.emplace_back(static_cast<double>(static_cast<int>(rng.below(41)) - 20));
    const double low = static_cast<double>(rng.below(16)) / 16;
    const double high = low + static_cast<double>(1 + rng.below(8)) / 32;
    const RootBracket bracket(Exact(low), Exact(high), 1);
    const numbers::Coefficients view = {q.data(), size};
    const auto sign = bracket.sign_over(view);
    bool one_sign = true;
    for (int k = 0; k <= 64; ++k) {
      const Exact t = Exact(low) + Exact((high - low) * k / 64);
      one_sign = one_sign && sign_of(numbers::evaluate(view, t)) == sign.value_or(2);
    }
    if (sign) {
      ++certain;
      CHECK(one_sign);
    } else {
      ++uncertain;
    }
  }
  CHECK(certain > 1000);
  CHECK(uncertain > 100);
}
