// Same side all along: the coplanarity cubic has no root in the step.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

#include "filters/step_frame.hpp"

namespace touchstone::filters {

/// The first test, for any coordinates, NaN and infinity included. True proves that the kind has a cubic, that the
/// coordinates are finite, and that there is no contact in [0, 1].
bool same_side(const Query& query) noexcept;

/// The same for a valid separation: True proves that the elements are farther apart than that all over [0, 1].
bool clear_all_along(const Query& query, const Separation& separation) noexcept;

}  // namespace touchstone::filters
