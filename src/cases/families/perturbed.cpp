// Queries that are hard for doubles: nearly degenerate, or small differences of large numbers.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "families/makers.hpp"

namespace touchstone::families::makers {
namespace {

double& random_coordinate(Query& query, Rng& rng) {
  const auto corner = static_cast<std::size_t>(rng.between(0, static_cast<int>(corner_count(query.kind)) - 1));
  auto& corners = rng.one_in(2) ? query.start : query.end;
  return coordinate(corners[corner], static_cast<std::size_t>(rng.between(0, 2)));
}

Vec3 random_point(Rng& rng, double reach) {
  const double x = reach * rng.symmetric();
  const double y = reach * rng.symmetric();
  const double z = reach * rng.symmetric();
  return {x, y, z};
}

}  // namespace

// Nearly parallel edges, nearly flat faces, nearly coplanar motion: a degenerate query with a few coordinates off by
// a little.
Query sliver(Kind kind, Rng& rng) {
  static constexpr std::array<Family, 7> bases{Family::parallel,   Family::flat,           Family::sliding,
                                               Family::collinear,  Family::planar_general, Family::moving_plane,
                                               Family::static_step};
  Query query = make(rng.pick(bases), kind, rng);
  const double tiny = std::ldexp(1.0, -rng.between(8, 49));
  for (int i = rng.between(1, 4); i > 0; --i) {
    double& x = random_coordinate(query, rng);
    x += rng.one_in(2) ? tiny : -tiny;
  }
  return query;
}

// One displacement for all corners but rounding noise and perhaps one ulp: the cubic's leading coefficients are noise.
Query near_rigid(Kind kind, Rng& rng) {
  Query query;
  query.kind = kind;
  const Vec3 displacement = random_point(rng, std::ldexp(1.0, rng.between(-20, 4)));
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    query.start[i] = random_point(rng, 1);
    query.end[i] = query.start[i] + displacement;
  }
  if (rng.one_in(2)) {
    double& x = random_coordinate(query, rng);
    x = std::nextafter(x, rng.one_in(2) ? 10.0 : -10.0);
  }
  if (rng.one_in(2)) {  // the first element stands still instead
    for (std::size_t i = 0; i < element_sizes(kind).a; ++i) query.end[i] = query.start[i];
  }
  return query;
}

// A lattice around a point that is far from the origin. Its spacing is one ulp there.
Query ulp_lattice(Kind kind, Rng& rng) {
  static constexpr std::array<double, 6> coordinates{1.0, 1.5, 0.1, -3.7, 1e8, 1.9999999};
  Query query = lattice(kind, rng, rng.between(1, 3));
  const Vec3 centre{rng.pick(coordinates), rng.pick(coordinates), rng.pick(coordinates)};
  return mapped_corners(query, [&](Vec3 corner) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double at = coordinate(centre, axis);
      const double ulp = std::nextafter(std::abs(at), std::numeric_limits<double>::infinity()) - std::abs(at);
      coordinate(corner, axis) = at + ulp * coordinate(corner, axis);
    }
    return corner;
  });
}

Sample far_offset(Kind kind, Rng& rng) {
  static constexpr std::array<Family, 6> bases{Family::prescribed,  Family::lattice4,       Family::sliding,
                                               Family::chain_joint, Family::grazing_merged, Family::parallel};
  static constexpr std::array<double, 6> offsets{0, 1e8, -1e8, 1e8, 0x1p40, -0x1p50};
  Sample sample = make_sample(rng.pick(bases), kind, rng);
  const double shrink = std::ldexp(1.0, -rng.between(0, 10));
  const Vec3 offset{rng.pick(offsets), rng.pick(offsets), rng.pick(offsets)};
  bool exact = true;
  sample.query = mapped_corners(sample.query, [&](const Vec3& corner) {
    const Vec3 small = shrink * corner;
    const Vec3 moved = offset + small;
    const Vec3 back = moved - offset;  // exact by Sterbenz's lemma or equal to `small` when nothing was lost
    exact = exact && back.x == small.x && back.y == small.y && back.z == small.z;
    return moved;
  });
  if (!exact) sample.touches_at.reset();
  return sample;
}

Query random_doubles(Kind kind, Rng& rng) {
  const double reach = std::ldexp(1.0, rng.between(-40, 40));
  std::array<Moving, 4> corners{};
  for (auto& corner : corners) {
    corner.start = random_point(rng, reach);
    corner.end = random_point(rng, reach);
  }
  return query_of(kind, corners);
}

// Pairs such as a broad phase finds: elements of size about 1, whose distance and displacement are fractions of that
// size.
Query simulation(Kind kind, Rng& rng) {
  std::array<Moving, 4> corners{};
  const std::size_t first_of_b = element_sizes(kind).a;
  const Vec3 centre = random_point(rng, 10);
  const Vec3 apart = random_point(rng, 0.5);
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    Vec3 start = centre + random_point(rng, 0.7);
    if (i >= first_of_b) start = start + apart;
    corners[i] = {start, start + random_point(rng, 0.2)};
  }
  return query_of(kind, corners);
}

}  // namespace touchstone::families::makers
