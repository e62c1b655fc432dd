// Queries that are too large or too small for the filters' products.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <touchstone/query.hpp>

namespace touchstone::filters {

/// The query with all coordinates times the power of two that makes the largest one about 1: it has the same answer.
/// Nothing when the largest one is of ordinary size already, when all are zero, or when a coordinate would be rounded.
std::optional<Query> rescaled(const Query& query) noexcept;

}  // namespace touchstone::filters
