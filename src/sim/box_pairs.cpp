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

/// The longest side of a box in the middle, 0 when there is none.
double median_side(const std::vector<Box>& boxes) {
  std::vector<double> sides;
  sides.reserve(boxes.size());
  for (const Box& box : boxes) sides.push_back(longest_side(box));
  if (sides.empty()) return 0;
  const auto middle = sides.begin() + static_cast<std::ptrdiff_t>(sides.size() / 2);
  std::nth_element(sides.begin(), middle, sides.end());
  return *middle;
}

/// The numbers of the boxes that would lie in very many cells of a grid made for boxes of the usual side, and those of
/// the others. There are few large ones, or none: each is held against everything.
struct Sizes {
  std::vector<Number> large, usual;
  std::vector<Box> usual_boxes;

  Sizes(const std::vector<Box>& boxes, double usual_side) {
    constexpr double kLarger = 8;
    constexpr std::size_t kMostLarge = 16;
    const auto is_large = [&](const Box& box) { return longest_side(box) > kLarger * usual_side; };
    const auto many = static_cast<std::size_t>(std::count_if(boxes.begin(), boxes.end(), is_large));
    const bool split = usual_side > 0 && many <= kMostLarge;
    usual.reserve(boxes.size());
    usual_boxes.reserve(boxes.size());
    for (Number i = 0; i < boxes.size(); ++i) {
      if (split && is_large(boxes[i])) {
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
  const Sizes sizes(boxes, median_side(boxes));
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
  // A floor of two faces is large beside what falls on it, though not beside itself.
  const double side_a = median_side(a), side_b = median_side(b);
  const double usual_side = a.empty() || b.empty() ? 0 : std::min(side_a, side_b);
  const Sizes in_a(a, usual_side), in_b(b, usual_side);
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
