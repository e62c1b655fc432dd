// What a curved query's answer must be, by the exact level and by the oracle.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>

#include <touchstone/curved.hpp>
#include <touchstone/error.hpp>

#include "support/answer_check.hpp"
#include "support/catch.hpp"
#include "support/query_text.hpp"

namespace touchstone::tests {

constexpr std::array<double, 3> kFirst = {1, 0, 0};
constexpr std::array<double, 3> kSecond = {0, 1, 0};
constexpr std::array<double, 3> kThird = {0, 0, 1};
constexpr std::array<double, 3> kHalves = {0.5, 0.5, 0};

struct Expected {
  double toi;
  double toi_upper;
  Nature nature;
  Feature a, b;
  std::array<double, 3> weights_a, weights_b;
};

inline Answer solved(const CurvedQuery& query, double t_max = 1) {
  const Answer exact = solve(query, {.t_max = t_max, .method = Method::exact});
  const Answer oracle = solve(query, {.t_max = t_max, .method = Method::oracle});
  INFO("exact:  " << describe(exact));
  INFO("oracle: " << describe(oracle));
  CHECK(decision_difference(exact, oracle) == "");
  CHECK(weight_difference(exact, oracle) == "");
  CHECK(malformation(query.kind, exact, t_max) == "");
  CHECK(exact.level == Level::exact);
  CHECK(oracle.level == Level::oracle);
  return exact;
}

inline void check_contact(const CurvedQuery& query, const Expected& expected, double t_max = 1) {
  const Answer answer = solved(query, t_max);
  INFO(describe(answer));
  REQUIRE(answer.contact);
  CHECK(answer.toi == expected.toi);
  CHECK(answer.toi_upper == expected.toi_upper);
  CHECK(answer.nature == expected.nature);
  CHECK(answer.feature_a == expected.a);
  CHECK(answer.feature_b == expected.b);
  CHECK(answer.starts_within == (expected.toi_upper == 0));
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(std::fabs(answer.weights_a[i] - expected.weights_a[i]) <= 0x1p-50);
    CHECK(std::fabs(answer.weights_b[i] - expected.weights_b[i]) <= 0x1p-50);
  }
}

/// A query of rigid bodies and curves, corner by corner.
inline CurvedQuery curved(Kind kind, std::initializer_list<CurvedCorner> corners,
                          std::initializer_list<RigidMotion> motions = {}) {
  CurvedQuery query;
  query.kind = kind;
  std::copy(corners.begin(), corners.end(), query.corners.begin());
  std::copy(motions.begin(), motions.end(), query.motions.begin());
  return query;
}

inline CurvedCorner rest(const Vec3& x) { return CurvedCorner::on_curve({x}); }
inline CurvedCorner body(int motion, const Vec3& x) { return CurvedCorner::on_body(motion, x); }

}  // namespace touchstone::tests
