// Elements that share a corner throughout the step: neighbours in a mesh.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>

namespace touchstone::filters {

/// Whether the elements certainly touch at t = 0 in a corner that both have at both ends of the step, and nowhere else
/// at t = 0. The corner moves with both elements, so they touch at all times and V is identically zero. When true,
/// `answer` is complete except for its level. When false, they share no corner or it is uncertain whether they share
/// more.
bool touch_in_shared_corner(const Query& query, double t_max, Answer& answer) noexcept;

}  // namespace touchstone::filters
