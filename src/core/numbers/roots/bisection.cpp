// Bisection ends where the Bernstein coefficients over a part change their sign never (no root) or once (one simple
// root). Over a part with a multiple root they never do. So where a few bisections do not end, p is factored into
// polynomials that have only simple roots, one for each multiplicity; on these, bisection always ends.
// SPDX-License-Identifier: MIT
#include "numbers/roots/bisection.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "numbers/integers/gmp_conversions.hpp"
#include "numbers/roots/integer_polynomial.hpp"

namespace touchstone::numbers {
namespace {

/// Two roots that are nearer to each other than limit / 2^kQuickDepth are seldom simple.
constexpr int kQuickDepth = 12;
constexpr int kAnyDepth = -1;

constexpr int kMiddle = 32;  ///< of 64
constexpr int kSteady = 3;   ///< an attempt at a cluster costs as much as a few cuts

/// A part of the interval, in which there may be roots.
struct Subinterval {
  BernsteinForm form;
  Exact low, high;
  int depth;             ///< so many more cuts may be made
  int steady = 0;        ///< so many cuts in a row have left all variations on one side
  int cluster_bits = 8;  ///< the next attempt at a cluster is at a part 2^-cluster_bits of this one
};

/// Roots of wildly different magnitudes are in clusters: hundreds of bisections leave all variations on one side. So
/// after a few of them, Newton's method for a root of as many multiplicities as there are variations finds about where
/// the cluster is. A narrow part there that has all the variations leaves none for the rest: there is no root.
/// @param right  the form over the part's second half
std::optional<Subinterval> around_cluster(Coefficients p, const Subinterval& part, int variations,
                                          const BernsteinForm& right) {
  const Exact slope = right[1] - right[0];
  if (is_zero(slope)) return std::nullopt;
  const double degree = p.size - 1;
  const double centre = 0.5 - variations / (2 * degree) * approximate_quotient(right[0], slope);
  if (!(centre > -0.5 && centre < 1.5)) return std::nullopt;
  const double reach = std::ldexp(1.0, -part.cluster_bits - 1);
  const Exact width = part.high - part.low;
  const double first = std::max(centre - reach, 0.0), last = std::min(centre + reach, 1.0);
  if (!(first < last)) return std::nullopt;
  const Exact low = part.low + width * Exact(first), high = part.low + width * Exact(last);
  BernsteinForm form(p, low, high);
  if (is_zero(form[0]) || is_zero(form[p.size - 1]) || form.variations() != variations) return std::nullopt;
  constexpr int kMostBits = 40;  // the centre is a double
  return Subinterval{std::move(form), low,         high,
                     part.depth - 1,  part.steady, std::min(2 * part.cluster_bits, kMostBits)};
}

/// Appends the roots of p in the open interval (low, high), at whose ends p is not zero. Returns false, with some roots
/// appended, when `depth` bisections do not isolate them.
bool bisect(Coefficients p, const Exact& low, const Exact& high, int depth, int multiplicity,
            std::vector<RealRoot>& roots) {
  // The parts in which there may be roots, the first one last. Simple roots may be nearer to each other than 2^-3000:
  // the depth has no limit that the machine's stack would hold.
  std::vector<Subinterval> parts;
  parts.push_back({BernsteinForm(p, low, high), low, high, depth});
  while (!parts.empty()) {
    const Subinterval part = std::move(parts.back());
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
    static constexpr int kPlaces[] = {kMiddle, 40, 24, 48, 16, 56, 8,  33, 31, 34, 30, 35, 29, 36, 28, 37, 27, 38, 26,
                                      39,      25, 41, 23, 42, 22, 43, 21, 44, 20, 45, 19, 46, 18, 47, 17, 49, 15, 50,
                                      14,      51, 13, 52, 12, 53, 11, 54, 10, 55, 9,  57, 7,  58, 6,  59, 5,  60};
    static_assert(sizeof kPlaces / sizeof *kPlaces > kMostDegree);
    for (const int place : kPlaces) {
      auto [left, right] = part.form.split(place);
      if (is_zero(right[0])) continue;
      const bool before = left.variations() > 0, after = right.variations() > 0;
      int steady = before && after ? 0 : part.steady + 1, cluster_bits = part.cluster_bits;
      if (steady > kSteady && place == kMiddle) {
        if (auto cluster = around_cluster(p, part, variations, right)) {
          parts.push_back(std::move(*cluster));
          break;
        }
        steady = 0;
        cluster_bits = std::max(cluster_bits / 2, 4);
      }
      const Exact cut = part.low + (part.high - part.low) * Exact(place / 64.0);
      if (after) parts.push_back({std::move(right), cut, part.high, part.depth - 1, steady, cluster_bits});
      if (before) parts.push_back({std::move(left), part.low, cut, part.depth - 1, steady, cluster_bits});
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
