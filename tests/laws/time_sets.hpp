// Sets of touching times: equality, union, reversal, and cutting at a time.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <touchstone/contact_times.hpp>

namespace touchstone::tests {

using TimeSet = std::vector<ContactInterval>;

/// "[1/2, 1/2] [3/4, 1]", or "nothing".
std::string text(const TimeSet& set);

/// Empty when the sets are equal, else both of them.
std::string set_difference(const TimeSet& expected, const TimeSet& found);

/// The union, as disjoint intervals in ascending order.
TimeSet united(const TimeSet& one, const TimeSet& other);

/// The set of 1 - t.
TimeSet reversed(const TimeSet& set);

/// Empty when `found` is `whole` intersected with [0, t_max], else both of them.
std::string cut_difference(const TimeSet& whole, double t_max, const TimeSet& found);

}  // namespace touchstone::tests
