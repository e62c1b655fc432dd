// Separations of curved queries: known ones, straight motion as curves, and the exact level against the oracle.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include <touchstone/contact_normal.hpp>
#include <touchstone/curved.hpp>
#include <touchstone/distance.hpp>
#include <touchstone/error.hpp>

#include "curved/expected.hpp"
#include "curved/queries.hpp"
#include "filters/curved/curved_paths.hpp"
#include "separation/distances.hpp"
#include "support/report.hpp"
#include "support/slow_build.hpp"

namespace touchstone::tests {
namespace {

constexpr std::uint64_t kSeed = 53;
constexpr std::array<Metric, 2> kMetrics = {Metric::euclidean, Metric::max};

Answer solved_within(const CurvedQuery& query, const Separation& separation, double t_max = 1) {
  const Answer exact = solve(query, {.t_max = t_max, .separation = separation, .method = Method::exact});
  const Answer oracle = solve(query, {.t_max = t_max, .separation = separation, .method = Method::oracle});
  INFO("exact:  " << describe(exact));
  INFO("oracle: " << describe(oracle));
  REQUIRE(decision_difference(exact, oracle) == "");
  REQUIRE(weight_difference(exact, oracle) == "");
  REQUIRE(exact.trend == oracle.trend);
  const Answer fast = solve(query, {.t_max = t_max, .separation = separation});
  REQUIRE(decision_difference(exact, fast) == "");
  REQUIRE(solve(query, {.t_max = t_max, .separation = separation, .wanted = Wanted::contact}).contact == exact.contact);
  return exact;
}

/// A triangle in the plane y = height around the line over (x, 0), with the weights 1/4, 1/4 and 1/2 there.
CurvedQuery tip_and_wall(const RigidMotion& motion, const Vec3& tip, double x, double height) {
  return curved(Kind::vertex_face,
                {body(0, tip), rest({x - 8, height, -8}), rest({x + 8, height, -8}), rest({x, height, 8})}, {motion});
}

void check_time(const Answer& answer, double time, Nature nature, Trend trend, bool starts_within) {
  INFO(describe(answer));
  REQUIRE(answer.contact);
  CHECK(answer.toi == time);
  CHECK(answer.toi_upper == time);
  CHECK(answer.nature == nature);
  CHECK(answer.trend == trend);
  CHECK(answer.starts_within == starts_within);
}

TEST_CASE("the tip of a rod that turns comes within a distance of a wall") {
  RigidMotion motion;
  motion.q1 = {1, 0, 0, 1};  // a quarter turn about z; the tip is at (3, 4, 0) at t = 1/2
  const CurvedQuery query = tip_and_wall(motion, {5, 0, 0}, 3, 6);
  for (const Metric metric : kMetrics) {
    check_time(solved_within(query, {2, metric}), 0.5, Nature::entering, Trend::approaching, false);
    CHECK(!solved_within(query, {2, metric}, 0.4999).contact);
    CHECK(!solved_within(query, {0.9999, metric}).contact);  // the tip ends 1 from the wall
    check_time(solved_within(query, {6, metric}), 0, Nature::entering, Trend::approaching, true);
    check_time(solved_within(query, {7, metric}), 0, Nature::sustained, Trend::approaching, true);
  }
  for (const Metric metric : kMetrics) {
    const Distance at_half = distance(query, 0.5, metric);
    CHECK(at_half.value == 2);
    CHECK(at_half.feature_b == Feature::f);
    if (metric == Metric::euclidean) CHECK(at_half.weights_b == std::array<double, 3>{0.25, 0.25, 0.5});
    CHECK(distance(query, 1, metric).value == 1);
    CHECK(compare_distance(query, 0.5, {2, metric}) == 0);
    CHECK(compare_distance(query, 0.5, {std::nextafter(2.0, 3.0), metric}) < 0);
    CHECK(compare_distance(query, std::nextafter(0.5, 0.0), {2, metric}) > 0);
  }
  const Answer answer = solved_within(query, {2});
  CHECK(answer.feature_a == Feature::v);
  CHECK(answer.feature_b == Feature::f);
  CHECK(answer.weights_b == std::array<double, 3>{0.25, 0.25, 0.5});
  const auto normal = contact_normal(query, Separation{2});
  REQUIRE(normal);
  CHECK(*normal == std::array<double, 3>{0, 1, 0});
  CHECK_THROWS_AS(contact_normal(query, Separation{2, Metric::max}), InvalidQuery);
  const std::vector<ContactInterval> times = contact_times(query, Separation{2});
  REQUIRE(times.size() == 1);
  CHECK(times[0].first.to_string() == "1/2");
  CHECK(times[0].last.compare(1.0) == 0);
}

TEST_CASE("the tip of a rod that turns grazes a distance from a wall, or keeps it") {
  RigidMotion motion;
  motion.q0 = {1, 0, 0, -0.5};
  motion.q1 = {1, 0, 0, 0.5};
  const CurvedQuery query = tip_and_wall(motion, {0, 5, 0}, 0, 7);  // highest at t = 1/2
  RigidMotion spin;
  spin.q1 = {1, 0, 1, 0};
  const CurvedQuery kept = tip_and_wall(spin, {1, 0, 0}, 0, 2);
  for (const Metric metric : kMetrics) {
    check_time(solved_within(query, {2, metric}), 0.5, Nature::grazing, Trend::leaving, false);
    CHECK(!solved_within(query, {std::nextafter(2, 1), metric}).contact);
    CHECK(solved_within(query, {std::nextafter(2, 3), metric}).nature == Nature::entering);
    check_time(solved_within(kept, {2, metric}), 0, Nature::sustained, Trend::constant, true);
    CHECK(!solved_within(kept, {std::nextafter(2, 1), metric}).contact);
    for (const double time : {0.0, 0.1, 1.0}) CHECK(distance(kept, time, metric).value == 2);
  }
}

TEST_CASE("two rods that turn come within a distance of each other") {
  // Both tips are 5 from their bodies' origins; at t = 1/2 they are at (3, 4, 0) and at (7, 4, 0).
  RigidMotion left, right;
  left.q1 = {1, 0, 0, 1};
  right.q1 = {1, 0, 0, -1};
  right.p0 = right.p1 = {10, 0, 0};
  const CurvedQuery points = curved(Kind::point_point, {body(0, {5, 0, 0}), body(1, {-5, 0, 0})}, {left, right});
  check_time(solved_within(points, {4}, 0.75), 0, Nature::sustained, Trend::leaving, true);
  left.q0 = {1, 0, 0, 1};
  left.q1 = {1, 0, 0, 0};
  right.q0 = {1, 0, 0, -1};
  right.q1 = {1, 0, 0, 0};
  const CurvedQuery closing = curved(Kind::point_point, {body(0, {5, 0, 0}), body(1, {-5, 0, 0})}, {left, right});
  for (const Metric metric : kMetrics) {
    check_time(solved_within(closing, {4, metric}), 0.5, Nature::entering, Trend::approaching, false);
  }
  const CurvedQuery rods =
      curved(Kind::edge_edge, {body(0, {0, 0, 0}), body(0, {5, 0, 0}), body(1, {0, 0, 0}), body(1, {-5, 0, 0})},
             {left, right});
  const Answer answer = solved_within(rods, {4});
  check_time(answer, 0.5, Nature::entering, Trend::approaching, false);
  CHECK(answer.feature_a == Feature::a1);
  CHECK(answer.feature_b == Feature::b1);
}

void straight_as_curves(Kind kind) {
  Report report;
  std::size_t contacts = 0;
  const auto wanted = [kind](const FamilyInfo& family, Kind k) {
    return k == kind && family.group != Group::separation;
  };
  for_each_case(kSeed, 25, wanted, [&](const CaseId& id) {
    const Query query = make(id);
    Rng rng(seeded::seed_of_stream(kSeed, report.checked()));
    const Metric metric = rng.pick(kMetrics);
    const Separation separation = {interesting_distance(query, metric, rng), metric};
    const Answer straight = solve(query, {.separation = separation, .method = Method::exact});
    const Answer curved = solve(CurvedQuery(query), {.separation = separation, .method = Method::exact});
    std::string wrong = labelled("as curves", bit_difference(straight, curved, true));
    if (wrong.empty()) {
      const Answer fast = solve(CurvedQuery(query), {.separation = separation});
      wrong = labelled("by default", bit_difference(solve(query, {.separation = separation}), fast, true));
      if (wrong.empty()) wrong = labelled("by default", decision_difference(curved, fast));
    }
    const double time = rng.unit();
    const Distance as_straight = distance(query, time, metric), as_curved = distance(CurvedQuery(query), time, metric);
    if (wrong.empty() &&
        (as_straight.value != as_curved.value || as_straight.feature_a != as_curved.feature_a ||
         as_straight.feature_b != as_curved.feature_b ||
         compare_distance(query, time, separation) != compare_distance(CurvedQuery(query), time, separation))) {
      wrong = "the distance differs at " + hexfloat(time);
    }
    contacts += straight.contact;
    report.add(id, query, wrong);
  });
  std::printf("seed %llu, %s: %zu straight queries with a separation as curves, %zu with contact\n",
              static_cast<unsigned long long>(kSeed), name_of(kind).data(), report.checked(), contacts);
  CHECK(contacts > 0);
  report.finish();
}

TEST_CASE("a separation of straight motion as curves: edge-edge") { straight_as_curves(Kind::edge_edge); }
TEST_CASE("a separation of straight motion as curves: vertex-face") { straight_as_curves(Kind::vertex_face); }
TEST_CASE("a separation of straight motion as curves: point-edge") { straight_as_curves(Kind::point_edge); }
TEST_CASE("a separation of straight motion as curves: point-point") { straight_as_curves(Kind::point_point); }

double distance_for(Rng& rng) {
  switch (rng.between(0, 3)) {
    case 0: return rng.between(1, 5);
    case 1: return std::ldexp(rng.between(1, 9), -2);
    case 2: return std::sqrt(static_cast<double>(rng.between(2, 8)));
    default: return 3 * rng.unit() + 0x1p-30;
  }
}

void exact_and_oracle_agree(const char* name, Maker make, std::initializer_list<Kind> kinds, std::size_t count) {
  std::size_t contacts = 0, within = 0, checked = 0, filtered = 0;
  std::array<std::size_t, 6> natures{};
  for (const Kind kind : kinds) {
    for (std::uint64_t index = 0; index < effort(count); ++index) {
      Rng rng(seeded::seed_of_stream(kSeed + static_cast<std::uint64_t>(kind), index));
      const CurvedQuery query = make(kind, rng);
      const Separation separation = {distance_for(rng), rng.pick(kMetrics)};
      const double t_max = rng.one_in(4) ? rng.unit() : 1;
      INFO("seed " << kSeed << ", index " << index << ", t_max " << hexfloat(t_max) << ", distance "
                   << hexfloat(separation.distance) << " " << name_of(separation.metric) << "\n"
                   << text_of(query));
      const Answer answer = solved_within(query, separation, t_max);
      ++checked;
      contacts += answer.contact;
      within += answer.starts_within;
      filtered += filters::certainly_farther(query, separation);
      ++natures[static_cast<std::size_t>(answer.nature)];
      if (filters::certainly_farther(query, separation)) REQUIRE(!answer.contact);
      if (index % 4 != 0) continue;
      const std::vector<ContactInterval> times = contact_times(query, separation, t_max);
      REQUIRE(!times.empty() == answer.contact);
      if (answer.contact) {
        REQUIRE(times.front().first.lower() == answer.toi);
        REQUIRE(times.front().first.upper() == answer.toi_upper);
      }
    }
  }
  std::printf(
      "seed %llu, %s: %zu queries, %zu within d, %zu from the start; %zu entering, %zu grazing, %zu sustained, "
      "%zu isolated; the filter proves %zu\n",
      static_cast<unsigned long long>(kSeed), name, checked, contacts, within, natures[5], natures[2], natures[3],
      natures[4], filtered);
  if (whole_effort("that some curved queries come within a distance during the step")) CHECK(contacts > within);
}

TEST_CASE("exact and oracle agree on separations of curved queries: lattice") {
  exact_and_oracle_agree("lattice", lattice_query,
                         {Kind::edge_edge, Kind::vertex_face, Kind::point_edge, Kind::point_point}, 30);
}
TEST_CASE("exact and oracle agree on separations of curved queries: gears") {
  exact_and_oracle_agree("gears", gear_query, {Kind::edge_edge, Kind::vertex_face, Kind::point_edge}, 25);
}
TEST_CASE("exact and oracle agree on separations of curved queries: screws and coins") {
  exact_and_oracle_agree("screws", screw_query, {Kind::edge_edge, Kind::vertex_face}, 25);
  exact_and_oracle_agree("coins", coin_query, {Kind::edge_edge, Kind::vertex_face}, 25);
}
TEST_CASE("exact and oracle agree on separations of curved queries: meeting and random") {
  exact_and_oracle_agree("meeting", meeting_query, {Kind::edge_edge, Kind::vertex_face, Kind::point_point}, 20);
  exact_and_oracle_agree("random", random_query, {Kind::edge_edge, Kind::vertex_face}, 15);
}

/// Each corner on a body of its own: the highest degrees, 54 for the Euclidean distance.
CurvedQuery four_bodies(Kind kind, Rng& rng) {
  CurvedQuery query;
  query.kind = kind;
  for (std::size_t i = 0; i < 4; ++i) {
    query.motions[i] = lattice_motion(rng, 2);
    query.corners[i] = CurvedCorner::on_body(static_cast<int>(i), lattice(rng, 2));
  }
  return query;
}
TEST_CASE("exact and oracle agree on separations of curved queries: four bodies") {
  exact_and_oracle_agree("four bodies", four_bodies, {Kind::edge_edge, Kind::vertex_face}, 3);
}

TEST_CASE("a batch of curved queries with separations: the same bits as one by one") {
  std::vector<CurvedQuery> queries;
  std::vector<double> distances;
  for (std::uint64_t index = 0; index < effort(200); ++index) {
    Rng rng(seeded::seed_of_stream(kSeed, index));
    queries.push_back(meeting_query(rng.one_in(2) ? Kind::point_edge : Kind::edge_edge, rng));
    distances.push_back(rng.one_in(5) ? 0 : distance_for(rng));
  }
  for (const int threads : {1, 3}) {
    BatchOptions options;
    options.threads = threads;
    options.separation.metric = Metric::max;
    options.separations = distances.data();
    options.separation_count = distances.size();
    const std::vector<Answer> answers = solve_batch(queries, options);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      REQUIRE(bit_difference(solve(queries[i], {.separation = Separation{distances[i], Metric::max}}), answers[i],
                             true) == "");
    }
  }
}

TEST_CASE("a separation without meaning is an error for curved queries too") {
  const CurvedQuery query;
  CHECK_THROWS_AS(solve(query, {.separation = Separation{-1}}), InvalidQuery);
  CHECK_THROWS_AS(solve(query, {.separation = Separation{std::nan("")}, .wanted = Wanted::contact}), InvalidQuery);
  CHECK_THROWS_AS(solve(query, {.separation = Separation{1, static_cast<Metric>(7)}}), InvalidQuery);
  CHECK_THROWS_AS(contact_times(query, Separation{-1}), InvalidQuery);
}

}  // namespace
}  // namespace touchstone::tests
