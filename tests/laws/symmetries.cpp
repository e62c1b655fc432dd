// Maps of space that keep every answer: reflections, permuted axes, powers of two, translations, a common velocity,
// integer shears, and the sign of zero.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <utility>

#include "laws/law.hpp"

namespace touchstone::tests {
namespace {

constexpr std::uint64_t kSeed = 11;

// The mapped query must have the same answer.
Finding same_answer(const Query& query, const Query& mapped, Method method) {
  return difference(solve(query, {.method = method}), solve(mapped, {.method = method}), mapped);
}

// Multiplies each axis by its power of two; nothing when a coordinate does not survive that exactly.
std::optional<Query> scaled(const Query& query, const std::array<int, 3>& exponents) {
  bool exact = true;
  const Query mapped = mapped_corners(query, [&](Vec3 corner) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double& x = coordinate(corner, axis);
      const double before = x;
      x = std::ldexp(x, exponents[axis]);
      exact = exact && std::isfinite(x) && std::ldexp(x, -exponents[axis]) == before;
    }
    return corner;
  });
  if (!exact) return std::nullopt;
  return mapped;
}

// a + b, noting whether it is exact: Knuth's two-sum.
double exact_sum(double a, double b, bool& exact) {
  const double sum = a + b;
  const double part = sum - a;
  const double error = (a - (sum - part)) + (b - part);
  exact = exact && error == 0;
  return sum;
}

// Adds one vector to the corners at the start and one to those at the end; nothing when a sum is inexact.
std::optional<Query> translated(Query query, const Vec3& at_start, const Vec3& at_end) {
  bool exact = true;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double& start = coordinate(query.start[i], axis);
      double& end = coordinate(query.end[i], axis);
      start = exact_sum(start, coordinate(at_start, axis), exact);
      end = exact_sum(end, coordinate(at_end, axis), exact);
    }
  }
  if (!exact) return std::nullopt;
  return query;
}

Vec3 integer_vector(Rng& rng, int reach) {
  const double x = rng.between(-reach, reach);
  const double y = rng.between(-reach, reach);
  const double z = rng.between(-reach, reach);
  return {x, y, z};
}

TEST_CASE("law: a mirror changes nothing") {
  check_law(kSeed, 150, every_family, 1, [](const Query& query, Method method, Rng& rng) {
    const int axes = rng.between(1, 7);
    const Query mirrored = mapped_corners(query, [&](Vec3 corner) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (axes >> axis & 1) coordinate(corner, axis) = -coordinate(corner, axis);
      }
      return corner;
    });
    return same_answer(query, mirrored, method);
  });
}

TEST_CASE("law: permuting the axes changes nothing") {
  check_law(kSeed, 150, every_family, 1, [](const Query& query, Method method, Rng& rng) {
    const int choice = rng.between(0, 4);
    const Query permuted = mapped_corners(query, [&](Vec3 c) {
      switch (choice) {
        case 0: return Vec3{c.y, c.z, c.x};
        case 1: return Vec3{c.z, c.x, c.y};
        case 2: return Vec3{c.y, c.x, c.z};
        case 3: return Vec3{c.x, c.z, c.y};
        default: return Vec3{c.z, c.y, c.x};
      }
    });
    return same_answer(query, permuted, method);
  });
}

TEST_CASE("law: a power of two changes nothing") {
  check_law(kSeed, 200, every_family, 0.25, [](const Query& query, Method method, Rng& rng) -> Finding {
    const int exponent = rng.one_in(2) ? rng.between(-60, 60) : rng.between(-1060, 1000);
    const std::optional<Query> mapped = scaled(query, {exponent, exponent, exponent});
    if (!mapped) return std::nullopt;
    return same_answer(query, *mapped, method);
  });
}

TEST_CASE("law: a power of two for each axis changes nothing") {
  check_law(kSeed, 200, every_family, 0.25, [](const Query& query, Method method, Rng& rng) -> Finding {
    const int reach = rng.one_in(2) ? 60 : 1000;
    const int x = rng.between(-reach, reach);
    const int y = rng.between(-reach, reach);
    const std::optional<Query> mapped = scaled(query, {x, y, rng.between(-reach, reach)});
    if (!mapped) return std::nullopt;
    return same_answer(query, *mapped, method);
  });
}

TEST_CASE("law: an exact translation changes nothing") {
  check_law(kSeed, 200, dyadic_families, 1, [](const Query& query, Method method, Rng& rng) -> Finding {
    const Vec3 offset = integer_vector(rng, rng.one_in(2) ? 16 : 1 << 20);
    const std::optional<Query> mapped = translated(query, offset, offset);
    if (!mapped) return std::nullopt;
    return same_answer(query, *mapped, method);
  });
}

TEST_CASE("law: a common velocity changes nothing") {
  check_law(kSeed, 200, dyadic_families, 1, [](const Query& query, Method method, Rng& rng) -> Finding {
    const Vec3 at_start = integer_vector(rng, 1 << 10);
    const std::optional<Query> mapped = translated(query, at_start, integer_vector(rng, 1 << 10));
    if (!mapped) return std::nullopt;
    return same_answer(query, *mapped, method);
  });
}

TEST_CASE("law: an integer shear changes nothing") {
  check_law(kSeed, 200, dyadic_families, 1, [](const Query& query, Method method, Rng& rng) {
    auto to = static_cast<std::size_t>(rng.between(0, 2));
    const std::size_t from = (to + static_cast<std::size_t>(rng.between(1, 2))) % 3;
    const double factor = rng.one_in(2) ? rng.between(-3, 3) : rng.between(-1000, 1000);
    // Multiples of 2^-30 below 2^10 times an integer below 2^10, plus another: at most 52 bits, exact.
    const Query sheared = mapped_corners(query, [&](Vec3 corner) {
      coordinate(corner, to) += factor * coordinate(corner, from);
      return corner;
    });
    return same_answer(query, sheared, method);
  });
}

TEST_CASE("law: the sign of zero changes nothing") {
  const auto with_zeros = [](const FamilyInfo& family, Kind) { return family.group != Group::perturbed; };
  check_law(kSeed, 150, with_zeros, 0.5, [](const Query& query, Method method, Rng& rng) -> Finding {
    Query flipped = query;
    bool any = false;
    for_each_coordinate(flipped, [&](double& x) {
      if (x != 0 || rng.one_in(3)) return;
      x = -x;
      any = true;
    });
    if (!any) return std::nullopt;
    const Answer expected = solve(query, {.method = method});
    const Answer found = solve(flipped, {.method = method});
    if (method == Method::exact) return bit_difference(expected, found, true);
    return difference(expected, found, flipped);  // a filter may take another way to the same answer
  });
}

}  // namespace
}  // namespace touchstone::tests
