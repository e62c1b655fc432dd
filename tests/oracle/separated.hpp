// The expected answer of a query with a separation that was analysed by hand.
// SPDX-License-Identifier: MIT
#pragma once

#include "oracle/expected.hpp"

namespace touchstone::tests {

/// How the distance behaves at the first time within the separation.
struct Course {
  Nature nature;
  Trend trend;
  bool starts_within = false;
};

inline constexpr Course kEnters = {Nature::entering, Trend::approaching};
inline constexpr Course kGrazes = {Nature::grazing, Trend::leaving};
inline constexpr Course kStays = {Nature::sustained, Trend::constant};

/// Where the elements are closest at the first time.
struct Place {
  Feature a;
  Feature b;
  Weights weights_a;
  Weights weights_b;
};

inline void check_separated(const Answer& answer, const Times& times, const Course& course, const Place& place) {
  check_answer(answer, {times, course.nature, place.a, place.b, place.weights_a, place.weights_b});
  CHECK(name_of(answer.trend) == name_of(course.trend));
  CHECK(answer.starts_within == course.starts_within);
}

inline void check_separated(const Query& query, const Separation& separation, const Times& times, const Course& course,
                            const Place& place, double t_max = 1) {
  INFO(cpp_initializer(query));
  INFO("separation " << separation.distance << " " << name_of(separation.metric));
  check_separated(oracle::decide_by_oracle(query, t_max, separation), times, course, place);
}

inline void check_no_contact(const Query& query, const Separation& separation, double t_max = 1) {
  INFO(cpp_initializer(query));
  INFO("separation " << separation.distance << " " << name_of(separation.metric));
  const Answer answer = oracle::decide_by_oracle(query, t_max, separation);
  check_no_contact(answer);
  CHECK_FALSE(answer.starts_within);
  CHECK(answer.trend == Trend::none);
}

/// Corners that all move by the same vector.
inline Query moved(Query query, std::size_t first, std::size_t last, const Vec3& by) {
  for (std::size_t i = first; i < last; ++i) {
    const Vec3& x = query.start[i];
    query.end[i] = {x.x + by.x, x.y + by.y, x.z + by.z};
  }
  return query;
}

}  // namespace touchstone::tests
