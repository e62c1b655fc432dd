// A point and an edge that stay in one coordinate plane: scenes in two dimensions.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>

namespace touchstone::filters {

/// Two edges that touch when the point and the edge of a planar point-edge query do, and that have a coplanarity cubic:
/// the query's edge, laid into the plane z = 0, and a segment across that plane through the point. Nothing for other
/// kinds, when no coordinate is the same for all corners at all times, or when all corners stay in one place.
std::optional<Query> as_crossing_edges(const Query& query) noexcept;

/// Turns a complete answer about those edges, with a contact inside both of them, into the answer about the point and
/// the edge.
void name_point_and_edge(Answer& answer) noexcept;

}  // namespace touchstone::filters
