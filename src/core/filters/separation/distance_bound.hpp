// Bounds of the distance of two elements, in doubles.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

namespace touchstone::filters {

/// How far the bound below is above the distance, as a part of it, at most.
constexpr double kLoosestBound = 0x1p-20;

/// A number that is at least the Euclidean distance of the elements at the time t, and at most 1 + kLoosestBound times
/// it. Nothing for elements that are very near each other or nearly parallel, and for sizes at which squares overflow
/// or underflow.
std::optional<double> distance_bound(const Query& query, double t) noexcept;

/// A number that the Euclidean distance of the elements is at least at all times of [0, 1], perhaps 0: how far a plane
/// keeps them apart that is perpendicular to the shortest line between them at the start, or at the end.
double least_distance(const Query& query) noexcept;

/// As compare_distance where doubles tell, and 0 elsewhere.
int side_of_distance(const Query& query, double t, const Separation& separation) noexcept;

}  // namespace touchstone::filters
