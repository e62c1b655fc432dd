// Faces whose corners are on one line: at rest, exactly, and those that become so in a step.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <touchstone/touchstone.hpp>

#include "mesh/coinciding.hpp"
#include "seeded/rng.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;

TEST_CASE("a face is flat exactly if its corners are on one line") {
  seeded::Rng random(309);
  std::size_t flat = 0, nearly = 0;
  for (std::size_t round = 0; round < effort(3000); ++round) {
    // Integers, so that 64 bits hold the products, and doubles do not; then a scale that doubles hold.
    std::array<std::array<std::int64_t, 3>, 3> corner{};
    const std::int64_t reach = std::int64_t{1} << random.between(1, 27);
    const auto some = [&] {
      return static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(2 * reach))) - reach;
    };
    const int steps = random.between(-3, 3);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t from = some();
      const std::int64_t way = some();
      corner[0][k] = from;
      corner[1][k] = from + way;
      corner[2][k] = from + steps * way;
    }
    if (random.one_in(2)) corner[2][random.below(3)] += random.between(-1, 1);
    const auto area = [&](std::size_t i, std::size_t j) {
      const auto along = [&](std::size_t c, std::size_t k) { return corner[c][k] - corner[0][k]; };
      return along(1, i) * along(2, j) - along(1, j) * along(2, i);
    };
    const bool expected = area(0, 1) == 0 && area(1, 2) == 0 && area(2, 0) == 0;
    const double unit = std::ldexp(1.0, random.between(-1070, 980));
    MeshElements elements;
    elements.vertex_count = 3;
    elements.faces = {{0, 1, 2}};
    std::vector<double> x;
    for (const auto& at : corner) {
      for (const std::int64_t k : at) x.push_back(unit * static_cast<double>(k));
    }
    CAPTURE(round, x);
    REQUIRE(flat_faces(Mesh(elements), {x, 3}) == (expected ? 1 : 0));
    (expected ? flat : nearly) += 1;
    REQUIRE(turning_faces(Mesh(elements), {x, 3}, {x, 3}) >= (expected ? 1U : 0U));
  }
  CHECK((flat > 0 || !whole_effort("flat faces")));
  CHECK((nearly > 0 || !whole_effort("faces that are not flat")));
}

TEST_CASE("faces that become flat in a step are counted, and few others") {
  MeshElements elements;
  elements.vertex_count = 3;
  elements.faces = {{0, 1, 2}};
  const Mesh mesh(elements);
  const auto count = [&](const std::vector<double>& x0, const std::vector<double>& x1) {
    return turning_faces(mesh, {x0, 3}, {x1, 3});
  };
  const std::vector<double> up = {0, 0, 0, 4, 0, 0, 1, 1, 0}, down = {0, 0, 0, 4, 0, 0, 1, -1, 0};
  CHECK(count(up, down) == 1);
  CHECK(count(up, {0, 0, 0, 4, 0, 0, 2, 0, 0}) == 1);
  CHECK(count({0, 0, 0, 0, 0, 0, 0, 0, 0}, up) == 1);
  CHECK(count(up, {9, 9, 9, 13, 9, 9, 10, 9.5, 9.8}) == 0);  // it turns by less than a right angle
  CHECK(count(up, {0, 0, 0, 4, 0, 0, 1, 1e-100, 0}) == 0);   // nearly
  CHECK(count(up, {0, 0, 0, 4, 0, 0, 1, -1e-9, 0}) == 1);

  // Numbers that overflow or underflow prove nothing, and are counted.
  for (const double unit : {1e-320, 1e-290, 1e150, 1e300}) {
    const auto times = [&](std::vector<double> x) {
      for (double& value : x) value *= unit;
      return x;
    };
    CHECK(count(times(up), times(down)) == 1);
    CHECK(count(times(up), times({0, 0, 0, 4, 0, 0, 2, 0, 0})) == 1);
  }

  // By integers: on a lattice all that is flat at one of many times is counted, and an even motion never is.
  seeded::Rng random(20261128);
  int flat = 0;
  const int rounds = static_cast<int>(tests::effort(4000));
  for (int round = 0; round < rounds; ++round) {
    std::array<std::array<std::array<std::int64_t, 3>, 3>, 2> at{};
    std::array<std::vector<double>, 2> x;
    for (std::size_t end = 0; end < 2; ++end) {
      for (auto& corner : at[end]) {
        for (std::size_t k = 0; k < 3; ++k) {
          corner[k] = k == 2 && round % 2 == 0 ? 0 : random.between(-2, 2);
          x[end].push_back(static_cast<double>(corner[k]));
        }
      }
    }
    bool is_flat = false;
    constexpr std::int64_t kTimes = 12;
    for (std::int64_t t = 0; t <= kTimes && !is_flat; ++t) {
      const auto along = [&](std::size_t c, std::size_t k) {
        const auto value = [&](std::size_t i) { return (kTimes - t) * at[0][i][k] + t * at[1][i][k]; };
        return value(c) - value(0);
      };
      const auto area = [&](std::size_t i, std::size_t j) {
        return along(1, i) * along(2, j) - along(1, j) * along(2, i);
      };
      is_flat = area(0, 1) == 0 && area(1, 2) == 0 && area(2, 0) == 0;
    }
    CAPTURE(round, x[0], x[1]);
    if (is_flat) REQUIRE(count(x[0], x[1]) == 1);
    flat += is_flat ? 1 : 0;
    std::vector<double> moved = x[0];
    for (double& value : moved) value += 3;
    REQUIRE(count(x[0], moved) == flat_faces(mesh, {x[0], 3}));
  }
  CHECK((flat > rounds / 10 || !whole_effort("faces that become flat")));
}
