// Elements that share a corner throughout the step: neighbours in a mesh. SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>

namespace touchstone::filters {

/// Whether the elements certainly touch at t = 0 in a corner that both have at either end of the step, and nowhere else
/// then. The corner moves with both, so they touch at all times and V is identically zero: `answer` becomes the complete
/// answer but for its level. False when they share no corner or when it is uncertain that they share no more.
bool touch_in_shared_corner(const Query& query, double t_max, Answer& answer) noexcept;

}  // namespace touchstone::filters
