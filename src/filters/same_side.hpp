// Same side all along: the coplanarity cubic has no root in the step. SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/query.hpp>

#include "filters/step_frame.hpp"

namespace touchstone::filters {

/// The first test, for any coordinates, NaN and infinity included. True proves that the kind has a cubic, that the
/// coordinates are finite, and that there is no contact in [0, 1].
bool same_side(const Query& query) noexcept;

}  // namespace touchstone::filters
