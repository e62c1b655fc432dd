// Queries that are too large or too small for the filters' products, or along one axis much larger than along another.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <touchstone/query.hpp>

namespace touchstone::filters {

/// The query with all coordinates along an axis times the power of two that makes the largest difference from the first
/// corner about 1, for each axis: it has the same answer. A scaling of an axis is an affine map: it keeps the elements,
/// the times at which they touch, their features and their weights, and it multiplies V by a positive number. Nothing
/// when the differences are of ordinary size along all axes already, when all are zero, or when a coordinate would be
/// rounded.
std::optional<Query> rescaled(const Query& query) noexcept;

/// A hint, from the corners at t = 0, that the filters' products are out of their range until the query is rescaled.
bool seems_extreme(const Query& query) noexcept;

}  // namespace touchstone::filters
