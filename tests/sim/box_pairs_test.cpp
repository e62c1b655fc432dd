// Every overlap once, among boxes of all sizes.
// SPDX-License-Identifier: MIT
#include "sim/box_pairs.hpp"

#include <cmath>
#include <set>
#include <utility>

#include "seeded/rng.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

namespace {

std::vector<generators::Box> random_boxes(seeded::Rng& random, std::size_t count, std::size_t large) {
  std::vector<generators::Box> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    generators::Box box;
    const double size = random.between(1, static_cast<int>(count)) <= static_cast<int>(large) ? 20 : 0.2;
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = 2 * random.symmetric();
      box.high[k] = box.low[k] + (random.one_in(9) ? 0 : size * random.unit());
    }
    boxes.push_back(box);
  }
  return boxes;
}

}  // namespace

TEST_CASE("each overlapping pair is found once, and no other") {
  seeded::Rng random(11);
  std::size_t found_in_all = 0;
  for (const std::size_t large : {0, 1, 5, 200}) {
    for (int round = 0; round < 20; ++round) {
      const auto a = random_boxes(random, 200, large), b = random_boxes(random, 150, large / 2);
      Pairs expected, expected_across, found, across;
      for (std::uint32_t i = 0; i < a.size(); ++i) {
        for (std::uint32_t j = i + 1; j < a.size(); ++j) {
          if (generators::overlap(a[i], a[j])) expected.insert({i, j});
        }
        for (std::uint32_t j = 0; j < b.size(); ++j) {
          if (generators::overlap(a[i], b[j])) expected_across.insert({i, j});
        }
      }
      sim::for_each_pair(a, [&](std::uint32_t i, std::uint32_t j) { CHECK(found.insert({i, j}).second); });
      sim::for_each_pair(a, b, [&](std::uint32_t i, std::uint32_t j) { CHECK(across.insert({i, j}).second); });
      CHECK(found == expected);
      CHECK(across == expected_across);
      found_in_all += found.size() + across.size();
    }
  }
  CHECK(found_in_all > 1000);
  sim::for_each_pair({}, [](std::uint32_t, std::uint32_t) { FAIL("there is nothing"); });
}
