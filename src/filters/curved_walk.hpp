// Directions that keep two elements on curves apart, each for a part of the step.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/curved_query.hpp>
#include <touchstone/separation.hpp>

#include "filters/curved_frame.hpp"

namespace touchstone::filters {

/// Whether directions, each for a part of the step, show that the elements are farther from each other than a
/// separation >= 0 at all times in [0, t_max].
/// @param frame  of the query, known
bool certainly_farther_in_parts(const CurvedQuery& query, const CurvedFrame& frame, const Separation& separation,
                                double t_max) noexcept;

}  // namespace touchstone::filters
