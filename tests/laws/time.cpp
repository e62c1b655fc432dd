// The law of time: reversing it, ending it early, and taking a step in two halves.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <utility>
#include <vector>

#include "laws/halves.hpp"
#include "laws/law.hpp"
#include "laws/time_sets.hpp"

namespace touchstone::tests {
namespace {

constexpr std::uint64_t kSeed = 13;

Query run_backwards(Query query) {
  std::swap(query.start, query.end);
  return query;
}

TEST_CASE("law: reversing time maps the touching times to one minus themselves") {
  check_law(kSeed, 150, every_family, 1,
            [](const Query& query, Method, Rng&) -> Finding {
              return set_difference(reversed(contact_times(query)), contact_times(run_backwards(query)));
            },
            {Method::exact});
}

TEST_CASE("law: the first time backwards is the last time forwards") {
  check_law(kSeed, 150, every_family, 1, [](const Query& query, Method method, Rng&) -> Finding {
    const TimeSet times = contact_times(query);
    const Answer backwards = solve(run_backwards(query), {.method = method});
    if (backwards.contact == times.empty()) return "contact depends on the direction of time";
    if (times.empty()) return "";
    const ExactTime last = times.back().last.reversed();
    if (backwards.toi == last.lower() && backwards.toi_upper == last.upper()) return "";
    return "T = " + text(times) + "\n    but backwards: " + describe(backwards);
  });
}

TEST_CASE("law: contact_times with a t_max is T cut off there") {
  check_law(kSeed, 100, every_family, 1,
            [](const Query& query, Method, Rng& rng) -> Finding {
              const TimeSet whole = contact_times(query);
              std::vector<double> ends{0, 1, 0.5, rng.unit()};
              for (const ContactInterval& interval : whole) {
                for (const double bound : {interval.first.lower(), interval.first.upper(), interval.last.lower()}) {
                  ends.push_back(bound);
                  ends.push_back(std::nextafter(bound, 0.0));
                }
              }
              for (const double t_max : ends) {
                const std::string wrong = cut_difference(whole, t_max, contact_times(query, {}, t_max));
                if (!wrong.empty()) return "t_max = " + hexfloat(t_max) + ": " + wrong;
              }
              return "";
            },
            {Method::exact});
}

TEST_CASE("law: solve with a t_max forgets what happens later and changes nothing else") {
  check_law(kSeed, 100, every_family, 1, [](const Query& query, Method method, Rng& rng) -> Finding {
    const Answer whole = solve(query, {.method = method});
    for (const double t_max : ends_around(whole, rng)) {
      const Answer cut = solve(query, {.t_max = t_max, .method = method});
      std::string wrong = difference(cut_off(whole, t_max), cut, query);
      if (wrong.empty()) wrong = malformation(query.kind, cut, t_max);
      if (!wrong.empty()) return "t_max = " + hexfloat(t_max) + ": " + wrong;
    }
    return "";
  });
}

// Both halves of a step, as queries of their own; exact for dyadic coordinates.
std::pair<Query, Query> halves(const Query& query) {
  Query first = query, second = query;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    const Vec3 middle = 0.5 * (query.start[i] + query.end[i]);
    first.end[i] = middle;
    second.start[i] = middle;
  }
  return {first, second};
}

TEST_CASE("law: a step is its two halves") {
  check_law(kSeed, 200, dyadic_families, 1, [](const Query& query, Method method, Rng&) -> Finding {
    const auto both = halves(query);
    const auto &first = both.first, &second = both.second;  // clang 14 captures no structured bindings
    const Answer whole = solve(query, {.method = method});
    const Answer expected =
        of_halves(whole, solve(first, {.method = method}), [&] { return solve(second, {.method = method}); });
    return difference(expected, whole, first);
  });
}

TEST_CASE("law: the touching times of the first half are those of the whole, twice as late") {
  check_law(kSeed, 200, dyadic_families, 1,
            [](const Query& query, Method, Rng&) -> Finding {
              const TimeSet whole = contact_times(query, {}, 0.5);
              const TimeSet half = contact_times(halves(query).first);
              const auto twice = [](const ExactTime& slow, const ExactTime& fast) {
                return 2 * slow.lower() == fast.lower() && 2 * slow.upper() == fast.upper();
              };
              bool same = whole.size() == half.size();
              for (std::size_t i = 0; same && i < whole.size(); ++i) {
                same = twice(whole[i].first, half[i].first) && twice(whole[i].last, half[i].last);
              }
              return same ? "" : "whole " + text(whole) + "\n    half  " + text(half);
            },
            {Method::exact});
}

}  // namespace
}  // namespace touchstone::tests
