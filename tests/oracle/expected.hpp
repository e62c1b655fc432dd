// The expected answer of a query that was analysed by hand.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>

#include "oracle/oracle.hpp"
#include "support/catch.hpp"
#include "support/query_text.hpp"

namespace touchstone::tests {

using Weights = std::array<double, 3>;

inline constexpr Weights kFirst = {1, 0, 0};
inline constexpr Weights kSecond = {0, 1, 0};
inline constexpr Weights kThird = {0, 0, 1};

/// The neighbouring doubles around an exact time; one twice when it is a double.
using Times = std::pair<double, double>;

inline constexpr Times kOneThird = {0x1.5555555555555p-2, 0x1.5555555555556p-2};
inline constexpr Times kSqrtHalf = {0x1.6a09e667f3bccp-1, 0x1.6a09e667f3bcdp-1};
inline constexpr double kSqrtTwoMinusOne = 0x1.a827999fcef32p-2;

inline Times at(double time) { return {time, time}; }

struct Expected {
  Times times;
  Nature nature;
  Feature a;
  Feature b;
  Weights weights_a;
  Weights weights_b;
};

inline void check_answer(const Answer& answer, const Expected& expected) {
  INFO(describe(answer));
  CHECK(answer.level == Level::oracle);
  REQUIRE(answer.contact);
  CHECK(answer.toi == expected.times.first);
  CHECK(answer.toi_upper == expected.times.second);
  CHECK(name_of(answer.nature) == name_of(expected.nature));
  CHECK(name_of(answer.feature_a) == name_of(expected.a));
  CHECK(name_of(answer.feature_b) == name_of(expected.b));
  for (std::size_t i = 0; i < 3; ++i) {
    INFO("weight " << i);
    CHECK(std::abs(answer.weights_a[i] - expected.weights_a[i]) <= 0x1p-50);
    CHECK(std::abs(answer.weights_b[i] - expected.weights_b[i]) <= 0x1p-50);
  }
}

inline void check_no_contact(const Answer& answer) {
  INFO(describe(answer));
  CHECK_FALSE(answer.contact);
  CHECK(answer.level == Level::oracle);
  CHECK(answer.nature == Nature::none);
  CHECK(answer.feature_a == Feature::none);
  CHECK(answer.feature_b == Feature::none);
  CHECK(answer.toi == HUGE_VAL);
  CHECK(answer.toi_upper == HUGE_VAL);
}

inline void check_contact(const Query& query, const Expected& expected, double t_max = 1) {
  INFO(cpp_initializer(query));
  check_answer(oracle::decide_by_oracle(query, t_max), expected);
}

inline void check_no_contact(const Query& query, double t_max = 1) {
  INFO(cpp_initializer(query));
  check_no_contact(oracle::decide_by_oracle(query, t_max));
}

}  // namespace touchstone::tests
