// Separations that are worth a question.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <touchstone/distance.hpp>

#include "support/query_families.hpp"

namespace touchstone::tests {

/// The largest absolute coordinate.
inline double extent(const Query& query) {
  double largest = 0;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    for (const Vec3& x : {query.start[i], query.end[i]}) {
      largest = std::max({largest, std::fabs(x.x), std::fabs(x.y), std::fabs(x.z)});
    }
  }
  return largest;
}

/// A distance that matters to a query: of its own size, or exactly the distance at some time.
inline double interesting_distance(const Query& query, Metric metric, Rng& rng) {
  const double size = extent(query);
  const auto finite = [](double d) { return d < 0x1p1023 ? d : 1; };
  switch (rng.between(0, 4)) {
    case 0: return finite(distance(query, rng.one_in(2) ? 0 : rng.unit(), metric).value);
    case 1: return finite(distance(query, rng.one_in(2) ? 1 : 0.5, metric).value);
    case 2: return std::ldexp(rng.between(1, 8), -2);
    case 3: return size * rng.unit() * 0.5;
    default: return std::ldexp(size > 0 ? size : 1, -rng.between(1, 60));
  }
}

}  // namespace touchstone::tests
