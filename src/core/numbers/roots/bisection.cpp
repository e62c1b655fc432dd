// Bisection ends where the Bernstein coefficients over an interval change their sign never (no root) or once (one
// simple root). Over an interval with a multiple root they never do. So where a few bisections do not end, p is
// factored into polynomials that have only simple roots, one for each multiplicity; on these, bisection always ends.
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

/// A subinterval, in which there may be roots.
struct Subinterval {
  BernsteinForm form;
  Exact low, high;
  int depth;             ///< so many more cuts may be made
  int steady = 0;        ///< so many cuts in a row have left all variations on one side
  int cluster_bits = 8;  ///< the next attempt at a cluster is in an interval of 2^-cluster_bits of this one's length
};

/// Roots of wildly different magnitudes are in clusters: hundreds of bisections leave all variations on one side. So
/// after a few of them, Newton's method for a root of as many multiplicities as there are variations finds about where
/// the cluster is. A narrow interval there that has all the variations leaves none for the rest: there is no root.
/// @param right  the form over the interval's second half
std::optional<Subinterval> around_cluster(Coefficients p, const Subinterval& interval, int variations,
                                          const BernsteinForm& right) {
  const Exact slope = right[1] - right[0];
  if (is_zero(slope)) return std::nullopt;
  const double degree = p.size - 1;
  const double centre = 0.5 - variations / (2 * degree) * approximate_quotient(right[0], slope);
  if (!(centre > -0.5 && centre < 1.5)) return std::nullopt;
  const double reach = std::ldexp(1.0, -interval.cluster_bits - 1);
  const Exact width = interval.high - interval.low;
  const double first = std::max(centre - reach, 0.0), last = std::min(centre + reach, 1.0);
  if (!(first < last)) return std::nullopt;
  const Exact low = interval.low + width * Exact(first), high = interval.low + width * Exact(last);
  BernsteinForm form(p, low, high);
  if (is_zero(form[0]) || is_zero(form[p.size - 1]) || form.variations() != variations) return std::nullopt;
  constexpr int kMostBits = 40;  // the centre is a double
  return Subinterval{
      std::move(form), low, high, interval.depth - 1, interval.steady, std::min(2 * interval.cluster_bits, kMostBits)};
}

/// Appends the roots of p in the open interval (low, high), at whose ends p is not zero. Returns false, with some roots
/// appended, when `depth` bisections do not isolate them.
bool bisect(Coefficients p, const Exact& low, const Exact& high, int depth, int multiplicity,
            std::vector<RealRoot>& roots) {
  // The intervals in which there may be roots, the first one last. Simple roots may be nearer to each other than
  // 2^-3000: the depth has no limit that the machine's stack would hold.
  std::vector<Subinterval> intervals;
  intervals.push_back({BernsteinForm(p, low, high), low, high, depth});
  while (!intervals.empty()) {
    const Subinterval interval = std::move(intervals.back());
    intervals.pop_back();
    const int variations = interval.form.variations();
    if (variations == 0) continue;
    if (variations == 1) {
      roots.push_back(RealRoot::isolated(p, interval.low, interval.high, sign_of(interval.form[0])));
      roots.back().set_multiplicity(multiplicity);
      continue;
    }
    if (interval.depth == 0) return false;
    // A cut must not be at a root. One of these positions is not, because there are more of them than roots.
    static constexpr int kPositions[] = {kMiddle, 40, 24, 48, 16, 56, 8,  33, 31, 34, 30, 35, 29, 36,
                                         28,      37, 27, 38, 26, 39, 25, 41, 23, 42, 22, 43, 21, 44,
                                         20,      45, 19, 46, 18, 47, 17, 49, 15, 50, 14, 51, 13, 52,
                                         12,      53, 11, 54, 10, 55, 9,  57, 7,  58, 6,  59, 5,  60};
    static_assert(sizeof kPositions / sizeof *kPositions > kMostDegree);
    for (const int position : kPositions) {
      auto [left, right] = interval.form.split(position);
      if (is_zero(right[0])) continue;
      const bool before = left.variations() > 0, after = right.variations() > 0;
      int steady = before && after ? 0 : interval.steady + 1, cluster_bits = interval.cluster_bits;
      if (steady > kSteady && position == kMiddle) {
        if (auto cluster = around_cluster(p, interval, variations, right)) {
          intervals.push_back(std::move(*cluster));
          break;
        }
        steady = 0;
        cluster_bits = std::max(cluster_bits / 2, 4);
      }
      const Exact cut = interval.low + (interval.high - interval.low) * Exact(position / 64.0);
      if (after) intervals.push_back({std::move(right), cut, interval.high, interval.depth - 1, steady, cluster_bits});
      if (before) intervals.push_back({std::move(left), interval.low, cut, interval.depth - 1, steady, cluster_bits});
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
