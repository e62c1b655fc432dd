// The methods that no other method beats in both error and run time.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "report/measure.hpp"

namespace touchstone::report {

/// Whether `a` is wrong no more often, its times are no farther off in the median, it takes no longer than `b`, and it
/// is better in one of the three. Neither dominates where one was asked fewer queries.
bool dominates(const Result& a, const Result& b) noexcept;

/// The front among the contestants that were asked all queries, by mean time, the fastest first.
std::vector<const Result*> front(const std::vector<Result>& results);

/// One paragraph: the methods on the front, those that have no place, and the position of touchstone.
std::string front_sentence(const std::vector<Result>& results);

}  // namespace touchstone::report
