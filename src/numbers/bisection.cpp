// Bisection ends where the Bernstein coefficients over a part change their sign never (no root) or once (one simple
// root). Over a part with a multiple root they never do. So where a few bisections do not end, p is factored into
// polynomials that have only simple roots, one for each multiplicity; on these, bisection always ends.
// SPDX-License-Identifier: MIT
#include "numbers/bisection.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "numbers/gmp_conversions.hpp"
#include "numbers/integer_polynomial.hpp"

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
    // A cut must not be at a root. One of these places is not, because there are more of them than roots.
    static constexpr int kPlaces[] = {32, 40, 24, 48, 16, 56, 8,  33, 31, 34, 30, 35, 29, 36, 28, 37, 27, 38, 26,
                                      39, 25, 41, 23, 42, 22, 43, 21, 44, 20, 45, 19, 46, 18, 47, 17, 49, 15, 50,
                                      14, 51, 13, 52, 12, 53, 11, 54, 10, 55, 9,  57, 7,  58, 6,  59, 5,  60};
    static_assert(sizeof kPlaces / sizeof *kPlaces > kMostDegree);
    for (const int place : kPlaces) {
      auto [left, right] = part.form.split(place);
      if (is_zero(right[0])) continue;
      const Exact cut = part.low + (part.high - part.low) * Exact(place / 64.0);
      if (right.variations() > 0) parts.push_back({std::move(right), cut, part.high, part.depth - 1});
      parts.push_back({std::move(left), part.low, cut, part.depth - 1});
      break;
    }
  }
  return true;
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
