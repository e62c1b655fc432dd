// Extreme magnitudes: whole queries, single axes, single corners and single coordinates times powers of two.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>

#include "families/makers.hpp"

namespace touchstone::families::makers {
namespace {

constexpr int kLeastExponent = -1060;
constexpr int kGreatestExponent = 1000;

int any_exponent(Rng& rng) { return rng.between(kLeastExponent, kGreatestExponent); }

// An exponent. Half of the time it is one at which products of two, three or four coordinates, or their low parts,
// begin to underflow or overflow.
int telling_exponent(Rng& rng) {
  static constexpr std::array<int, 10> telling{-537, -510, -358, -340, -322, -268, -250, 250, 341, 512};
  if (rng.one_in(2)) return any_exponent(rng);
  const int centre = rng.pick(telling);
  return centre + rng.between(-25, 25);
}

// A query of ordinary magnitude, most often one that touches by construction.
Sample base_sample(Kind kind, Rng& rng) {
  static constexpr std::array<Family, 24> bases{
      Family::lattice2, Family::lattice4,       Family::planar_general, Family::moving_plane, Family::shared_corner,
      Family::parallel, Family::sliding,        Family::flat,           Family::prescribed,   Family::prescribed,
      Family::at_start, Family::at_end,         Family::chain_joint,    Family::near_hit,     Family::near_hit,
      Family::near_hit, Family::grazing_merged, Family::grazing_apart,  Family::grazing_gone, Family::irrational_joint,
      Family::layers,   Family::sliver,         Family::ulp_lattice,    Family::simulation};
  for (;;) {
    Sample sample = make_sample(rng.pick(bases), kind, rng);
    double largest = 0;
    for_each_coordinate(sample.query, [&](double& x) { largest = std::max(largest, std::fabs(x)); });
    if (largest <= 0x1p8) return sample;  // else the greatest scales would overflow
  }
}

// Each axis times its own power of two. A contact stays one unless an underflow rounds.
Sample scaled(Sample sample, const std::array<int, 3>& exponents) {
  bool exact = true;
  sample.query = mapped_corners(sample.query, [&](Vec3 corner) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double& x = coordinate(corner, axis);
      const double before = x;
      x = std::ldexp(x, exponents[axis]);
      exact = exact && std::ldexp(x, -exponents[axis]) == before;
    }
    return corner;
  });
  if (!exact) sample.touches_at.reset();
  return sample;
}

}  // namespace

Sample uniform_scale(Kind kind, Rng& rng) {
  const Sample sample = base_sample(kind, rng);
  const int exponent = telling_exponent(rng);
  return scaled(sample, {exponent, exponent, exponent});
}

Sample axis_scale(Kind kind, Rng& rng) {
  const Sample sample = base_sample(kind, rng);
  const int x = any_exponent(rng);
  const int y = any_exponent(rng);
  return scaled(sample, {x, y, any_exponent(rng)});
}

Query subnormal(Kind kind, Rng& rng) {
  switch (rng.between(0, 3)) {
    case 0: return scaled({lattice(kind, rng, 4), {}}, {-1074, -1074, -1074}).query;
    case 1: {
      const int exponent = rng.between(-1074, -1020);
      return scaled(base_sample(kind, rng), {exponent, exponent, exponent}).query;
    }
    case 2: {  // 52 random bits, some of them leading zeros
      Query query = lattice(kind, rng, 4);
      for_each_coordinate(query, [&](double& x) {
        const double significand = rng.symmetric();
        x = std::ldexp(significand, rng.between(-1060, -1021));
      });
      return query;
    }
    default: {  // subnormals among ordinary numbers
      Query query = lattice(kind, rng, 2);
      for_each_coordinate(query, [&](double& x) {
        if (rng.one_in(3)) x = std::ldexp(x, -1074);
      });
      return query;
    }
  }
}

// Where differences, let alone products, overflow.
Query huge(Kind kind, Rng& rng) {
  Query query = lattice(kind, rng, 3);
  constexpr double kMax = std::numeric_limits<double>::max();
  static constexpr std::array<double, 8> extremes{kMax, -kMax, kMax, -kMax, 0, 1, kMax / 2, -kMax / 2};
  switch (rng.between(0, 3)) {
    case 0: return scaled({query, {}}, {1021, 1021, 1021}).query;
    case 1: return scaled(base_sample(kind, rng), {1015, 1015, 1015}).query;
    case 2: for_each_coordinate(query, [&](double& x) { x = rng.pick(extremes); }); break;
    default: for_each_coordinate(query, [&](double& x) { x = std::ldexp(rng.symmetric(), 1023); }); break;
  }
  return query;
}

Query corner_scale(Kind kind, Rng& rng) {
  Query query = rng.one_in(2) ? lattice(kind, rng, 2) : base_sample(kind, rng).query;
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    const int exponent = any_exponent(rng);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      coordinate(query.start[i], axis) = std::ldexp(coordinate(query.start[i], axis), exponent);
      coordinate(query.end[i], axis) = std::ldexp(coordinate(query.end[i], axis), exponent);
    }
  }
  return query;
}

// An exponent for every coordinate, drawn from a few so that equal magnitudes meet.
Query mixed_scale(Kind kind, Rng& rng) {
  Query query = lattice(kind, rng, 2);
  std::array<int, 4> pool{};
  for (int& exponent : pool) exponent = any_exponent(rng);
  const bool pooled = !rng.one_in(4);
  for_each_coordinate(query, [&](double& x) { x = std::ldexp(x, pooled ? rng.pick(pool) : any_exponent(rng)); });
  return query;
}

}  // namespace touchstone::families::makers
