// All touching times with exact ends, from which contact_times is made. SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

#include "numbers/real_root.hpp"

namespace touchstone::exact {

struct RootInterval {
  numbers::RealRoot first;
  numbers::RealRoot last;
};

/// The set of touching times in [0, t_max], ascending and disjoint. Preconditions as for decide_exactly.
std::vector<RootInterval> touching_times(const Query& query, double t_max);
std::vector<RootInterval> touching_times(const RationalQuery& query, double t_max);

/// The same for contact within a separation > 0.
std::vector<RootInterval> touching_times(const Query& query, double t_max, const Separation& separation);
std::vector<RootInterval> touching_times(const RationalQuery& query, double t_max, const Separation& separation);

}  // namespace touchstone::exact
