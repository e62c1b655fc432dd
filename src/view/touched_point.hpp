// Where elements touch, in doubles: for marks in a drawing.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>

#include "view/animation.hpp"

namespace touchstone::view {

/// The touched point of the first element at the time of a contact.
Triple touched_point(const Query& query, const Answer& answer) noexcept;

}  // namespace touchstone::view
