// The laws of time for curved queries: reversing it, ending it early, and taking a step in two halves.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <utility>

#include "laws/curved_law.hpp"
#include "laws/halves.hpp"
#include "laws/time_sets.hpp"

namespace touchstone::tests {
namespace {

constexpr std::uint64_t kSeed = 73;

CurvedQuery run_backwards(CurvedQuery query) {
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    CurvedCorner& corner = query.corners[i];
    if (corner.motion == CurvedCorner::kOnCurve) {
      std::reverse(corner.points.begin(), corner.points.begin() + corner.control_points);
    }
  }
  for (RigidMotion& motion : query.motions) {
    std::swap(motion.q0, motion.q1);
    std::swap(motion.p0, motion.p1);
  }
  return query;
}

TEST_CASE("law of curves: reversing time maps the touching times to one minus themselves") {
  check_curved_law(kSeed, 12, 0.4, [](const CurvedAsked& asked, Method method, Rng&) -> Finding {
    if (method != Method::exact) return std::nullopt;
    return set_difference(reversed(contact_times(asked.query, asked.separation)),
                          contact_times(run_backwards(asked.query), asked.separation));
  });
}

TEST_CASE("law of curves: the first time backwards is the last time forwards") {
  check_curved_law(kSeed, 12, 1, [](const CurvedAsked& asked, Method method, Rng&) -> Finding {
    const TimeSet times = contact_times(asked.query, asked.separation);
    const Answer backwards = solve(run_backwards(asked.query), {.separation = asked.separation, .method = method});
    if (backwards.contact == times.empty()) return "contact depends on the direction of time";
    if (times.empty()) return "";
    const ExactTime last = times.back().last.reversed();
    if (backwards.toi == last.lower() && backwards.toi_upper == last.upper()) return "";
    return "T = " + text(times) + "\n    but backwards: " + describe(backwards);
  });
}

TEST_CASE("law of curves: solve with a t_max forgets what happens later and changes nothing else") {
  check_curved_law(kSeed, 12, 0.8, [](const CurvedAsked& asked, Method method, Rng& rng) -> Finding {
    if (asked.separation.distance > 0) return std::nullopt;
    const Answer whole = solve(asked.query, {.separation = asked.separation, .method = method});
    for (const double t_max : ends_around(whole, rng)) {
      const CurvedAsked early{asked.query, asked.separation, t_max};
      const Answer cut = answer_to(early, method);
      std::string wrong = curved_difference(cut_off(whole, t_max), cut, early);
      if (wrong.empty()) wrong = malformation(asked.query.kind, cut, t_max);
      if (!wrong.empty()) return "t_max = " + hexfloat(t_max) + ": " + wrong;
    }
    return "";
  });
}

/// Both halves of a step, as queries of their own: de Casteljau's points at 1/2.
std::pair<CurvedQuery, CurvedQuery> halves(const CurvedQuery& query, Exactly& exactly) {
  CurvedQuery first = query, second = query;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    if (query.corners[i].motion != CurvedCorner::kOnCurve) continue;
    auto points = query.corners[i].points;
    const auto last = static_cast<std::size_t>(query.corners[i].control_points - 1);
    for (std::size_t level = 0; level <= last; ++level) {
      first.corners[i].points[level] = points[0];
      second.corners[i].points[last - level] = points[last - level];
      for (std::size_t k = 0; k + level < last; ++k) points[k] = exactly.middle(points[k], points[k + 1]);
    }
  }
  std::array<bool, 4> used{};
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    if (query.corners[i].motion != CurvedCorner::kOnCurve)
      used[static_cast<std::size_t>(query.corners[i].motion)] = true;
  }
  for (std::size_t m = 0; m < used.size(); ++m) {
    if (!used[m]) continue;
    const RigidMotion& motion = query.motions[m];
    first.motions[m].q1 = second.motions[m].q0 = exactly.middle(motion.q0, motion.q1);
    first.motions[m].p1 = second.motions[m].p0 = exactly.middle(motion.p0, motion.p1);
  }
  return {first, second};
}

TEST_CASE("law of curves: a step is its two halves") {
  check_curved_law(kSeed, 18, 0.3, [](const CurvedAsked& asked, Method method, Rng&) -> Finding {
    Exactly exactly;
    const auto both = halves(asked.query, exactly);
    const auto &first = both.first, &second = both.second;  // clang 14 captures no structured bindings
    if (!exactly.holds() || asked.separation.distance > 0) return std::nullopt;
    const CurvedAsked whole{asked.query, asked.separation};
    const Answer answer = answer_to(whole, method);
    const Answer expected = of_halves(answer, solve(first, {.separation = asked.separation, .method = method}), [&] {
      return solve(second, {.separation = asked.separation, .method = method});
    });
    return curved_difference(expected, answer, whole);
  });
}

}  // namespace
}  // namespace touchstone::tests
