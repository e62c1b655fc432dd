// How the time of the entry into a Euclidean separation changes with the corners, in double-doubles.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>

#include "geometry/end_gradients.hpp"
#include "numbers/doubles/bounded.hpp"

namespace touchstone::filters {

/// Writes the gradient of the time as touchstone/toi_gradient.hpp defines it. False where double-doubles do not tell
/// it; the gradient is then undefined.
/// @param entry  an entry as decide_entry finds it, after t = 0
/// @param time   its time
bool entry_gradient(const Query& query, const Answer& entry, const numbers::BoundedPair& time,
                    geometry::EndGradients& gradient) noexcept;

}  // namespace touchstone::filters
