// Queries with a contact at a known dyadic time and known dyadic weights, exact in doubles, and their neighbours.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "families/makers.hpp"

namespace touchstone::families::makers {
namespace {

// A coordinate on a lattice of spacing 2^(2 - bits) within [-4, 4].
double grid_number(Rng& rng, int bits) {
  const int reach = 1 << bits;
  return std::ldexp(rng.between(-reach, reach), 2 - bits);
}

Vec3 grid_point(Rng& rng, int bits) {
  const double x = grid_number(rng, bits);
  const double y = grid_number(rng, bits);
  const double z = grid_number(rng, bits);
  return {x, y, z};
}

Moving grid_motion(Rng& rng, int bits) {
  const Vec3 start = grid_point(rng, bits);
  return {start, grid_point(rng, bits)};
}

// Exact when time is a small dyadic and the corners lie on a lattice.
Vec3 moving_point(const Moving& corner, double time) { return corner.start + time * (corner.end - corner.start); }

// Barycentric coordinates in eighths, one of which (returned second) is a power of two.
struct Weights {
  std::array<double, 3> value{};
  std::size_t power_of_two = 0;
};

Weights random_weights(std::size_t corners, Rng& rng, Where where) {
  Weights weights;
  const auto last = static_cast<int>(corners) - 1;
  if (corners == 1 || where == Where::joint) {
    weights.power_of_two = static_cast<std::size_t>(rng.between(0, last));
    weights.value[weights.power_of_two] = 1;
    return weights;
  }
  static constexpr std::array<std::array<double, 3>, 7> edge{
      {{0.5, 0.5}, {0.25, 0.75}, {0.125, 0.875}, {0.5, 0.5}, {0.25, 0.75}, {1, 0}, {1, 0}}};
  static constexpr std::array<std::array<double, 3>, 7> face{{{0.5, 0.25, 0.25},
                                                              {0.25, 0.25, 0.5},
                                                              {0.125, 0.5, 0.375},
                                                              {0.5, 0.5, 0},
                                                              {0.25, 0.75, 0},
                                                              {1, 0, 0},
                                                              {0.125, 0.125, 0.75}}};
  const std::array<double, 3>& chosen = corners == 2 ? rng.pick(edge) : rng.pick(face);
  const auto turn = static_cast<std::size_t>(rng.between(0, last));
  for (std::size_t i = 0; i < corners; ++i) weights.value[(i + turn) % corners] = chosen[i];
  weights.power_of_two = turn;  // the first entry of every row
  return weights;
}

// Adds one ulp to a coordinate, up or down; of zero it makes the least subnormal.
void move_one_ulp(double& x, Rng& rng) {
  const double infinity = std::numeric_limits<double>::infinity();
  x = std::nextafter(x, rng.one_in(2) ? infinity : -infinity);
}

}  // namespace

double dyadic_time(Rng& rng) {
  const int bits = rng.between(1, 6);
  return std::ldexp(rng.between(1, (1 << bits) - 1), -bits);
}

// Every corner is random except one. That corner has a weight that is a power of two, and is placed so that the
// weighted sums agree at `time`.
Sample prescribed(Kind kind, Rng& rng, double time, Where where) {
  static constexpr std::array<int, 4> widths{2, 3, 8, 17};
  const int bits = rng.pick(widths);
  const ElementSizes sizes = element_sizes(kind);
  const Weights wa = random_weights(sizes.a, rng, where);
  const Weights wb = random_weights(sizes.b, rng, where == Where::joint && rng.one_in(2) ? Where::anywhere : where);
  std::array<Moving, 4> corners{};
  Vec3 difference;  // the touching point on b less that on a, without the corner to be solved for
  const std::size_t solved = wa.power_of_two;
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    corners[i] = grid_motion(rng, bits);
    if (i == solved) continue;
    const double weight = i < sizes.a ? -wa.value[i] : wb.value[i - sizes.a];
    difference = difference + weight * moving_point(corners[i], time);
  }
  const Vec3 target = (1 / wa.value[solved]) * difference;
  const Vec3 velocity = rng.one_in(4) ? Vec3{} : grid_point(rng, bits);
  corners[solved].start = target - time * velocity;
  corners[solved].end = corners[solved].start + velocity;
  return {query_of(kind, corners), time};
}

Sample chain_joint(Kind kind, Rng& rng) {
  Sample sample = prescribed(kind, rng, dyadic_time(rng), Where::joint);
  if (rng.one_in(2)) {
    const auto corner = static_cast<std::size_t>(rng.between(0, static_cast<int>(corner_count(kind)) - 1));
    auto& corners = rng.one_in(2) ? sample.query.start : sample.query.end;
    move_one_ulp(coordinate(corners[corner], static_cast<std::size_t>(rng.between(0, 2))), rng);
    sample.touches_at.reset();
  }
  return sample;
}

// Moves one coordinate by far less than an ulp of its neighbours: everything is translated so that it is zero at one
// end, which is exact, and then it is 2^-50 to 2^-140.
Query moved_by_a_tiny_bit(Query query, Rng& rng) {
  const auto corner = static_cast<std::size_t>(rng.between(0, static_cast<int>(corner_count(query.kind)) - 1));
  const auto axis = static_cast<std::size_t>(rng.between(0, 2));
  auto& corners = rng.one_in(2) ? query.start : query.end;
  const double origin = coordinate(corners[corner], axis);
  for (Vec3& each : corners) coordinate(each, axis) -= origin;
  const double sign = rng.one_in(2) ? 1.0 : -1.0;
  coordinate(corners[corner], axis) = std::ldexp(sign, -rng.between(50, 140));
  return query;
}

Query near_hit(Kind kind, Rng& rng) {
  static constexpr std::array<double, 2> ends{0, 1};
  const double time = rng.one_in(4) ? rng.pick(ends) : dyadic_time(rng);
  Query query = prescribed(kind, rng, time, rng.one_in(3) ? Where::joint : Where::anywhere).query;
  if (rng.one_in(2)) return moved_by_a_tiny_bit(query, rng);
  const bool zero_may_move = rng.one_in(4);
  const int moves = rng.one_in(4) ? 2 : 1;
  for (int done = 0, tries = 0; done < moves && tries < 100; ++tries) {
    const auto corner = static_cast<std::size_t>(rng.between(0, static_cast<int>(corner_count(kind)) - 1));
    auto& corners = rng.one_in(2) ? query.start : query.end;
    double& x = coordinate(corners[corner], static_cast<std::size_t>(rng.between(0, 2)));
    if (x == 0 && !zero_may_move) continue;
    move_one_ulp(x, rng);
    ++done;
  }
  return query;
}

}  // namespace touchstone::families::makers
