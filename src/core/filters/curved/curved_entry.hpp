// The first time at which two elements on curves are within a separation, in error-bounded arithmetic.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/answer.hpp>
#include <touchstone/curved_query.hpp>
#include <touchstone/separation.hpp>

#include "filters/curved/curved_frame.hpp"
#include "filters/question.hpp"

namespace touchstone::filters {

/// Whether and when the elements of a valid query come within a valid separation > 0 in [0, t_max]. On `contact` the
/// answer is complete, but for its level; otherwise it is untouched. Uncertain where the elements graze the separation,
/// where the exact time is a double, and where the closest points are not certainly the only ones.
/// @param frame  of the query, known
Outcome decide_entry(const CurvedQuery& query, const CurvedFrame& frame, const Separation& separation, double t_max,
                     Answer& answer) noexcept;

}  // namespace touchstone::filters
