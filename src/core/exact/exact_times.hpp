// Exact times: all touching times, from which contact_times is made, and the first one.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <touchstone/answer.hpp>
#include <touchstone/curved_query.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

#include "numbers/roots/real_root.hpp"

namespace touchstone::exact {

struct RootInterval {
  numbers::RealRoot first;
  numbers::RealRoot last;
};

/// The set of touching times in [0, t_max], ascending and disjoint. Preconditions as for decide_exactly.
std::vector<RootInterval> touching_times(const Query& query, double t_max);
std::vector<RootInterval> touching_times(const RationalQuery& query, double t_max);
std::vector<RootInterval> touching_times(const CurvedQuery& query, double t_max);

/// The same for contact within a separation > 0.
std::vector<RootInterval> touching_times(const Query& query, double t_max, const Separation& separation);
std::vector<RootInterval> touching_times(const RationalQuery& query, double t_max, const Separation& separation);
std::vector<RootInterval> touching_times(const CurvedQuery& query, double t_max, const Separation& separation);

/// The first contact within a separation > 0 with its exact time, which is there when there is a contact.
struct TimedAnswer {
  Answer answer;
  std::optional<numbers::RealRoot> time;
};
TimedAnswer decide_with_time(const Query& query, double t_max, const Separation& separation);
TimedAnswer decide_with_time(const RationalQuery& query, double t_max, const Separation& separation);
TimedAnswer decide_with_time(const CurvedQuery& query, double t_max, const Separation& separation);

}  // namespace touchstone::exact
