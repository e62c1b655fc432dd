// Shrunk queries still fail in the same way, and a person can read them.
// SPDX-License-Identifier: MIT
#include "fuzz/shrinking/shrink.hpp"

#include <cmath>
#include <cstdio>
#include <set>

#include "fuzz/engine.hpp"
#include "fuzz/named_solvers.hpp"
#include "fuzz/run_case.hpp"
#include "fuzz/shrinking/simplicity.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/query_text.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

template <class F>
bool every_coordinate(const Query& query, F&& wanted) {
  bool all = true;
  Query copy = query;
  for_each_coordinate(copy, [&](double& x) { all = all && wanted(x); });
  return all;
}

bool integer_or_half_below_16(double x) { return std::fabs(x) < 16 && std::nearbyint(2 * x) == 2 * x; }

/// How many distinct absolute values are no integers or halves below 16.
std::size_t odd_values(const Query& query) {
  std::set<double> values;
  every_coordinate(query, [&](double x) {
    if (!integer_or_half_below_16(x)) values.insert(std::fabs(x));
    return true;
  });
  return values.size();
}

/// Every family's first failing cases, each shrunk by itself.
std::vector<fuzz::Finding> shrunk_failures(const char* name, std::uint64_t cases) {
  const auto solver = fuzz::named_solver(name);
  fuzz::Settings settings;
  std::vector<fuzz::Finding> shrunk;
  for (const FamilyInfo& family : all_families()) {
    for (const Kind kind : kKinds) {
      if (!solver->supports(kind)) continue;
      for (std::uint64_t index = 0; index < cases; ++index) {
        auto finding = fuzz::run_case(*solver, {{family.family, kind, 11, index}, 0}, settings).finding;
        if (finding) shrunk.push_back(std::move(*finding));
      }
    }
  }
  return shrunk;
}

}  // namespace

// A phantom of a solver with slack passes within that slack, some 2^-46 of the elements' size, which integers and
// halves below 16 cannot. Such a query needs one extraordinary value.
TEST_CASE("most shrunk failures of solvers in doubles are integers or halves below 16", "[slow]") {
  const auto name = GENERATE("paper", "closed_form");
  std::size_t all = 0, readable = 0, phantoms = 0, readable_phantoms = 0;
  const auto solver = fuzz::named_solver(name);
  for (const fuzz::Finding& finding : shrunk_failures(name, std::string(name) == "paper" ? 6 : 20)) {
    const Query original = fuzz::query_of_case(finding.example.name);
    const auto& query = std::get<Query>(finding.example.query);
    CAPTURE(fuzz::case_text(finding.example.name), cpp_initializer(query));
    const Answer truth = solve(query, {.method = Method::exact});
    const auto failure = fuzz::failure_of(query, solver->ask(query), truth, {});
    REQUIRE(failure.has_value());
    CHECK(failure->failure == finding.failure);
    CHECK(fuzz::degeneracy_of(query, truth) == finding.degeneracy);
    CHECK(fuzz::difficulty(query) <= fuzz::difficulty(original));
    const std::size_t odd = odd_values(query);
    if (finding.failure == fuzz::FailureClass::phantom) {
      ++phantoms;
      readable_phantoms += odd <= 1;
    } else {
      ++all;
      readable += odd == 0;
    }
  }
  std::printf(
      "%s: of %zu misses and late times shrunk %zu are integers or halves below 16; of %zu phantoms %zu are but "
      "for one value\n",
      name, all, readable, phantoms, readable_phantoms);
  CHECK(all >= 100);
  CHECK(10 * readable > 8 * all);
  CHECK(phantoms >= 5);
  CHECK(10 * readable_phantoms > 8 * phantoms);
}

TEST_CASE("shrinking to nothing but the reason of the failure") {
  // Fails whenever b1 ends above 2.7 on the y axis: one coordinate is all that needs to stay.
  std::uint64_t asked = 0;
  const auto fails = [&](const Query& query) {
    ++asked;
    CHECK(every_coordinate(query, [](double x) { return std::isfinite(x); }));
    return query.end[3].y > 2.7;
  };
  Rng rng(5);
  for (int i = 0; i < 50; ++i) {
    Query query = make(i % 2 == 0 ? Family::random_doubles : Family::lattice4, Kind::edge_edge, rng);
    query.end[3].y = 3.25 + rng.unit();
    const Query small = fuzz::shrink(query, fails);
    CAPTURE(cpp_initializer(query), cpp_initializer(small));
    CHECK(small.end[3].y > 2.7);
    std::size_t not_zero = 0;
    every_coordinate(small, [&](double x) {
      not_zero += x != 0;
      return true;
    });
    CHECK(not_zero <= 2);
    CHECK(every_coordinate(small, integer_or_half_below_16));
  }
  CHECK(asked > 0);
}

TEST_CASE("shrinking is the same every time, stays within its tries, and ends when told") {
  Rng rng(6);
  const Query query = make(Family::random_doubles, Kind::vertex_face, rng);
  std::uint64_t asked = 0;
  const auto fails = [&](const Query& candidate) {
    ++asked;
    return candidate.start[0].x + candidate.end[2].z * candidate.end[1].y != 0;
  };
  const Query first = fuzz::shrink(query, fails);
  CHECK(cpp_initializer(first) == cpp_initializer(fuzz::shrink(query, fails)));
  for (const std::uint64_t tries : {1u, 10u, 100u}) {
    asked = 0;
    fuzz::shrink(query, fails, {tries, {}});
    CHECK(asked <= tries);
    CHECK(asked > 0);
  }
  asked = 0;
  fuzz::shrink(query, fails, {20'000, [] { return true; }});
  CHECK(asked <= 1);
}

TEST_CASE("a query that cannot be simpler stays") {
  Query query;
  query.kind = Kind::point_edge;
  const auto fails = [](const Query&) { return true; };
  CHECK(cpp_initializer(fuzz::shrink(query, fails)) == cpp_initializer(query));
  Rng rng(7);
  const Query random = make(Family::huge, Kind::point_point, rng);
  CHECK(cpp_initializer(fuzz::shrink(random, [](const Query&) { return false; })) == cpp_initializer(random));
}

TEST_CASE("difficulty puts what is easy to read first") {
  const auto of = [](double x) {
    Query query;
    query.kind = Kind::point_point;
    query.start[0].x = query.end[0].x = x;
    return fuzz::difficulty(query);
  };
  const std::vector<double> ascending{0, -0.0, 1, 2, 4, 8, 0.5, 1.5, 5.25, 0.1, 1e-300};
  for (std::size_t i = 1; i < ascending.size(); ++i) {
    CAPTURE(ascending[i]);
    CHECK(of(ascending[i - 1]) <= of(ascending[i]));
  }
  CHECK(of(1) < of(-1));
  Query standing;
  standing.start[0].x = standing.end[0].x = 3;
  Query moving = standing;
  moving.end[0].x = 4;
  CHECK(fuzz::difficulty(standing) < fuzz::difficulty(moving));
}
