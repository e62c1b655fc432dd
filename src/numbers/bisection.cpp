// Bisection ends where the Bernstein coefficients over a part change their sign never (no root) or once (one simple
// root). Over a part with a multiple root they never do. So where a few bisections do not end, p is factored into
// polynomials that have only simple roots, one for each multiplicity; on these, bisection always ends.
// SPDX-License-Identifier: MIT
#include "numbers/bisection.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <gmpxx.h>

#include "numbers/gmp_conversions.hpp"

namespace touchstone::numbers {
namespace {

/// Two roots that are nearer to each other than limit / 2^kQuickDepth are seldom simple.
constexpr int kQuickDepth = 12;
constexpr int kAnyDepth = -1;

/// Appends the roots of p in the open interval (low, high), at whose ends p is not zero. Returns false, with some roots
/// appended, when `depth` bisections do not isolate them.
bool bisect(Coefficients p, const Exact& low, const Exact& high, int depth, int multiplicity,
            std::vector<RealRoot>& roots) {
  struct Part {
    BernsteinForm form;
    Exact low, high;
    int depth;
  };
  // The parts in which there may be roots, the first one last. Simple roots may be nearer to each other than 2^-3000:
  // the depth has no limit that the machine's stack would hold.
  std::vector<Part> parts;
  parts.push_back({BernsteinForm(p, low, high), low, high, depth});
  while (!parts.empty()) {
    const Part part = std::move(parts.back());
    parts.pop_back();
    const int variations = part.form.variations();
    if (variations == 0) continue;
    if (variations == 1) {
      roots.push_back(RealRoot::isolated(p, part.low, part.high, sign_of(part.form[0])));
      roots.back().set_multiplicity(multiplicity);
      continue;
    }
    if (part.depth == 0) return false;
    // A cut must not be at a root. One of seven places is not, because p has at most six.
    static constexpr int kPlaces[] = {4, 5, 3, 6, 2, 7, 1};
    static_assert(sizeof kPlaces / sizeof *kPlaces > kMostDegree);
    for (const int eighths : kPlaces) {
      auto [left, right] = part.form.split(eighths);
      if (is_zero(right[0])) continue;
      const Exact cut = part.low + (part.high - part.low) * Exact(eighths * 0.125);
      if (right.variations() > 0) parts.push_back({std::move(right), cut, part.high, part.depth - 1});
      parts.push_back({std::move(left), part.low, cut, part.depth - 1});
      break;
    }
  }
  return true;
}

/// A polynomial with integer coefficients, constant first; the leading one is not zero. Empty for the zero polynomial.
using Integers = std::vector<mpz_class>;

void make_primitive(Integers& p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
  mpz_class divisor;
  for (const mpz_class& c : p) divisor = gcd(divisor, c);
  for (mpz_class& c : p) mpz_divexact(c.get_mpz_t(), c.get_mpz_t(), divisor.get_mpz_t());
}

Integers primitive_integers(Coefficients p) {
  mpz_class denominator = 1;
  std::vector<mpq_class> rationals;
  for (int i = 0; i < p.size; ++i) {
    rationals.push_back(to_rational(p.c[i]));
    denominator = lcm(denominator, rationals.back().get_den());
  }
  Integers result;
  for (const mpq_class& x : rationals) result.push_back(x.get_num() * (denominator / x.get_den()));
  make_primitive(result);
  return result;
}

Integers derivative(const Integers& p) {
  Integers result;
  for (std::size_t i = 1; i < p.size(); ++i) result.push_back(p[i] * static_cast<unsigned long>(i));
  return result;
}

/// Divides by b, which is not zero, after a multiplication that keeps everything integer. Leaves a multiple of the
/// remainder in `a`; returns a multiple of the quotient.
Integers pseudo_divide(Integers& a, const Integers& b) {
  Integers quotient(a.size() < b.size() ? 0 : a.size() - b.size() + 1);
  while (a.size() >= b.size()) {
    const std::size_t shift = a.size() - b.size();
    const mpz_class factor = a.back();
    for (mpz_class& c : a) c *= b.back();
    for (mpz_class& c : quotient) c *= b.back();
    quotient[shift] += factor;
    for (std::size_t i = 0; i < b.size(); ++i) a[i + shift] -= factor * b[i];
    while (!a.empty() && a.back() == 0) a.pop_back();
  }
  return quotient;
}

Integers greatest_common_divisor(Integers a, Integers b) {
  while (!b.empty()) {
    pseudo_divide(a, b);
    make_primitive(a);
    a.swap(b);
  }
  return a;
}

/// a / b, primitive. b divides a.
Integers exact_quotient(Integers a, const Integers& b) {
  Integers quotient = pseudo_divide(a, b);
  make_primitive(quotient);
  return quotient;
}

/// Element i is the product of (t - root) over the roots of multiplicity i + 1, up to a constant.
std::vector<Integers> factors_by_multiplicity(const Integers& p) {
  // common[i] has the roots of multiplicity m > i with multiplicity m - i; common[i] / common[i + 1] has each once.
  std::vector<Integers> simple;
  Integers common = p;
  while (common.size() > 1) {
    Integers next = greatest_common_divisor(common, derivative(common));
    simple.push_back(exact_quotient(common, next));
    common = std::move(next);
  }
  for (std::size_t i = 0; i + 1 < simple.size(); ++i) simple[i] = exact_quotient(simple[i], simple[i + 1]);
  return simple;
}

}  // namespace

void isolate_by_bisection(Coefficients p, const Exact& limit, RootList& roots) {
  std::vector<RealRoot> found;
  if (!bisect(p, Exact(0), limit, kQuickDepth, 1, found)) {
    found.clear();
    int multiplicity = 0;
    for (const Integers& factor : factors_by_multiplicity(primitive_integers(p))) {
      ++multiplicity;
      if (factor.size() < 2) continue;
      if (factor.size() == 2) {
        const RealRoot root =
            RealRoot::rational(exact_from_integer(-factor[0]), exact_from_integer(factor[1]), multiplicity);
        if (root.compare(Exact(0)) > 0 && root.compare(limit) < 0) found.push_back(root);
        continue;
      }
      std::vector<Exact> c;
      for (const mpz_class& integer : factor) c.push_back(exact_from_integer(integer));
      const Coefficients simple(c.data(), static_cast<int>(c.size()));
      bisect(simple, Exact(0), limit, kAnyDepth, multiplicity, found);
    }
    std::sort(found.begin(), found.end(), [](const RealRoot& a, const RealRoot& b) { return a.compare(b) < 0; });
  }
  for (RealRoot& root : found) roots.push(std::move(root));
}

}  // namespace touchstone::numbers
