// The picture of a set in plain characters, for pages and terminals that show no other.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "report/measure.hpp"

namespace touchstone::report {

/// The greatest time error of each method and tolerance against its mean run time, on logarithmic axes. Each point is a
/// letter, which the lines below explain. Upper case: every answer is right except for its time. Lower case: some
/// contact is missed, invented or late. Empty when no method claims a time.
std::string text_plot(const SetResults& set);

}  // namespace touchstone::report
