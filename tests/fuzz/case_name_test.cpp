// A case's name is enough to make its query again. Any other text is refused.
// SPDX-License-Identifier: MIT
#include "fuzz/case_name.hpp"

#include "fuzz/climb.hpp"
#include "support/catch.hpp"
#include "support/curved_query.hpp"
#include "support/query_text.hpp"

using namespace touchstone;
using namespace touchstone::tests;

TEST_CASE("a name and its text are one") {
  const auto text = GENERATE("lattice1 edge-edge 1 0", "mixed_scale point-point 18446744073709551615 12",
                             "near_hit vertex-face 7 1234 +5", "given edge-edge 1 17", "given point-edge 3 0 +9");
  const auto name = fuzz::parse_case_text(text);
  REQUIRE(name.has_value());
  CHECK(fuzz::case_text(*name) == text);
}

TEST_CASE("what is no name is refused") {
  const auto text = GENERATE(
      "", "lattice1", "lattice1 edge-edge 1", "lattice1 edge-edge 1 2 3", "lattice1 edge-edge 1 -2",
      "lattice1 edge-edge 1 2x", "lattice9 edge-edge 1 2", "lattice1 edge 1 2",
      "lattice1 edge-edge 18446744073709551616 2", "lattice1 edge-edge 1 2 +", "lattice1 edge-edge 1 2 +99999999999",
      "lattice1 edge-edge 1 2 +1 4", "LATTICE1 edge-edge 1 2", "given edge 1 2", "given edge-edge 1");
  CAPTURE(text);
  CHECK_FALSE(fuzz::parse_case_text(text).has_value());
}

TEST_CASE("a name makes the query that it names") {
  const families::CaseId id{families::Family::grazing_apart, Kind::edge_edge, 3, 14};
  CHECK(cpp_initializer(fuzz::query_of_case({id, 0})) == cpp_initializer(families::make(id)));
  fuzz::Climb climb(id);
  for (std::uint64_t step = 1; step < 20; ++step) {
    CHECK(cpp_initializer(std::get<Query>(climb.next())) == cpp_initializer(fuzz::query_of_case({id, step})));
  }
}

TEST_CASE("with separations of their own a name makes the query and its distance") {
  const families::CaseId id{families::Family::gap_irrational, Kind::vertex_face, 3, 14};
  for (const Metric metric : {Metric::euclidean, Metric::max}) {
    const families::Separated made = families::make_separated(id, metric);
    const fuzz::CaseSource source{{}, {1, metric}, true};
    const fuzz::Asked asked = fuzz::asked_in_case({id, 0}, source);
    CHECK(cpp_initializer(std::get<Query>(asked.query)) == cpp_initializer(made.query));
    CHECK(asked.separation.distance == made.distance);
    CHECK(asked.separation.metric == metric);
    fuzz::Climb climb = fuzz::climb_from({id, 0}, source);
    for (std::uint64_t step = 1; step < 20; ++step) {
      const fuzz::Asked later = fuzz::asked_in_case({id, step}, source);
      CHECK(cpp_initializer(std::get<Query>(climb.next())) == cpp_initializer(std::get<Query>(later.query)));
      CHECK(later.separation.distance == made.distance);
    }
  }
}

TEST_CASE("with separations of their own a name makes the curved query, its distance and its time range") {
  const families::CaseId id{families::Family::gears, Kind::vertex_face, 3, 14};
  for (const Metric metric : {Metric::euclidean, Metric::max}) {
    families::Rng rng = families::rng_of(id);
    const families::CurvedSeparated made = families::make_curved_separated(id.family, id.kind, metric, rng);
    const fuzz::Asked asked = fuzz::asked_in_case({id, 0}, {{}, {1, metric}, true});
    CHECK(same(std::get<CurvedQuery>(asked.query), made.sample.query));
    CHECK(asked.t_max == made.sample.t_max);
    CHECK(made.distance > 0);
    CHECK(asked.separation.distance == made.distance);
    CHECK(asked.separation.metric == metric);
    CHECK(same(families::make_curved(id).query, made.sample.query));
  }
}

TEST_CASE("the name of a query that was given makes that query, and its climb") {
  const std::vector<fuzz::AnyQuery> given{families::make({families::Family::near_hit, Kind::point_edge, 5, 1}),
                                          families::make({families::Family::near_hit, Kind::edge_edge, 5, 2})};
  fuzz::CaseName name{{{}, Kind::edge_edge, 3, 1}, 0, true};
  CHECK(cpp_initializer(fuzz::query_of_case(name, given)) == cpp_initializer(std::get<Query>(given[1])));
  fuzz::Climb climb(given[1], families::rng_of(name.start));
  for (name.step = 1; name.step < 20; ++name.step) {
    CHECK(cpp_initializer(std::get<Query>(climb.next())) == cpp_initializer(fuzz::query_of_case(name, given)));
  }
  name.start.index = 2;
  CHECK_THROWS_WITH(fuzz::query_of_case(name, given), Catch::Contains("no such query was given"));
  name.start.index = 0;
  CHECK_THROWS_WITH(fuzz::query_of_case(name, given), Catch::Contains("no such query was given"));
}
