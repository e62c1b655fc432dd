// Queries of wildly different magnitudes.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include <touchstone/query.hpp>

#include "support/query_families.hpp"

namespace touchstone::tests {

/// Coordinates of few bits times powers of two from a pool, at rest in part, in a plane, or with a contact at a time
/// that is known.
inline Query wild_query(Kind kind, Rng& rng) {
  Query query;
  query.kind = kind;
  std::array<int, 4> pool{};
  const int reach = rng.one_in(4) ? 60 : rng.one_in(3) ? 130 : 1000;
  for (int& exponent : pool) exponent = rng.between(-reach, reach);
  if (rng.one_in(2)) pool[1] = pool[2] = pool[0];
  const int style = rng.between(0, 3);
  const auto coordinate = [&] {
    const double significand = style == 0 ? rng.symmetric() : rng.between(-style, style);
    return std::ldexp(significand, rng.pick(pool));
  };
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    for (const auto axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
      query.start[i].*axis = coordinate();
      query.end[i].*axis = rng.one_in(4) ? query.start[i].*axis : coordinate();
    }
  }
  const std::size_t last = corner_count(kind) - 1;
  switch (rng.between(0, 9)) {
    case 0:
      for (std::size_t i = 0; i <= last; ++i) query.start[i].z = query.end[i].z = 0;
      break;
    case 1: query.end[last] = query.end[0]; break;
    case 2: query.start[last] = query.start[0]; break;
    case 3:  // a plane at half time
      for (std::size_t i = 0; i <= last; ++i) query.end[i].z = -query.start[i].z;
      break;
    case 4:  // almost a common plane
      for (std::size_t i = 1; i <= last; ++i) {
        query.start[i].x = query.start[0].x;
        query.end[i].x = rng.one_in(2) ? query.end[0].x : coordinate();
      }
      break;
    default: break;
  }
  return query;
}

}  // namespace touchstone::tests
