// A point and an edge that stay in one coordinate plane: scenes in two dimensions. SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>

namespace touchstone::filters {

/// Two edges that touch when the point and the edge of a point-edge query do, and have a coplanarity cubic: the edge, laid into
/// the plane z = 0, and a segment across that plane through the point. False, with `edges` untouched, when no coordinate is
/// the same for all corners at all times, or all corners stay in one place.
bool as_crossing_edges(const Query& point_edge, Query& edges) noexcept;

/// The answer about the point and the edge from a complete one with contact inside both of those edges.
void name_point_and_edge(Answer& answer) noexcept;

}  // namespace touchstone::filters
