// Points and edges in two dimensions: the bracket level answers about them as the exact level does.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <optional>

#include "exact/exact.hpp"
#include "filters/filters.hpp"
#include "filters/planar_point_edge.hpp"
#include "seeded/rng.hpp"
#include "support/answer_check.hpp"
#include "support/catch.hpp"
#include "support/query_text.hpp"

using namespace touchstone;
using filters::Outcome;
using seeded::Rng;

namespace {

/// Three corners in a plane across coordinate `across`, which is `level` everywhere.
Query planar(Rng& rng, int across, double level, double coordinate(Rng&)) {
  Query q;
  q.kind = Kind::point_edge;
  constexpr double Vec3::*kAxes[] = {&Vec3::x, &Vec3::y, &Vec3::z};
  for (auto* side : {&q.start, &q.end}) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) (*side)[i].*kAxes[k] = k == across ? level : coordinate(rng);
    }
  }
  return q;
}

double any(Rng& rng) { return rng.symmetric(); }
double small_integer(Rng& rng) { return rng.between(-2, 2); }
double far_off(Rng& rng) { return 1e6 + rng.symmetric(); }
double of_any_size(Rng& rng) { return std::ldexp(rng.symmetric(), rng.between(-40, 40)); }

struct Count {
  int contacts = 0, bracket = 0;
};

Count compare(double coordinate(Rng&), int count) {
  Rng rng(17);
  Count found;
  for (int i = 0; i < count; ++i) {
    const double levels[] = {0, -1, 0.1, 1e9, 0x1p-1074};
    const Query query = planar(rng, i % 3, levels[rng.below(5)], coordinate);
    const double t_max = i % 4 == 0 ? rng.unit() : 1;
    const Answer exact = exact::decide_exactly(query, t_max);
    Answer answer;
    const auto decision = filters::decide_by_filters({query, t_max, exact::coplanarity_at}, answer);
    Answer ignored;
    const auto any = filters::decide_by_filters({query, t_max, exact::coplanarity_at, Wanted::contact}, ignored);
    CAPTURE(i, t_max, tests::describe(exact));
    if (decision.finding == Outcome::uncertain) continue;
    REQUIRE(any.finding == decision.finding);
    // An extreme query may be rescaled for the time and not for the contact alone.
    if (decision.test != filters::Test::rescaled) REQUIRE(any.test == decision.test);
    REQUIRE((decision.finding == Outcome::contact) == exact.contact);
    found.bracket += answer.level == Level::bracket;
    if (!exact.contact) continue;
    ++found.contacts;
    REQUIRE(tests::decision_difference(answer, exact) == "");
    REQUIRE(tests::weight_difference(answer, exact) == "");
    REQUIRE(tests::malformation(query.kind, answer, t_max) == "");
  }
  return found;
}

}  // namespace

TEST_CASE("a point and an edge in a plane: the answers of the filters and the bracket level are the exact ones") {
  const Count ordinary = compare(any, 20'000);
  CHECK(ordinary.contacts > 3000);
  CHECK(ordinary.bracket > 9000);
  const Count distant = compare(far_off, 5000);
  CHECK(distant.contacts > 500);
  const Count uneven = compare(of_any_size, 5000);
  CHECK(uneven.contacts > 100);
  const Count lattice = compare(small_integer, 20'000);
  CHECK(lattice.contacts > 1000);
}

TEST_CASE("ordinary contacts of a point and an edge in a plane need no exact arithmetic") {
  Rng rng(3);
  int contacts = 0, undecided = 0;
  for (int i = 0; i < 5000; ++i) {
    const Query query = planar(rng, 2, 0, any);
    Answer answer;
    const Outcome finding = filters::decide_by_filters({query, 1, exact::coplanarity_at}, answer).finding;
    contacts += finding == Outcome::contact;
    undecided += finding == Outcome::uncertain;
  }
  CHECK(contacts > 500);
  CHECK(undecided < 10);
}

TEST_CASE("only a point and an edge that stay in a coordinate plane are made edges of") {
  Rng rng(5);
  Query query = planar(rng, 1, 0.25, any);
  const std::optional<Query> edges = filters::as_crossing_edges(query);
  REQUIRE(edges);
  CHECK(edges->kind == Kind::edge_edge);
  query.end[2].y = std::nextafter(0.25, 1.0);
  CHECK_FALSE(filters::as_crossing_edges(query));
  // All corners in one place, and differences that no double holds.
  query = {};
  query.kind = Kind::point_edge;
  CHECK_FALSE(filters::as_crossing_edges(query));
  query.start[0].x = 1.7e308;
  query.start[1].x = -1.7e308;
  CHECK_FALSE(filters::as_crossing_edges(query));
  // The least difference that a double holds.
  query.start[0].x = 0x1p-1074;
  query.start[1].x = 0;
  CHECK(filters::as_crossing_edges(query));
}
