// The boxes around two elements' paths.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <touchstone/query.hpp>

namespace touchstone::filters {

/// How many corners the first element has; the others are the second one's.
constexpr std::size_t corners_of_first(Kind kind) noexcept { return kind == Kind::edge_edge ? 2 : 1; }

/// True proves that the boxes around the two elements' paths are disjoint. It compares the query's own doubles: nothing
/// is rounded.
bool boxes_disjoint(const Query& query) noexcept;

/// True proves that the boxes are farther apart than the distance along some axis: every two points of the elements
/// are, in both metrics.
bool boxes_apart(const Query& query, double distance) noexcept;

}  // namespace touchstone::filters
