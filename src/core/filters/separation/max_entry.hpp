// The first time within a separation in the largest-axis metric, in error-bounded arithmetic.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

#include "filters/question.hpp"

namespace touchstone::filters {

/// decide_entry for Metric::max.
Outcome decide_max_entry(const Query& query, const Separation& separation, double t_max, Answer& answer) noexcept;

}  // namespace touchstone::filters
