// A search that drives |observed error| / bound as high as it can: random starts, then hill climbing on the inputs'
// significands, exponents and signs.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/query_families.hpp"

namespace touchstone::tests {

struct BoundSearch {
  double worst = 0;           ///< the largest ratio seen
  std::vector<double> input;  ///< where
  long evaluations = 0;
};

/// `ratio(input)` is |error| / bound for an input of `size` doubles, or NaN where the bound does not apply.
/// Inputs are of magnitude 2^exponent, give or take `spread` binary orders.
template <class Ratio>
void search_bound(BoundSearch& search, Rng& rng, std::size_t size, int exponent, int spread, int starts, int steps, Ratio ratio) {
  const auto fresh = [&] {
    // Full significands near a power of two lose the most when rounded.
    const double significand = 1 + rng.unit();
    const int order = exponent - rng.between(0, spread);
    return std::ldexp(rng.one_in(2) ? significand : -significand, order);
  };
  for (int start = 0; start < starts; ++start) {
    std::vector<double> input(size);
    for (double& x : input) x = fresh();
    double best = ratio(input);
    for (int step = 0; step < steps; ++step) {
      std::vector<double> changed = input;
      const int changes = rng.between(1, 3);
      for (int i = 0; i < changes; ++i) {
        double& x = changed[static_cast<std::size_t>(rng.between(0, static_cast<int>(size) - 1))];
        switch (rng.between(0, 3)) {
          case 0: x = fresh(); break;
          case 1: x = -x; break;
          case 2: x = std::nextafter(x, rng.one_in(2) ? 0.0 : 2 * x); break;
          default: x *= 1 + std::ldexp(rng.unit() - 0.5, -rng.between(0, 39)); break;
        }
      }
      const double value = ratio(changed);
      ++search.evaluations;
      if (std::isnan(value) || (!std::isnan(best) && value < best)) continue;
      input = std::move(changed);
      best = value;
    }
    if (best > search.worst) {
      search.worst = best;
      search.input = input;
    }
  }
}

}  // namespace touchstone::tests
