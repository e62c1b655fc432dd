// Small integers: coincidences of every sort, and every polynomial of every degree.
// SPDX-License-Identifier: MIT
#include "families/makers.hpp"

namespace touchstone::families::makers {

Vec3 lattice_point(Rng& rng, int reach) {
  const double x = rng.between(-reach, reach);
  const double y = rng.between(-reach, reach);
  const double z = rng.between(-reach, reach);
  return {x, y, z};
}

Moving lattice_motion(Rng& rng, int reach) {
  const Vec3 start = lattice_point(rng, reach);
  return {start, lattice_point(rng, reach)};
}

Query lattice(Kind kind, Rng& rng, int reach) {
  std::array<Moving, 4> corners{};
  for (auto& corner : corners) corner = lattice_motion(rng, reach);
  return query_of(kind, corners);
}

Query signed_zero(Kind kind, Rng& rng) {
  Query query = lattice(kind, rng, 1);
  for_each_coordinate(query, [&](double& x) {
    if (x == 0 && rng.one_in(2)) x = -0.0;
  });
  return query;
}

Query static_step(Kind kind, Rng& rng) {
  Query query = lattice(kind, rng, rng.between(1, 4));
  const int choice = rng.between(0, 3);  // 0: only the first element stands still; 1: only the second; else both
  const std::size_t first_of_b = element_sizes(kind).a;
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    const bool in_a = i < first_of_b;
    if (choice >= 2 || in_a == (choice == 0)) query.end[i] = query.start[i];
  }
  return query;
}

// Fewer than all corners move on their own, which lowers the degree of V: translation of everything, of one element,
// or of one corner.
Query few_moving(Kind kind, Rng& rng) {
  Query query = lattice(kind, rng, 4);
  const Vec3 common = lattice_point(rng, 2);
  for (std::size_t i = 0; i < corner_count(kind); ++i) query.end[i] = query.start[i] + common;
  const Vec3 own = lattice_point(rng, 6);
  switch (rng.between(0, 2)) {
    case 0:
      for (std::size_t i = 0; i < element_sizes(kind).a; ++i) query.end[i] = query.end[i] + own;
      break;
    case 1: {
      const auto i = static_cast<std::size_t>(rng.between(0, static_cast<int>(corner_count(kind)) - 1));
      query.end[i] = query.end[i] + own;
      break;
    }
    default: break;
  }
  return query;
}

}  // namespace touchstone::families::makers
