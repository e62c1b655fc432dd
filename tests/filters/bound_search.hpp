// A search that drives |observed error| / bound as high as it can: random starts, then climbing on the inputs'
// significands, exponents and signs.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/slow_build.hpp"

namespace touchstone::tests {

/// A bound is idle, and costs speed, where a search does not come nearer than this; and a search that finds nothing
/// proves nothing.
constexpr double kNear = 0.125;

/// In slow builds searches are short, and not held to come near.
constexpr bool kLongSearches = !TOUCHSTONE_SLOW_BUILD;

struct BoundSearch {
  double worst = 0;           ///< the largest ratio seen
  std::vector<double> input;  ///< where
  long evaluations = 0;
};

/// `ratio(input)` is |error| / bound for an input of `size` doubles, or NaN where the bound does not apply.
/// Inputs are of magnitude 2^exponent, give or take `spread` binary orders.
template <class Ratio>
void search_bound(BoundSearch& search, Rng& rng, std::size_t size, int exponent, int spread, int starts, int steps,
                  Ratio ratio) {
  const auto place = [&] { return static_cast<std::size_t>(rng.between(0, static_cast<int>(size) - 1)); };
  const auto fresh = [&] {
    // Full significands near a power of two lose the most when rounded.
    const double significand = 1 + rng.unit() * (rng.one_in(2) ? 1 : 0x1p-6);
    const int order = exponent - rng.between(0, spread);
    return std::ldexp(rng.one_in(2) ? significand : -significand, order);
  };
  std::vector<double> changed;
  for (int start = 0; start < starts; ++start) {
    std::vector<double> input(size);
    for (double& x : input) x = fresh();
    double value = ratio(input);
    for (int step = 0; step < steps; ++step) {
      changed = input;
      const int changes = rng.one_in(2) ? 1 : rng.between(1, 3);
      const bool shaken = step <= steps / 4 || rng.one_in(4);  // later on it is the low bits that matter
      for (int i = 0; i < changes; ++i) {
        double& x = changed[place()];
        switch (shaken ? rng.between(0, 4) : 4) {
          case 0: x = fresh(); break;
          case 1: x = -x; break;
          case 2: x = std::nextafter(x, rng.one_in(2) ? 0.0 : 2 * x); break;
          case 3: x = std::copysign(input[place()], x); break;
          default: x *= 1 + std::ldexp(rng.unit() - 0.5, -rng.between(0, 50)); break;
        }
      }
      const double next = ratio(changed);
      ++search.evaluations;
      if (next > search.worst) {
        search.worst = next;
        search.input = changed;
      }
      // A step may also fall a little, less and less as the search goes on, to leave a local maximum.
      const double fall = std::max(0.12 * (1 - 1.25 * step / steps), 0.0);
      if (!std::isnan(value) && !(next >= (1 - fall) * value)) continue;
      input = changed;
      value = next;
    }
  }
}

/// Prints the result of the search. Checks that the ratio violates no bound, and that it comes near one.
inline void report(const char* what, const BoundSearch& search, double near = kNear) {
  std::printf("%s: worst observed error / bound = %.4f in %ld evaluations\n", what, search.worst, search.evaluations);
  for (const double x : search.input) UNSCOPED_INFO("input " << std::hexfloat << x);
  CHECK(search.worst <= 1);
  if (kLongSearches) {
    CHECK(search.worst >= near);
  } else {
    std::printf("  (a short search: not held to find %.4f)\n", near);
  }
}

}  // namespace touchstone::tests
