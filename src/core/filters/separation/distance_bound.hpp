// An upper bound of a distance at one instant, in doubles.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include <touchstone/query.hpp>

namespace touchstone::filters {

/// How far the bound below is above the distance, as a part of it, at most.
constexpr double kLoosestBound = 0x1p-20;

/// A number that is at least the Euclidean distance of the two elements with these corners, and at most
/// 1 + kLoosestBound times it. Nothing for elements that are very near each other or nearly parallel, and for sizes at
/// which squares overflow or underflow.
std::optional<double> distance_bound(Kind kind, const std::array<Vec3, 4>& corners) noexcept;

}  // namespace touchstone::filters
