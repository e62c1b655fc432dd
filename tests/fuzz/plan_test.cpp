// A plan's pieces hold every case once.
// SPDX-License-Identifier: MIT
#include "fuzz/plan.hpp"

#include <map>
#include <tuple>

#include "support/catch.hpp"

using namespace touchstone;
using families::Family;

TEST_CASE("the pieces of a plan hold as many cases as asked for, each once, shared out evenly") {
  const auto cases = GENERATE(1u, 5u, 6u, 7u, 1000u, 1537u, 12'345u);
  CAPTURE(cases);
  const fuzz::Plan plan({Family::lattice1, Family::huge, Family::flat}, {Kind::edge_edge, Kind::point_point}, cases);
  std::map<std::tuple<Family, Kind>, std::uint64_t> next;
  std::uint64_t sum = 0, number = 0;
  while (const auto piece = plan.piece(number++)) {
    auto& first = next[{piece->family, piece->kind}];
    if (piece->count > 0) CHECK(piece->first_case == first);
    first += piece->count;
    sum += piece->count;
    REQUIRE(number < 1000);
  }
  CHECK(sum == cases);
  for (const auto& [pair, count] : next) CHECK((count == cases / 6 || count == cases / 6 + 1));
  CHECK_FALSE(plan.piece(number + 100).has_value());
}

TEST_CASE("a plan without an end goes round all families and kinds") {
  const fuzz::Plan plan({Family::lattice1, Family::huge}, {Kind::edge_edge, Kind::point_edge}, std::nullopt);
  std::map<std::tuple<Family, Kind>, std::uint64_t> next;
  for (std::uint64_t number = 0; number < 4000; ++number) {
    const auto piece = plan.piece(number);
    REQUIRE(piece.has_value());
    auto& first = next[{piece->family, piece->kind}];
    CHECK(piece->first_case == first);
    first += piece->count;
  }
  CHECK(next.size() == 4);
}

TEST_CASE("as many given queries are asked as wanted, those of other kinds not counted") {
  std::vector<fuzz::AnyQuery> given(9);
  for (std::size_t i = 0; i < given.size(); ++i)
    std::get<Query>(given[i]).kind = i % 3 == 0 ? Kind::point_point : Kind::edge_edge;
  std::get<Query>(given[7]).kind = Kind::point_edge;
  const auto all = fuzz::plan_of_given(given, {}, {Kind::edge_edge, Kind::point_point}, std::nullopt);
  CHECK(all.to_ask == std::vector<std::uint64_t>{0, 1, 2, 3, 4, 5, 6, 8});
  CHECK(all.selected == 9);
  CHECK(all.not_taken == 1);
  const auto some = fuzz::plan_of_given(given, {Kind::edge_edge, Kind::point_edge}, {Kind::edge_edge}, 3);
  CHECK(some.to_ask == std::vector<std::uint64_t>{1, 2, 4});
  CHECK(some.selected == 6);
  CHECK(some.not_taken == 1);
}

TEST_CASE("a plan of nothing is empty") {
  CHECK_FALSE(fuzz::Plan({}, {Kind::edge_edge}, std::nullopt).piece(0).has_value());
  CHECK_FALSE(fuzz::Plan({Family::flat}, {}, 100).piece(0).has_value());
}
