// A separating plane may move: elements that fly together are apart although their paths
// overlap. Exact positions at times between the ends check each claim of separation.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>

#include "filters/apart/separating_direction.hpp"
#include "filters/deciding_test.hpp"
#include "geometry/kind_traits.hpp"
#include "numbers/integers/exact_number.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/query_text.hpp"

using namespace touchstone;
using namespace touchstone::tests;
using filters::Test;
using geometry::corners_of_first;
using numbers::Exact;

namespace {

Vec3 plus(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

/// Two edges along (1, 1, 0): the second begins `gap` behind the end of the first, and moves by `motion_b`.
Query in_one_line(double gap, const Vec3& motion_a, const Vec3& motion_b) {
  Query query;
  query.start = {{{0, 0, 0}, {1, 1, 0}, {1 + gap, 1 + gap, 0}, {2 + gap, 2 + gap, 0}}};
  for (std::size_t i = 0; i < 4; ++i) query.end[i] = plus(query.start[i], i < 2 ? motion_a : motion_b);
  return query;
}

/// 8 times the place of a corner along d at t = eighths / 8.
Exact place(const Query& query, std::size_t corner, const filters::Vector& d, int eighths) {
  const auto along = [&](const Vec3& x) {
    return Exact(x.x) * Exact(d[0]) + Exact(x.y) * Exact(d[1]) + Exact(x.z) * Exact(d[2]);
  };
  return Exact(8.0 - eighths) * along(query.start[corner]) + Exact(eighths) * along(query.end[corner]);
}

/// Whether every corner of the second element is above (below) every corner of the first at that time.
std::array<bool, 2> above_and_below(const Query& query, const filters::Vector& d, int eighths) {
  std::array<bool, 2> all{true, true};
  for (std::size_t i = 0; i < corners_of_first(query.kind); ++i) {
    for (std::size_t j = corners_of_first(query.kind); j < corner_count(query.kind); ++j) {
      const Exact a = place(query, i, d, eighths), b = place(query, j, d, eighths);
      all[0] = all[0] && a < b;
      all[1] = all[1] && b < a;
    }
  }
  return all;
}

/// Elements that fly together, a few roundings or a lot apart along `direction`, or that pass each other.
Query flying_together(Kind kind, Rng& rng, filters::Vector& direction) {
  const double size = std::ldexp(1 + rng.unit(), rng.between(-20, 20));
  const auto vector = [&](double scale) {
    return Vec3{scale * rng.symmetric(), scale * rng.symmetric(), scale * rng.symmetric()};
  };
  const Vec3 d = vector(1);
  direction = {{d.x, d.y, d.z}};
  const Vec3 motion = vector(size * rng.between(0, 64));
  const double gap = size * std::ldexp(rng.unit(), -rng.between(0, 60));
  Query query;
  query.kind = kind;
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    const bool first = i < corners_of_first(kind);
    for (auto* at : {&query.start, &query.end}) {
      // A corner of either element lies in the plane, or gap away from it; others are farther.
      const double away = (rng.one_in(2) ? 0 : size * rng.unit()) + (first ? 0 : gap);
      const double side = first ? -away : away;
      (*at)[i] = {side * d.x, side * d.y, side * d.z};
      if (at == &query.end) (*at)[i] = plus((*at)[i], motion);
    }
  }
  if (rng.one_in(3)) std::swap(query.end[0], query.end[corner_count(kind) - 1]);
  return query;
}

}  // namespace

TEST_CASE("elements that fly in a line one after the other are apart, and are not when one passes the other") {
  const Vec3 far{10, 10, 0}, back{-10, -10, 0};
  CHECK(deciding_test(in_one_line(1, far, far)) == Test::separated);
  CHECK(deciding_test(in_one_line(0x1p-40, far, far)) == Test::separated);
  CHECK(deciding_test(in_one_line(1, far, {9.5, 9.5, 0})) == Test::separated);
  CHECK(deciding_test(in_one_line(0, far, far)) == Test::none);
  CHECK(deciding_test(in_one_line(1, far, back)) == Test::none);
  CHECK(deciding_test(in_one_line(1, far, {9, 9, 0})) == Test::none);  // touch at the end
  CHECK(deciding_test(in_one_line(-4, back, far)) == Test::none);      // the same, the other way round
}

TEST_CASE("along a direction that separates, one element is above the other at all times") {
  Rng rng(0x317e);
  long separated = 0, moving = 0, not_separated = 0;
  for (int i = 0; i < 40'000; ++i) {
    const Kind kind = kKinds[static_cast<std::size_t>(rng.between(0, 3))];
    filters::Vector direction;
    const Query query = flying_together(kind, rng, direction);
    if (!filters::separates(filters::relative_corners(query), direction)) {
      ++not_separated;
      continue;
    }
    ++separated;
    std::array<bool, 2> apart{true, true};
    for (int eighths = 0; eighths <= 8; ++eighths) {
      const auto now = above_and_below(query, direction, eighths);
      for (std::size_t side = 0; side < 2; ++side) apart[side] = apart[side] && now[side];
    }
    INFO(cpp_initializer(query) << "  along " << direction[0] << ' ' << direction[1] << ' ' << direction[2]);
    REQUIRE((apart[0] || apart[1]));
    // No plane that stands still would do: the first element's end is beyond the second one's start.
    const std::size_t second = corners_of_first(kind);
    const bool beyond = apart[0] ? place(query, second, direction, 0) < place(query, 0, direction, 8)
                                 : place(query, 0, direction, 8) < place(query, second, direction, 0);
    moving += beyond ? 1 : 0;
  }
  CHECK(separated > 5000);
  CHECK(moving > 2000);
  CHECK(not_separated > 5000);
}
