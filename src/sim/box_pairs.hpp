// Overlapping boxes where a few are far larger than the rest, as a floor beside a net is.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "generators/broad_phase.hpp"

namespace touchstone::sim {

/// As generators::for_each_overlap, in another order, but one that depends on the boxes only.
void for_each_pair(const std::vector<generators::Box>& boxes, const generators::PairConsumer& found);
void for_each_pair(const std::vector<generators::Box>& a, const std::vector<generators::Box>& b,
                   const generators::PairConsumer& found);

}  // namespace touchstone::sim
