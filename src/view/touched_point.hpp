// Where elements touch, in doubles: for marks in a drawing.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>

#include "view/animation.hpp"

namespace touchstone::view {

/// The touched point of the first element at the time of a contact.
Triple touched_point(const Query& query, const Answer& answer) noexcept;

/// A point at which two elements meet that have these corners: a point as it is, an edge in the plane of the face. The
/// middle of the edge without a plane, or along one.
Triple meeting_point(const std::vector<Triple>& first, const std::vector<Triple>& second) noexcept;

}  // namespace touchstone::view
