// The distance of two elements at one time, in double-doubles.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

namespace touchstone::filters {

/// As distance(), where the elements are certainly apart and have one pair of closest points, whose features have room
/// beside them, and double-doubles tell which double is nearest.
std::optional<Distance> precise_distance(const Query& query, double t, Metric metric) noexcept;

/// As compare_distance under the same conditions, and 0 elsewhere.
int precise_side_of_distance(const Query& query, double t, const Separation& separation) noexcept;

}  // namespace touchstone::filters
