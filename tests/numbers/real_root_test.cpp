// Roots known by construction: isolation, neighbouring doubles, signs and order.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include "numbers/roots/real_root.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"

using namespace touchstone;
using numbers::Exact;
using numbers::isolate_roots;
using numbers::RealRoot;
using numbers::RootList;

namespace {

using Coefs = std::vector<Exact>;

Coefs operator*(const Coefs& p, const Coefs& q) {
  Coefs product(p.size() + q.size() - 1, Exact(0));
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < q.size(); ++j) product[i + j] = product[i + j] + p[i] * q[j];
  }
  return product;
}

numbers::Coefficients view(const Coefs& p) { return {p.data(), static_cast<int>(p.size())}; }

RootList roots_of(const Coefs& p, double limit = 1) { return isolate_roots(view(p), Exact(limit)); }

/// d t - n
Coefs linear(double n, double d) { return {Exact(-n), Exact(d)}; }

void check_neighbours(const RealRoot& root) {
  CHECK(root.compare(Exact(root.lower())) >= 0);
  CHECK(root.compare(Exact(root.upper())) <= 0);
  if (root.lower() == root.upper()) {
    CHECK(root.compare(Exact(root.lower())) == 0);
  } else {
    CHECK(std::nextafter(root.lower(), 2.0) == root.upper());
    CHECK(root.compare(Exact(root.lower())) > 0);
    CHECK(root.compare(Exact(root.upper())) < 0);
  }
}

}  // namespace

TEST_CASE("rational roots, simple and repeated, with multiplicity and order", "[slow]") {
  struct Rational {
    int n, d;
  };
  tests::Rng rng(31);
  int repeated = 0;
  for (int i = 0; i < 3000; ++i) {
    Coefs p = {Exact(rng.one_in(2) ? 1 : -3)};
    std::vector<Rational> expected;
    const int degree = rng.between(1, i % 2 == 0 ? 3 : numbers::kMostDegree);
    for (int k = 0; k < degree; ++k) {
      Rational r = {rng.between(-3, 8), rng.between(1, 6)};
      if (k > 0 && rng.one_in(3) && !expected.empty()) r = expected.back();
      p = p * linear(r.n, r.d);
      if (r.n >= 0 && r.n <= r.d) expected.push_back(r);
    }
    while (p.size() < numbers::kMostDegree + 1 && rng.one_in(2))
      p.push_back(Exact(0));  // a formal degree above the true one
    std::sort(expected.begin(), expected.end(), [](Rational a, Rational b) { return a.n * b.d < b.n * a.d; });
    const RootList roots = roots_of(p);
    std::size_t at = 0;
    for (int k = 0; k < roots.size(); ++k) {
      const RealRoot& root = roots[k];
      REQUIRE(at < expected.size());
      const Rational r = expected[at];
      int multiplicity = 0;
      while (at < expected.size() && expected[at].n * r.d == r.n * expected[at].d) ++multiplicity, ++at;
      REQUIRE(root.multiplicity() == multiplicity);
      repeated += multiplicity > 1;
      const Coefs difference = linear(r.n, r.d);
      REQUIRE(root.sign_at(view(difference)) == 0);
      REQUIRE(root.sign_after(view(difference)) == 1);
      check_neighbours(root);
      REQUIRE(root.lower() <= static_cast<double>(r.n) / r.d);
      REQUIRE(root.upper() >= static_cast<double>(r.n) / r.d);
    }
    REQUIRE(at == expected.size());
  }
  CHECK(repeated > 300);
}

TEST_CASE("irrational roots: signs of polynomials that vanish there, and of near ones") {
  // t = sqrt(1/2) as a root of 2 t^2 - 1 and of (2 t^2 - 1)(t - 3), and together with a rational root.
  const Coefs square = {Exact(-1), Exact(0), Exact(2)};
  const Coefs near = {Exact(-1) + numbers::power_of_two(-300), Exact(0), Exact(2)};  // root just below
  for (const Coefs& p : {square, square * linear(3, 1), square * linear(1, 4), square * linear(2, 3), square * square,
                         square * square * linear(1, 4), square * square * linear(1, 3) * linear(1, 3),
                         square * square * square, square * linear(1, 3) * linear(1, 3) * linear(7, 10)}) {
    const RootList roots = roots_of(p);
    const RealRoot* root = nullptr;
    for (int i = 0; i < roots.size(); ++i) {
      if (roots[i].sign_at(view(square)) == 0) root = &roots[i];
    }
    REQUIRE(root != nullptr);
    check_neighbours(*root);
    CHECK(root->lower() <= std::sqrt(0.5));
    CHECK(root->upper() >= std::sqrt(0.5));
    CHECK(root->sign_after(view(square)) == 1);
    CHECK(root->sign_at(view(near)) == 1);
    CHECK(root->sign_at(view(p)) == 0);
    const RootList others = roots_of(near);
    REQUIRE(others.size() == 1);
    CHECK(root->compare(others[0]) == 1);
    CHECK(others[0].compare(*root) == -1);
    CHECK(root->compare(roots_of(square)[0]) == 0);
    CHECK(root->compare(root->reversed()) == 1);
    CHECK(root->reversed().reversed().compare(*root) == 0);
  }
  // The quotient (t + 0) / (2 t + 0) is a half, and t / 1 is the root.
  const RealRoot root = roots_of(square)[0];
  const numbers::Polynomial<Exact, 2> t = {{Exact(0), Exact(1), Exact(0)}};
  const numbers::Polynomial<Exact, 2> two_t = {{Exact(0), Exact(2), Exact(0)}};
  const numbers::Polynomial<Exact, 2> one = {{Exact(1), Exact(0), Exact(0)}};
  CHECK(std::fabs(root.quotient(t, two_t) - 0.5) <= 0x1p-50);
  CHECK(std::fabs(root.quotient(t, one) - std::sqrt(0.5)) <= 0x1p-50);
}

TEST_CASE("roots that are close, or merge, or are just gone") {
  for (const int bits : {10, 30, 52, 53, 54, 100, 200, 700, 2000}) {
    const Exact epsilon = numbers::power_of_two(-bits);
    for (const double centre : {0.5, 0.25, 0x1.5555555555555p-2, 0x1p-60}) {
      if (bits > 50 || centre > 0x1p-9) {
        const Coefs shifted = {Exact(-centre), Exact(1)};
        Coefs apart = shifted * shifted;
        apart[0] = apart[0] - epsilon * epsilon * numbers::power_of_two(-130);
        Coefs gone = shifted * shifted;
        gone[0] = gone[0] + epsilon;
        for (const Coefs& factor : {Coefs{Exact(1)}, linear(2, 1), linear(-1, 3), Coefs{Exact(-5)}}) {
          INFO("2^-" << bits << " around " << centre);
          const RootList two = roots_of(apart * factor);
          REQUIRE(two.size() == 2);
          check_neighbours(two[0]);
          check_neighbours(two[1]);
          CHECK(two[0].compare(two[1]) == -1);
          CHECK(two[0].compare(Exact(centre)) == -1);
          CHECK(two[1].compare(Exact(centre)) == 1);
          CHECK(two[0].multiplicity() == 1);
          CHECK(two[0].sign_at(view(shifted)) == -1);
          CHECK(two[1].sign_at(view(shifted)) == 1);
          const RootList one = roots_of(shifted * shifted * factor);
          REQUIRE(one.size() == 1);
          CHECK(one[0].multiplicity() == 2);
          CHECK(one[0].lower() == centre);
          CHECK(roots_of(gone * factor).size() == 0);
        }
      }
    }
  }
  // In s = t - 1/2: three roots within 2^-200, and one real root with two complex ones as near.
  const Coefs s = {Exact(-0.5), Exact(1)};
  const Exact e2 = numbers::power_of_two(-401);
  Coefs three = s * s;
  three[0] = three[0] - e2;
  CHECK(roots_of(three * s).size() == 3);
  Coefs single = s * s;
  single[0] = single[0] + e2;
  const RootList one = roots_of(single * s);
  REQUIRE(one.size() == 1);
  CHECK(one[0].compare(Exact(0.5)) == 0);
}

TEST_CASE("bisection separates simple roots however near they are") {
  // Each bisection is a step deeper: thousands of them must not need as much of the machine's stack.
  for (const long apart : {30L, 1000L, 20000L}) {
    INFO("2^-" << apart << " apart");
    const Exact first(0.3125);
    const Exact second = first + numbers::power_of_two(-apart);
    for (const Exact& shift : {Exact(0), first - numbers::power_of_two(-apart)}) {  // about 0.3, and near 0
      const Coefs others{Exact(1), Exact(0), Exact(1)};
      const Coefs p = Coefs{shift - first, Exact(1)} * Coefs{shift - second, Exact(1)} * others;
      const RootList roots = roots_of(p);
      REQUIRE(roots.size() == 2);
      CHECK(roots[0].multiplicity() == 1);
      CHECK(roots[0].compare(first - shift) == 0);
      CHECK(roots[1].compare(second - shift) == 0);
    }
  }
}

TEST_CASE("clusters of roots: near an end or inside, in clusters of their own, and beside complex pairs", "[slow]") {
  tests::Rng rng(32);
  std::size_t found = 0, complex_pairs = 0;
  for (int i = 0; i < 150; ++i) {
    // Dyadic roots of many digits, at centre + offset 2^-distance, all different.
    std::vector<Exact> expected;
    Coefs p = {Exact(1)};
    const int groups = rng.between(1, 3);
    for (int group = 0; group < groups; ++group) {
      const int far = rng.between(20, 700);
      const Exact centre = Exact(rng.between(1, 6) / 7.0) * numbers::power_of_two(rng.one_in(3) ? -far : 0);
      const int distance = far + rng.between(20, 600);
      const int size = rng.between(2, 3);
      for (int k = 0; k < size; ++k) {
        const Exact root = centre + Exact(2 * k + 1 + rng.between(0, 1)) * numbers::power_of_two(-distance);
        expected.push_back(root);
        p = p * Coefs{-root, Exact(1)};
      }
      if (!rng.one_in(3)) continue;
      // (t - centre)^2 + 4^-distance
      p = p * Coefs{centre * centre + numbers::power_of_two(-2 * distance), Exact(-2) * centre, Exact(1)};
      ++complex_pairs;
    }
    std::sort(expected.begin(), expected.end());
    const auto same = std::unique(expected.begin(), expected.end());
    expected.erase(same, expected.end());
    INFO("case " << i);
    const RootList roots = roots_of(p);
    REQUIRE(roots.size() == static_cast<int>(expected.size()));
    for (int k = 0; k < roots.size(); ++k) {
      REQUIRE(roots[k].compare(expected[static_cast<std::size_t>(k)]) == 0);
      check_neighbours(roots[k]);
      ++found;
    }
  }
  CHECK(found > 500);
  CHECK(complex_pairs > 30);
}

TEST_CASE("roots at the ends of the range count, and only up to the limit") {
  const Coefs ends = linear(0, 1) * linear(1, 1) * linear(1, 2);
  CHECK(roots_of(ends).size() == 3);
  CHECK(roots_of(ends, 0.5).size() == 2);
  CHECK(roots_of(ends, std::nextafter(0.5, 0.0)).size() == 1);
  CHECK(roots_of(ends, 0).size() == 1);
  CHECK(roots_of(linear(1, 3), 0x1.5555555555555p-2).size() == 0);  // just below 1/3
  CHECK(roots_of(linear(1, 3), 0x1.5555555555556p-2).size() == 1);
  const RootList tripled = roots_of(linear(1, 1) * linear(1, 1) * linear(1, 1));
  REQUIRE(tripled.size() == 1);
  CHECK(tripled[0].multiplicity() == 3);
  CHECK(tripled[0].lower() == 1);
  const RootList at_zero = roots_of(linear(0, 1) * linear(0, 1) * linear(5, 1));
  REQUIRE(at_zero.size() == 1);
  CHECK(at_zero[0].multiplicity() == 2);
}

TEST_CASE("times that are subnormal or below every double") {
  // t = n 2^-1074, between two subnormals, and below the smallest.
  const Exact tiny = numbers::power_of_two(-1074);
  for (const int thirds : {1, 2, 3, 4, 5, 6, 100}) {
    const Coefs p = {tiny * Exact(-thirds), Exact(3)};
    const RootList roots = roots_of(p);
    REQUIRE(roots.size() == 1);
    check_neighbours(roots[0]);
    CHECK(roots[0].lower() == (thirds / 3) * 0x1p-1074);
    CHECK(roots[0].upper() == ((thirds + 2) / 3) * 0x1p-1074);
  }
  // An irrational one: t^2 = 2 * 2^-2140.
  const Coefs p = {-numbers::power_of_two(-2139), Exact(0), Exact(1)};
  const RootList roots = roots_of(p);
  REQUIRE(roots.size() == 1);
  check_neighbours(roots[0]);
  CHECK(roots[0].lower() == 0x1.6p-1070);  // 16 sqrt(2) = 22.6 units of 2^-1074
}

TEST_CASE("random cubics: roots found are all the sign changes, in order") {
  tests::Rng rng(32);
  long found = 0;
  for (int i = 0; i < 20000; ++i) {
    Coefs p(4);
    const int spread = rng.between(0, 60);
    for (Exact& c : p) c = Exact(std::ldexp(rng.symmetric(), -rng.between(0, spread)));
    if (rng.one_in(3)) {  // make roots in [0, 1] likely
      const Coefs quadratic = {Exact(rng.symmetric()), Exact(rng.symmetric()), Exact(rng.symmetric())};
      p = quadratic * Coefs{Exact(-rng.unit()), Exact(1.0)};
    }
    const RootList roots = roots_of(p);
    found += roots.size();
    // An odd number of simple roots iff the ends differ in sign; each one is a change of sign of p.
    const auto sign_at = [&](double t) {
      return numbers::sign_of(((p[3] * Exact(t) + p[2]) * Exact(t) + p[1]) * Exact(t) + p[0]);
    };
    int previous = sign_at(0);
    for (int k = 0; k < roots.size(); ++k) {
      check_neighbours(roots[k]);
      if (k > 0) REQUIRE(roots[k - 1].compare(roots[k]) == -1);
      REQUIRE(roots[k].sign_at(view(p)) == 0);
      if (previous != 0 && roots[k].multiplicity() == 1) {
        REQUIRE(roots[k].sign_after(view(p)) == -previous);
        previous = -previous;
      }
    }
    if (sign_at(1) != 0 && previous != 0) REQUIRE(sign_at(1) == previous);
    // No sign change between sample points is without a root.
    for (double t = 0; t < 1; t += 0.0625) {
      if (sign_at(t) * sign_at(t + 0.0625) >= 0) continue;
      bool inside = false;
      for (int k = 0; k < roots.size(); ++k)
        inside = inside || (roots[k].lower() >= t && roots[k].upper() <= t + 0.0625);
      REQUIRE(inside);
    }
  }
  std::printf("random cubics: %ld roots\n", found);
  CHECK(found > 5000);
}

TEST_CASE("a dyadic root of more digits than a double has, and of a polynomial that hides it") {
  const Exact root = Exact(0.375) + numbers::power_of_two(-200);
  // Close to another root, so that the search for its neighbouring doubles may hit it.
  for (const long apart : {20L, 60L, 160L, 250L}) {
    const Coefs p =
        Coefs{-root, Exact(1)} * Coefs{-root - numbers::power_of_two(-apart), Exact(1)} * Coefs{Exact(1), Exact(1)};
    const RootList roots = roots_of(p);
    REQUIRE(roots.size() == 2);
    INFO("2^-" << apart << " apart");
    check_neighbours(roots[0]);
    check_neighbours(roots[1]);
    const Coefs zero_there = Coefs{-root, Exact(1)} * linear(3, 1);
    const Coefs just_above = {-root - numbers::power_of_two(-3000), Exact(1)};
    CHECK(roots[0].sign_at(view(zero_there)) == 0);
    CHECK(roots[0].sign_at(view(just_above)) == -1);
    CHECK(roots[1].sign_at(view(zero_there)) == -1);
    CHECK(roots[0].compare(roots[1]) == -1);
    CHECK(roots[0].compare(root) == 0);
    for (int i = 0; i < 2; ++i) {
      CHECK(roots[i].reversed().reversed().compare(roots[i]) == 0);
      CHECK(roots[i].compare(roots[i].reversed().reversed()) == 0);
    }
  }
}
