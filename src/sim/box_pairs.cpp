// SPDX-License-Identifier: MIT
#include "sim/box_pairs.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace touchstone::sim {
namespace {

using generators::Box;
using Number = std::uint32_t;

double longest_side(const Box& box) {
  return std::max({box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2]});
}

/// The numbers of the boxes that would lie in very many cells of a grid made for the others, and those of the others.
/// There are few large ones, or none: each is held against everything.
struct Sizes {
  std::vector<Number> large, usual;
  std::vector<Box> usual_boxes;

  explicit Sizes(const std::vector<Box>& boxes) {
    constexpr double kLarger = 8;
    constexpr std::size_t kMostLarge = 16;
    std::vector<double> sides;
    sides.reserve(boxes.size());
    for (const Box& box : boxes) sides.push_back(longest_side(box));
    double limit = 0;
    if (!sides.empty()) {
      std::vector<double> sorted = sides;
      const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
      std::nth_element(sorted.begin(), middle, sorted.end());
      limit = kLarger * *middle;
    }
    const auto many = std::count_if(sides.begin(), sides.end(), [limit](double side) { return side > limit; });
    const bool split = limit > 0 && static_cast<std::size_t>(many) <= kMostLarge;
    for (Number i = 0; i < boxes.size(); ++i) {
      if (split && sides[i] > limit) {
        large.push_back(i);
      } else {
        usual.push_back(i);
        usual_boxes.push_back(boxes[i]);
      }
    }
  }
};

}  // namespace

void for_each_pair(const std::vector<Box>& boxes, const generators::PairConsumer& found) {
  const Sizes sizes(boxes);
  generators::for_each_overlap(sizes.usual_boxes, [&](Number i, Number j) { found(sizes.usual[i], sizes.usual[j]); });
  for (std::size_t k = 0; k < sizes.large.size(); ++k) {
    const Number i = sizes.large[k];
    for (const Number j : sizes.usual) {
      if (generators::overlap(boxes[i], boxes[j])) found(std::min(i, j), std::max(i, j));
    }
    for (std::size_t l = k + 1; l < sizes.large.size(); ++l) {
      if (generators::overlap(boxes[i], boxes[sizes.large[l]])) found(i, sizes.large[l]);
    }
  }
}

void for_each_pair(const std::vector<Box>& a, const std::vector<Box>& b, const generators::PairConsumer& found) {
  const Sizes in_a(a), in_b(b);
  generators::for_each_overlap(in_a.usual_boxes, in_b.usual_boxes,
                               [&](Number i, Number j) { found(in_a.usual[i], in_b.usual[j]); });
  for (const Number i : in_a.large) {
    for (Number j = 0; j < b.size(); ++j) {
      if (generators::overlap(a[i], b[j])) found(i, j);
    }
  }
  for (const Number j : in_b.large) {
    for (const Number i : in_a.usual) {
      if (generators::overlap(a[i], b[j])) found(i, j);
    }
  }
}

}  // namespace touchstone::sim
