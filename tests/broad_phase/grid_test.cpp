// The grid finds exactly the pairs that comparing all boxes finds, each once.
// SPDX-License-Identifier: MIT
#include "broad_phase/grid.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "seeded/rng.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::broad_phase;

namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// Boxes with corners in a cube of size 1, with sides up to `side`.
std::vector<Box> random_boxes(std::size_t count, double side, touchstone::seeded::Rng& random) {
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    Box box = empty_box();
    const Vec3 low{random.unit(), random.unit(), random.unit()};
    extend(box, low);
    extend(box, {low.x + side * random.unit(), low.y + side * random.unit(), low.z + side * random.unit()});
    boxes.push_back(box);
  }
  return boxes;
}

Pairs sorted(Pairs pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

void check_within(const std::vector<Box>& boxes) {
  Pairs found, expected;
  for_each_overlap(boxes, [&](std::uint32_t i, std::uint32_t j) { found.emplace_back(i, j); });
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
      if (overlap(boxes[i], boxes[j])) expected.emplace_back(i, j);
    }
  }
  CHECK(sorted(found) == expected);
}

/// @returns how many pairs there are
std::size_t check_between(const std::vector<Box>& a, const std::vector<Box>& b) {
  Pairs found, expected;
  for_each_overlap(a, b, [&](std::uint32_t i, std::uint32_t j) { found.emplace_back(i, j); });
  for (std::uint32_t i = 0; i < a.size(); ++i) {
    for (std::uint32_t j = 0; j < b.size(); ++j) {
      if (overlap(a[i], b[j])) expected.emplace_back(i, j);
    }
  }
  CHECK(sorted(found) == expected);
  return expected.size();
}

}  // namespace

TEST_CASE("boxes overlap when they share a point, a corner being enough") {
  const Box box{{0, 0, 0}, {1, 1, 1}};
  CHECK(overlap(box, Box{{1, 1, 1}, {2, 2, 2}}));
  CHECK(overlap(box, Box{{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}}));
  CHECK(overlap(box, Box{{-1, -1, -1}, {2, 2, 2}}));
  for (std::size_t k = 0; k < 3; ++k) {
    Box apart = box;
    apart.low[k] = 1 + 0x1p-52;
    apart.high[k] = 2;
    CHECK_FALSE(overlap(box, apart));
    CHECK_FALSE(overlap(apart, box));
  }
}

TEST_CASE("the grid finds the pairs that brute force finds") {
  const double side = GENERATE(0.0, 0.001, 0.05, 0.5, 2.0);
  CAPTURE(side);
  touchstone::seeded::Rng random(7);
  const auto boxes = random_boxes(400, side, random);
  const auto others = random_boxes(300, 0.1, random);
  check_within(boxes);
  const std::size_t pairs = check_between(boxes, others);
  if (side >= 0.05) CHECK(pairs > 0);
}

TEST_CASE("a few boxes that are much larger than the others are found too") {
  touchstone::seeded::Rng random(8);
  auto boxes = random_boxes(500, 0.001, random);
  boxes.push_back({{0, 0, 0}, {1, 1, 1}});
  boxes.push_back({{-1e6, 0.5, 0}, {1e6, 0.5, 1}});
  check_within(boxes);
  CHECK(check_between(boxes, boxes) > 1000);
}

TEST_CASE("boxes that are points, one point, none, or far from the origin") {
  touchstone::seeded::Rng random(9);
  check_within({});
  CHECK(check_between({}, random_boxes(3, 1, random)) == 0);
  CHECK(check_between(random_boxes(3, 1, random), {}) == 0);
  check_within(std::vector<Box>(20, Box{{3, 4, 5}, {3, 4, 5}}));
  auto far = random_boxes(200, 0.2, random);
  for (Box& box : far) {
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] += 0x1p50;  // sides of zero or one quarter
      box.high[k] += 0x1p50;
    }
  }
  check_within(far);
}
