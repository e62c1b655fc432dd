// The boxes around two elements' paths.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <touchstone/query.hpp>

#include "filters/coplanarity_form.hpp"

namespace touchstone::filters {

/// Whether the ranges of two elements' paths along an axis are farther apart than the distance. corner(side, i) is the
/// coordinate of corner i at the step's start (side 0) or end (1); the elements have `count` corners, the first one
/// `first_count` of them. The text is written once, for doubles and for packs of them.
template <class N, class Corner>
TOUCHSTONE_INLINE auto ranges_apart(std::size_t first_count, std::size_t count, const N& distance,
                                    const Corner& corner) {
  struct Range {
    N low, high;
  };
  const auto range = [&corner](std::size_t begin, std::size_t end) {
    Range r = {smaller(corner(0, begin), corner(1, begin)), larger(corner(0, begin), corner(1, begin))};
    for (std::size_t i = begin + 1; i < end; ++i) {
      r.low = smaller(smaller(r.low, corner(0, i)), corner(1, i));
      r.high = larger(larger(r.high, corner(0, i)), corner(1, i));
    }
    return r;
  };
  const Range first = range(0, first_count), second = range(first_count, count);
  // A difference that is rounded to more than a double is more than it: rounding is monotone.
  return (second.low - first.high > distance) | (first.low - second.high > distance);
}

/// True proves that the boxes around the two elements' paths are disjoint. It compares the query's own doubles: nothing
/// is rounded.
bool boxes_disjoint(const Query& query) noexcept;

/// True proves that the boxes are farther apart than the distance along some axis: every two points of the elements
/// are, in both metrics.
bool boxes_apart(const Query& query, double distance) noexcept;

}  // namespace touchstone::filters
