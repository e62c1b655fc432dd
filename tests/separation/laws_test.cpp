// Laws of answers with a separation, in both metrics: what maps of space and time, other names and another distance
// change, and what they do not.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <optional>
#include <utility>

#include <touchstone/contact_times.hpp>
#include <touchstone/solve.hpp>

#include "laws/time_sets.hpp"
#include "support/answer_check.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/report.hpp"

namespace touchstone::tests {
namespace {

constexpr std::uint64_t kSeed = 23;

using Outcome = std::optional<std::string>;

bool every_family(const FamilyInfo&, Kind) { return true; }
bool dyadic_families(const FamilyInfo& family, Kind) { return family.dyadic; }

/// Checks `law(query, separation, method, rng)` on cases of every wanted family, each with its own distance. The result
/// of a law is nothing where it does not apply, empty where it holds, else the violation.
template <typename Wanted, typename Law>
void check_law(std::size_t count, Wanted&& wanted, double least_share, Law&& law) {
  Report report;
  std::size_t cases = 0;
  for_each_case(kSeed, count, wanted, [&](const CaseId& id) {
    for (const Metric metric : {Metric::euclidean, Metric::max}) {
      if (metric == Metric::max && id.index % 4 != 0) continue;  // which is slower
      for (const Method method : {Method::fast, Method::exact}) {
        Rng rng = rng_of(id);
        const Separated made = make_separated(id.family, id.kind, metric, rng);
        ++cases;
        const Outcome finding = law(made.query, Separation{made.distance, metric}, method, rng);
        if (!finding) continue;
        report.add(id, made.query,
                   finding->empty() ? ""
                                    : std::string(name_of(metric)) + " " + hexfloat(made.distance) +
                                          (method == Method::fast ? " fast: " : " exact: ") + *finding);
      }
    }
  });
  CHECK(static_cast<double>(report.checked()) >= least_share * static_cast<double>(cases));
  report.finish();
}

/// Empty when both answers say the same time, nature and trend.
std::string difference_in_time(const Answer& expected, const Answer& found) {
  if (expected.contact == found.contact && expected.toi == found.toi && expected.toi_upper == found.toi_upper &&
      expected.nature == found.nature && expected.trend == found.trend &&
      expected.starts_within == found.starts_within) {
    return "";
  }
  return "expected " + describe(expected) + "\n    found    " + describe(found);
}

/// Empty when both answers say the same, features and weights included.
std::string difference(const Answer& expected, const Answer& found) {
  std::string wrong = decision_difference(expected, found);
  if (wrong.empty()) wrong = weight_difference(expected, found);
  return wrong.empty() ? "" : wrong + ": " + difference_in_time(expected, found);
}

/// The answer to the mapped query. Maps that exchange the axes may choose another one of equally near pairs of points
/// in the largest-axis metric.
Outcome same_answer(const Query& query, const Query& mapped, const Separation& separation,
                    const Separation& mapped_separation, Method method) {
  const Answer expected = solve(query, {.separation = separation, .method = method}),
               found = solve(mapped, {.separation = mapped_separation, .method = method});
  return separation.metric == Metric::euclidean ? difference(expected, found) : difference_in_time(expected, found);
}

std::optional<double> scaled(double x, int exponent) {
  const double result = std::ldexp(x, exponent);
  if (!std::isfinite(result) || std::ldexp(result, -exponent) != x) return std::nullopt;
  return result;
}

/// Adds one vector to all corners at an end of the step; false when a sum is rounded.
bool translate(std::array<Vec3, 4>& corners, std::size_t count, Rng& rng) {
  const Vec3 offset{static_cast<double>(rng.between(-1000, 1000)), static_cast<double>(rng.between(-1000, 1000)),
                    static_cast<double>(rng.between(-1000, 1000))};
  bool exact = true;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double& x = coordinate(corners[i], axis);
      const double sum = x + coordinate(offset, axis);
      exact = exact && sum - coordinate(offset, axis) == x && sum - x == coordinate(offset, axis);
      x = sum;
    }
  }
  return exact;
}

/// Another order of an element's corners, or of the elements where they are of one sort.
Query with_other_names(Query query, Rng& rng) {
  const auto swap_corners = [&query](std::size_t i, std::size_t j) {
    std::swap(query.start[i], query.start[j]);
    std::swap(query.end[i], query.end[j]);
  };
  switch (query.kind) {
    case Kind::edge_edge: {
      const int choice = rng.between(1, 7);
      if (choice & 1) swap_corners(0, 1);
      if (choice & 2) swap_corners(2, 3);
      if (choice & 4) {
        swap_corners(0, 2);
        swap_corners(1, 3);
      }
      break;
    }
    case Kind::vertex_face:
      if (rng.one_in(2)) swap_corners(1, 2);
      swap_corners(3, rng.one_in(2) ? 1 : 2);
      break;
    case Kind::point_edge: swap_corners(1, 2); break;
    case Kind::point_point: swap_corners(0, 1); break;
  }
  return query;
}

}  // namespace

TEST_CASE("law of separations: a mirror, a quarter turn and other axes change nothing") {
  check_law(12, every_family, 1,
            [](const Query& query, const Separation& separation, Method method, Rng& rng) -> Outcome {
              const int signs = rng.between(0, 7), turn = rng.between(0, 2);
              const bool exchange = rng.one_in(2);
              const Query mapped = mapped_corners(query, [&](const Vec3& x) {
                const std::array<double, 3> c{signs & 1 ? -x.x : x.x, signs & 2 ? -x.y : x.y, signs & 4 ? -x.z : x.z};
                const auto from = [&](int k) { return c[static_cast<std::size_t>((k + turn) % 3)]; };
                return exchange ? Vec3{from(1), from(0), from(2)} : Vec3{from(0), from(1), from(2)};
              });
              return same_answer(query, mapped, separation, separation, method);
            });
}

TEST_CASE("law of separations: a power of two for coordinates and distance changes nothing") {
  check_law(12, every_family, 0.3,
            [](const Query& query, const Separation& separation, Method method, Rng& rng) -> Outcome {
              const int exponent = rng.one_in(2) ? rng.between(-60, 60) : rng.between(-1000, 1000);
              Query mapped = query;
              bool exact = true;
              for_each_coordinate(mapped, [&](double& x) {
                const auto result = scaled(x, exponent);
                exact = exact && result;
                x = result.value_or(0);
              });
              const auto distance = scaled(separation.distance, exponent);
              if (!exact || !distance) return std::nullopt;
              return same_answer(query, mapped, separation, {*distance, separation.metric}, method);
            });
}

TEST_CASE("law of separations: an exact translation and a common velocity change nothing") {
  check_law(12, dyadic_families, 0.9,
            [](const Query& query, const Separation& separation, Method method, Rng& rng) -> Outcome {
              Query mapped = query;
              const std::size_t count = corner_count(query.kind);
              const bool start = translate(mapped.start, count, rng);
              const bool end = translate(mapped.end, count, rng);
              if (!start || !end) return std::nullopt;
              return same_answer(query, mapped, separation, separation, method);
            });
}

TEST_CASE("law of separations: other names of elements and corners change no time, nature or trend") {
  check_law(
      12, every_family, 1, [](const Query& query, const Separation& separation, Method method, Rng& rng) -> Outcome {
        return difference_in_time(solve(query, {.separation = separation, .method = method}),
                                  solve(with_other_names(query, rng), {.separation = separation, .method = method}));
      });
}

TEST_CASE("law of separations: reversing time maps the contact times to one minus themselves") {
  check_law(6, every_family, 0.4, [](const Query& query, const Separation& separation, Method method, Rng&) -> Outcome {
    if (method == Method::fast) return std::nullopt;  // contact_times has no method
    Query backwards = query;
    std::swap(backwards.start, backwards.end);
    const TimeSet times = contact_times(query, separation);
    std::string wrong = set_difference(reversed(times), contact_times(backwards, separation));
    if (!wrong.empty()) return wrong;
    const Answer answer = solve(query, {.separation = separation, .method = method});
    if (answer.contact == times.empty()) return "solve and contact_times differ about contact";
    if (times.empty()) return "";
    const ExactTime& first = times.front().first;
    return first.lower() == answer.toi && first.upper() == answer.toi_upper ? "" : "they differ about the time";
  });
}

TEST_CASE("law of separations: the time does not grow when the distance grows by an ulp") {
  check_law(12, every_family, 1, [](const Query& query, const Separation& separation, Method method, Rng&) -> Outcome {
    const double wider = std::nextafter(separation.distance, HUGE_VAL);
    if (!std::isfinite(wider)) return "";
    const Answer late = solve(query, {.separation = separation, .method = method});
    const Answer early = solve(query, {.separation = {wider, separation.metric}, .method = method});
    if (!late.contact) return "";
    if (early.contact && early.toi <= late.toi && early.toi_upper <= late.toi_upper) return "";
    return "at " + hexfloat(wider) + " " + describe(early) + "\n    at the distance " + describe(late);
  });
}

TEST_CASE("law of separations: distance 0 is touching, bit for bit") {
  check_law(24, every_family, 1,
            [](const Query& query, const Separation& separation, Method method, Rng& rng) -> Outcome {
              const Separation none = {rng.one_in(2) ? 0.0 : -0.0, separation.metric};
              const double t_max = rng.one_in(4) ? rng.unit() : 1;
              std::string wrong = bit_difference(solve(query, {.t_max = t_max, .separation = none, .method = method}),
                                                 solve(query, {.t_max = t_max, .method = method}), true);
              if (wrong.empty() && method == Method::exact) {
                wrong = set_difference(contact_times(query), contact_times(query, none));
              }
              return wrong;
            });
}

}  // namespace touchstone::tests
