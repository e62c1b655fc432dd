// The pairs of boxes that overlap: a uniform grid. The time is nearly linear in the number of boxes if their sizes are
// similar.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "broad_phase/box.hpp"

namespace touchstone::broad_phase {

/// Calls found(i, j) once for each i < j whose boxes overlap, and for no other pair. The order of the calls depends on
/// the boxes only.
void for_each_overlap(const std::vector<Box>& boxes, const PairConsumer& found);

/// The same for box i of `a` and box j of `b`.
void for_each_overlap(const std::vector<Box>& a, const std::vector<Box>& b, const PairConsumer& found);

}  // namespace touchstone::broad_phase
