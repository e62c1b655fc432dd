// What must hold of every answer with a separation, whatever the query: the distance before, at and after the time; the
// order of answers to growing separations; batches; and d = 0.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdio>

#include <touchstone/contact_times.hpp>
#include <touchstone/distance.hpp>
#include <touchstone/solve.hpp>

#include "separation/distances.hpp"
#include "support/answer_check.hpp"
#include "support/catch.hpp"
#include "support/exact_comparison.hpp"
#include "support/query_families.hpp"
#include "support/report.hpp"
#include "support/slow_build.hpp"

namespace touchstone::tests {
namespace {

using Real = long double;
using Point = std::array<Real, 3>;

Point at(const Query& query, std::size_t i, Real t) {
  const Vec3 &a = query.start[i], &b = query.end[i];
  return {a.x * (1 - t) + b.x * t, a.y * (1 - t) + b.y * t, a.z * (1 - t) + b.z * t};
}

Real size_of(const Point& v, Metric metric) {
  return metric == Metric::euclidean ? std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2])
                                     : std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])});
}

/// The distance of the points with the answer's weights, at a time: no less than the elements' distance.
Real distance_of_points(const Query& query, const std::array<double, 3>& a, const std::array<double, 3>& b, Real t,
                        Metric metric) {
  const std::size_t first = query.kind == Kind::edge_edge ? 2 : 1;
  Point sum = {};
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    const Point x = at(query, i, t);
    const Real weight = i < first ? -static_cast<Real>(a[i]) : static_cast<Real>(b[i - first]);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += weight * x[k];
  }
  return size_of(sum, metric);
}

std::string fault_in(const Query& query, const Separation& separation, const Answer& answer, Rng& rng) {
  const double d = separation.distance;
  if (answer.starts_within != (exactly_compared(query, 0, separation) <= 0)) return "starts_within is wrong";
  if (!answer.contact) {
    for (int i = 0; i < 4; ++i) {
      if (exactly_compared(query, i == 0 ? 1 : rng.unit(), separation) <= 0) return "no contact, but within";
    }
    return "";
  }
  if (answer.nature == Nature::none || answer.trend == Trend::none) return "a contact without nature or trend";
  if (exactly_compared(query, answer.toi_upper, separation) > 0 && answer.nature != Nature::grazing &&
      answer.nature != Nature::isolated) {
    // The next double may be behind the contact's end where that is as near.
    const auto times = contact_times(query, separation);
    if (times.front().last.compare(answer.toi_upper) > 0) return "not within at toi_upper";
  }
  if (answer.toi != answer.toi_upper && exactly_compared(query, answer.toi, separation) <= 0) return "within at toi";
  for (int i = 0; i < 3; ++i) {
    const double before = answer.toi * rng.unit();
    if (before < answer.toi && exactly_compared(query, before, separation) <= 0) return "within before toi";
  }
  double sums[2] = {0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    sums[0] += answer.weights_a[i];
    sums[1] += answer.weights_b[i];
  }
  if (std::fabs(sums[0] - 1) > 4 * kWeightTolerance || std::fabs(sums[1] - 1) > 4 * kWeightTolerance) {
    return "weights do not add up to 1";
  }
  const Real size = static_cast<Real>(extent(query)) + d;
  const Real apart = distance_of_points(query, answer.weights_a, answer.weights_b, answer.toi, separation.metric);
  const Real tolerance = 0x1p-45L * size + 0x1p-1070L;
  if (apart > d + tolerance) return "the closest points are farther apart than the separation";
  if (!answer.starts_within && apart < d - tolerance) return "the closest points are nearer than the separation";
  return "";
}

void answers_hold(Metric metric, std::size_t count) {
  Report report;
  std::size_t contacts = 0, queries = 0;
  for_each_case(
      7, count, [](const FamilyInfo&, Kind) { return true; },
      [&](const CaseId& id) {
        Rng rng = rng_of(id);
        const Query query = make_sample(id.family, id.kind, rng).query;
        Separation separation = {interesting_distance(query, metric, rng), metric};
        const Answer answer = solve(query, {.separation = separation, .method = Method::exact});
        std::string wrong;
        if (separation.distance > 0) {
          wrong = fault_in(query, separation, answer, rng);
          const Answer fast = solve(query, {.separation = separation});
          if (wrong.empty()) wrong = decision_difference(fast, answer);
          Separation wider = separation;
          wider.distance = std::min(separation.distance * (1 + rng.unit()), 0x1.fp1023);
          const Answer sooner = solve(query, {.separation = wider});
          if (wrong.empty() && answer.contact && !(sooner.contact && sooner.toi <= answer.toi))
            wrong = "a wider one is later";
        } else {
          wrong = bit_difference(solve(query, {.separation = separation}), solve(query), true);
        }
        contacts += answer.contact;
        ++queries;
        report.add(id, query, wrong.empty() ? "" : hexfloat(separation.distance) + ": " + wrong);
      });
  std::printf("%s: %zu queries, %zu contacts\n", std::string(name_of(metric)).c_str(), queries, contacts);
  CHECK(contacts > queries / 4);
  report.finish();
}

}  // namespace

TEST_CASE("Euclidean answers hold against distances at single times") { answers_hold(Metric::euclidean, 40); }
TEST_CASE("largest-axis answers hold against distances at single times") { answers_hold(Metric::max, 10); }

}  // namespace touchstone::tests
