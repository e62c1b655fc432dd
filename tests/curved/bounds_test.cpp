// The bounds inside the bracket level of curved queries, one by one: products of polynomials, cuts, projections, and
// the slack of all bounds. Each against rationals, and each error comes near its bound: fuzz/weaken-constants.py makes
// them too small.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include <gmpxx.h>

#include "filters/curved/curved_form.hpp"
#include "filters/curved/curved_projection.hpp"
#include "filters/curved/curved_time.hpp"
#include "numbers/doubles/bounded.hpp"
#include "seeded/rng.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

namespace touchstone::tests {
namespace {

using filters::CurvedForm;
using filters::kBinomial;
using filters::ScalarForm;
using filters::VectorForm;
using numbers::Bounded;
using seeded::Rng;
using Index = std::size_t;

constexpr std::uint64_t kSeed = 72;
/// An error that a search finds takes up more of its bound than this.
constexpr double kNear = 0.125;

mpq_class exact(double x) { return mpq_class(x); }

/// How much of its bound an error takes up; fails where it is more than all of it.
struct Worst {
  double ratio = 0;

  void see(double found, const mpq_class& truth, double bound) {
    const mpq_class off = abs(mpq_class(exact(found) - truth));
    if (off == 0) return;
    REQUIRE(off <= exact(bound) * exact(numbers::kBoundSlack));
    ratio = std::max(ratio, mpq_class(off / exact(bound)).get_d());
  }
};

/// With a full significand, near a power of two or not.
double number(Rng& rng) {
  const double x = rng.one_in(2) ? 1 - rng.unit() * 0x1p-6 : rng.symmetric();
  return rng.one_in(2) ? x : -x;
}

/// A polynomial whose true coefficients are as far from the computed ones as its error says.
template <Index Dim>
struct Known {
  CurvedForm<Dim> form;
  std::array<std::array<mpq_class, filters::kMostCurvedDegree + 1>, Dim> truth;
};

template <Index Dim>
Known<Dim> some_form(Rng& rng, int most_degree, bool has_error) {
  Known<Dim> known;
  known.form.degree = rng.between(0, most_degree);
  known.form.error = has_error ? std::ldexp(1 + rng.unit(), -rng.between(4, 60)) : 0;
  for (Index axis = 0; axis < Dim; ++axis) {
    for (Index k = 0; k <= static_cast<Index>(known.form.degree); ++k) {
      const double binomial = kBinomial[static_cast<Index>(known.form.degree)][k];
      const double c = binomial * number(rng);
      known.form.c[axis][k] = c;
      // Mostly on one side: then the errors of a product's terms add up.
      const int side = (c < 0 ? -1 : 1) * (rng.one_in(8) ? -1 : 1);
      known.truth[axis][k] = exact(c) + side * exact(binomial) * exact(known.form.error);
    }
  }
  known.form.measure();
  return known;
}

template <class A, class B>
mpq_class convolved(const A& a, int a_degree, const B& b, int b_degree, int k) {
  mpq_class sum = 0;
  for (int i = std::max(0, k - b_degree); i <= std::min(k, a_degree); ++i) {
    sum += a[static_cast<Index>(i)] * b[static_cast<Index>(k - i)];
  }
  return sum;
}

/// The coefficients of a product, each within its binomial coefficient times the form's error.
template <Index Dim, class Truth>
void see_all(Worst& worst, const CurvedForm<Dim>& product, const Truth& truth) {
  for (Index axis = 0; axis < Dim; ++axis) {
    for (int k = 0; k <= product.degree; ++k) {
      const double binomial = kBinomial[static_cast<Index>(product.degree)][static_cast<Index>(k)];
      worst.see(product.c[axis][static_cast<Index>(k)], truth(axis, k), binomial * product.error);
    }
  }
}

/// Products of all sorts, of forms with errors or without.
double worst_of_products(std::uint64_t seed, bool has_error) {
  Worst scalars, vectors, dots, crosses, components;
  for (std::uint64_t index = 0; index < effort(4000); ++index) {
    Rng rng(seeded::seed_of_stream(seed, index));
    INFO("seed " << seed << ", index " << index);
    const int most = rng.one_in(2) ? 1 : 4;
    const auto s = some_form<1>(rng, most, has_error), r = some_form<1>(rng, most, has_error);
    const auto a = some_form<3>(rng, most, has_error), b = some_form<3>(rng, most, has_error);
    const auto part = [&](Index i, Index j, int k) {
      return convolved(a.truth[i], a.form.degree, b.truth[j], b.form.degree, k);
    };
    const auto cross_part = [&](Index axis, int k) {
      const Index i = (axis + 1) % 3, j = (axis + 2) % 3;
      return mpq_class(part(i, j, k) - part(j, i, k));
    };
    see_all(scalars, s.form * r.form,
            [&](Index, int k) { return convolved(s.truth[0], s.form.degree, r.truth[0], r.form.degree, k); });
    see_all(vectors, s.form * b.form,
            [&](Index axis, int k) { return convolved(s.truth[0], s.form.degree, b.truth[axis], b.form.degree, k); });
    see_all(dots, dot(a.form, b.form),
            [&](Index, int k) { return mpq_class(part(0, 0, k) + part(1, 1, k) + part(2, 2, k)); });
    see_all(crosses, cross(a.form, b.form), cross_part);
    const Index axis = index % 3;
    see_all(components, cross_component(a.form, b.form, axis), [&](Index, int k) { return cross_part(axis, k); });
  }
  std::printf("products of polynomials%s: errors up to %.2g, %.2g, %.2g, %.2g, %.2g of their bounds\n",
              has_error ? " with errors" : "", scalars.ratio, vectors.ratio, dots.ratio, crosses.ratio,
              components.ratio);
  return std::min({scalars.ratio, vectors.ratio, dots.ratio, crosses.ratio, components.ratio});
}

}  // namespace

TEST_CASE("curved bounds: the roundings of products of polynomials") { CHECK(worst_of_products(kSeed, false) > kNear); }

TEST_CASE("curved bounds: products of polynomials that have errors") {
  CHECK(worst_of_products(kSeed + 1, true) > kNear);
}

namespace {

/// A cut of coefficients, and the same in rationals.
double worst_of_cuts(std::uint64_t seed, bool exact_places) {
  Worst worst;
  for (std::uint64_t index = 0; index < effort(20000); ++index) {
    Rng rng(seeded::seed_of_stream(seed, index));
    INFO("seed " << seed << ", index " << index);
    const int degree = rng.one_in(2) ? 1 : rng.between(1, 6);
    // 1 - place rounds for small places; where it must be exact, places are those of the search for roots.
    constexpr std::array<double, 3> kPlaces = {0.5, 0.4375, 0.59375};
    const double place = exact_places ? kPlaces[index % 3] : std::ldexp(0.5 + 0.5 * rng.unit(), -rng.between(0, 4));
    std::array<double, 7> left, right;
    std::array<mpq_class, 7> true_left, true_right;
    double size = 0;
    for (Index k = 0; k <= static_cast<Index>(degree); ++k) {
      right[k] = number(rng);
      true_right[k] = exact(right[k]);
      size = std::max(size, std::fabs(right[k]));
    }
    filters::cut_at(left, right, degree, place);
    for (Index round = 0; round <= static_cast<Index>(degree); ++round) {
      true_left[round] = true_right[0];
      for (Index i = 0; i + round + 1 <= static_cast<Index>(degree); ++i) {
        true_right[i] = (1 - exact(place)) * true_right[i] + exact(place) * true_right[i + 1];
      }
    }
    const double bound = exact_places ? filters::exact_cut_error(degree, size) : filters::cut_error(degree, size);
    for (Index k = 0; k <= static_cast<Index>(degree); ++k) {
      worst.see(left[k], true_left[k], bound);
      worst.see(right[k], true_right[k], bound);
    }
  }
  std::printf("cuts at %s places: errors up to %.2g of their bound\n", exact_places ? "exact" : "any", worst.ratio);
  return worst.ratio;
}

}  // namespace

TEST_CASE("curved bounds: a part that is cut in two") {
  CHECK(worst_of_cuts(kSeed + 2, false) > kNear);
  CHECK(worst_of_cuts(kSeed + 3, true) > kNear);
}

TEST_CASE("curved bounds: projections on directions, at rest and turning") {
  Worst roundings, errors, turning_roundings, turning_errors;
  for (std::uint64_t index = 0; index < effort(20000); ++index) {
    Rng rng(seeded::seed_of_stream(kSeed + 4, index));
    INFO("seed " << kSeed + 4 << ", index " << index);
    const bool has_error = index % 2 == 1;
    const double size = std::ldexp(1 + rng.unit(), rng.between(-300, 300));
    const double error = has_error ? size * std::ldexp(1, -rng.between(4, 40)) : 0;
    std::array<filters::Vector, 2> n;
    std::array<std::array<std::array<double, 1>, 3>, 2> x;
    std::array<mpq_class, 2> truth = {0, 0};
    std::array<double, 2> found;
    for (Index i = 0; i < 2; ++i) {
      const Index largest = static_cast<Index>(rng.between(0, 2));
      for (Index k = 0; k < 3; ++k) {
        n[i][k] = k == largest ? (rng.one_in(2) ? 1 : -1) : number(rng);
        // Mostly of the direction's signs: then the products add up, and so do their errors.
        x[i][k][0] = std::copysign(size * std::fabs(number(rng)), rng.one_in(8) ? -n[i][k] : n[i][k]);
        truth[i] += exact(n[i][k]) * (exact(x[i][k][0]) + (n[i][k] < 0 ? -1 : 1) * exact(error));
      }
      found[i] = filters::projection(n[i], x[i], 0);
      (has_error ? errors : roundings).see(found[i], truth[i], filters::projection_error(error, size));
    }
    const double degree = rng.between(1, 7), later = rng.between(0, static_cast<int>(degree)), earlier = degree - later;
    (has_error ? turning_errors : turning_roundings)
        .see(earlier * found[0] + later * found[1], exact(earlier) * truth[0] + exact(later) * truth[1],
             filters::turning_error(degree, error, size));
  }
  std::printf("projections: roundings up to %.2g of their bound, errors %.2g; turning %.2g, %.2g\n", roundings.ratio,
              errors.ratio, turning_roundings.ratio, turning_errors.ratio);
  CHECK(roundings.ratio > kNear);
  CHECK(errors.ratio > kNear);
  CHECK(turning_roundings.ratio > kNear);
  CHECK(turning_errors.ratio > kNear);
}

TEST_CASE("curved bounds: the doubles beside a root") {
  std::size_t known = 0, unknown = 0;
  for (std::uint64_t index = 0; index < effort(20000); ++index) {
    Rng rng(seeded::seed_of_stream(kSeed + 5, index));
    INFO("seed " << kSeed + 5 << ", index " << index);
    const double nearest = rng.one_in(4) ? std::ldexp(1, -rng.between(0, 30)) : rng.unit() + 0x1p-60;
    const double gap = nearest - filters::before(nearest);
    const double rest = 0.5 * gap * rng.symmetric();
    const double error = std::ldexp(gap * rng.unit(), rng.between(-20, 4));
    const numbers::BoundedPair root = {numbers::two_sum(nearest, rest), error};
    // The true root: as far off as it may be, or a double.
    mpq_class truth = exact(root.value.high) + exact(root.value.low) + exact(error) * (rng.one_in(2) ? 1 : -1);
    if (rng.one_in(3) && std::fabs(rest) <= error) truth = exact(root.value.high);
    const bool falls = rng.one_in(2);
    const auto sign_at = [&](double at) { return cmp(truth, exact(at)) * (falls ? 1 : -1); };
    double lower = -1;
    if (!filters::double_below(root, sign_at, falls, lower)) {
      ++unknown;
      continue;
    }
    ++known;
    REQUIRE(exact(lower) < truth);
    REQUIRE(truth < exact(filters::after(lower)));
  }
  CHECK(known > effort(20000) / 4);
  CHECK(unknown > effort(20000) / 100);
}

TEST_CASE("curved bounds: quotients of double-doubles with errors") {
  Worst worst;
  std::size_t known = 0;
  for (std::uint64_t index = 0; index < effort(20000); ++index) {
    Rng rng(seeded::seed_of_stream(kSeed + 6, index));
    INFO("seed " << kSeed + 6 << ", index " << index);
    const auto pair = [&](double high) {
      return numbers::BoundedPair{numbers::two_sum(high, high * 0x1p-54 * rng.symmetric()),
                                  std::ldexp(rng.unit(), -rng.between(46, 110))};
    };
    const numbers::BoundedPair b = pair(0.5 + rng.unit()), a = pair(b.value.high * rng.unit());
    const double quotient = numbers::quotient(a, b);
    if (std::isnan(quotient)) continue;
    ++known;
    const auto off = [&](const numbers::BoundedPair& x, int side) {
      return mpq_class(exact(x.value.high) + exact(x.value.low) + side * exact(x.error));
    };
    const mpq_class truth = off(a, 1) / off(b, -1);
    if (truth <= 1) worst.see(quotient, truth, 0x1p-51);
  }
  std::printf("%zu quotients: errors up to %.2g of their bound\n", known, worst.ratio);
  CHECK(known > effort(20000) / 4);
  CHECK(worst.ratio > kNear);
}

TEST_CASE("curved bounds: quotients of doubles with errors") {
  Worst worst;
  for (std::uint64_t index = 0; index < effort(20000); ++index) {
    Rng rng(seeded::seed_of_stream(kSeed + 7, index));
    INFO("seed " << kSeed + 7 << ", index " << index);
    const auto bounded = [&](int least) {
      const double value = number(rng);
      return Bounded{value, rng.one_in(4) ? 0 : std::ldexp(std::fabs(value) * rng.unit(), -rng.between(least, 60))};
    };
    const Bounded a = bounded(-4), b = bounded(1), found = a / b;
    const mpq_class divisor = exact(b.value) + (rng.one_in(2) ? 1 : -1) * exact(b.error);
    const mpq_class dividend = exact(a.value) + (rng.one_in(2) ? 1 : -1) * exact(a.error);
    if (divisor != 0 && std::isfinite(found.error)) worst.see(found.value, dividend / divisor, found.error);
  }
  std::printf("quotients of doubles: errors up to %.2g of their bound\n", worst.ratio);
  CHECK(worst.ratio > 0.9);
  CHECK(std::isinf((Bounded{1, 0} / Bounded{1, 0.6}).error));
  CHECK(std::isinf((Bounded{1, 0} / Bounded{0, 0}).error));
}

// The bound of a sum is a sum of bounds. One of 1 stays as it is when 2^-53 is added, as often as it is: so 2^12 sums
// lose 2^-41 of it, and the slack must make up for that.
TEST_CASE("curved bounds: the slack makes up for the roundings of the bounds themselves") {
  constexpr int kSums = 4095;
  Bounded x{0, 1};
  mpq_class most = 1;
  for (int i = 0; i < kSums; ++i) {
    x = x + Bounded{0, 0x1p-53};
    most += exact(0x1p-53);
  }
  REQUIRE(x.error == 1);
  const double less = 1 + 0x1p-42;
  x = x - Bounded{less, 0};
  REQUIRE(most > exact(less));  // so the true value may be positive
  CHECK(x.sign() == 0);
  CHECK((-x).sign() == 0);
}

}  // namespace touchstone::tests
