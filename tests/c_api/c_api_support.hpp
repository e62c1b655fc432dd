// What the tests of the C interface share.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>

#include <touchstone/c.h>
#include <touchstone/touchstone.hpp>

#include "support/catch.hpp"

namespace touchstone::tests {

inline bool same(const Answer& a, const touchstone_answer& b) {
  return a.contact == (b.contact != 0) && static_cast<int>(a.level) == b.level &&
         static_cast<int>(a.nature) == b.nature && static_cast<int>(a.feature_a) == b.feature_a &&
         static_cast<int>(a.feature_b) == b.feature_b && a.starts_within == (b.starts_within != 0) &&
         static_cast<int>(a.trend) == b.trend && a.toi == b.toi && a.toi_upper == b.toi_upper &&
         std::equal(a.weights_a.begin(), a.weights_a.end(), b.weights_a) &&
         std::equal(a.weights_b.begin(), a.weights_b.end(), b.weights_b);
}

inline touchstone_options default_options() { return TOUCHSTONE_OPTIONS_INIT; }

inline bool message_has(const std::string& part) {
  INFO(touchstone_last_error());
  return std::string(touchstone_last_error()).find(part) != std::string::npos;
}

}  // namespace touchstone::tests
