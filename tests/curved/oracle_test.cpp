// The exact level and the oracle on seeded curved queries, random and degenerate, in every part of the answer.
// SPDX-License-Identifier: MIT
#include <array>
#include <cstdio>

#include <touchstone/curved.hpp>

#include "curved/queries.hpp"
#include "support/answer_check.hpp"
#include "support/catch.hpp"
#include "support/query_text.hpp"
#include "support/slow_build.hpp"

namespace touchstone::tests {
namespace {

constexpr std::uint64_t kSeed = 43;

void exact_and_oracle_agree(const char* name, Maker make, Kind kind, std::size_t count) {
  std::size_t contacts = 0;
  std::array<std::size_t, 6> natures{};
  for (std::uint64_t index = 0; index < effort(count); ++index) {
    Rng rng(seeded::seed_of_stream(kSeed + static_cast<std::uint64_t>(kind), index));
    const CurvedQuery query = make(kind, rng);
    const double t_max = rng.one_in(4) ? rng.unit() : 1;
    const Answer fast = solve(query, t_max);
    const Answer exact = solve(query, {.t_max = t_max, .method = Method::exact});
    const Answer oracle = solve(query, {.t_max = t_max, .method = Method::oracle});
    contacts += exact.contact;
    ++natures[static_cast<std::size_t>(exact.nature)];
    INFO("seed " << kSeed << ", index " << index << ", t_max " << hexfloat(t_max) << "\n" << text_of(query));
    INFO("exact:  " << describe(exact));
    INFO("oracle: " << describe(oracle));
    REQUIRE(decision_difference(exact, oracle) == "");
    REQUIRE(weight_difference(exact, oracle) == "");
    REQUIRE(decision_difference(exact, fast) == "");
    REQUIRE(weight_difference(exact, fast) == "");
    REQUIRE(malformation(kind, exact, t_max) == "");
    const std::vector<ContactInterval> times = contact_times(query, {}, t_max);
    REQUIRE(!times.empty() == exact.contact);
    if (exact.contact) {
      REQUIRE(times.front().first.lower() == exact.toi);
      REQUIRE(times.front().first.upper() == exact.toi_upper);
    }
  }
  std::printf(
      "seed %llu, %s, %s: %zu queries, %zu with contact: %zu crossing, %zu grazing, %zu sustained, %zu isolated\n",
      static_cast<unsigned long long>(kSeed), name, name_of(kind).data(), effort(count), contacts, natures[1],
      natures[2], natures[3], natures[4]);
  if (whole_effort("that some curved queries of a family touch")) CHECK(contacts > 0);
}

/// Two points of these families hardly ever meet.
void for_elements(const char* name, Maker make, std::size_t count) {
  for (const Kind kind : {Kind::edge_edge, Kind::vertex_face, Kind::point_edge}) {
    exact_and_oracle_agree(name, make, kind, count);
  }
}

void for_all_kinds(const char* name, Maker make, std::size_t count) {
  for (const Kind kind : {Kind::edge_edge, Kind::vertex_face, Kind::point_edge, Kind::point_point}) {
    exact_and_oracle_agree(name, make, kind, count);
  }
}

TEST_CASE("exact and oracle agree on curved queries: lattice") { for_all_kinds("lattice", lattice_query, 500); }
TEST_CASE("exact and oracle agree on curved queries: gears") { for_elements("gears", gear_query, 300); }
TEST_CASE("exact and oracle agree on curved queries: screws") { for_elements("screws", screw_query, 300); }
TEST_CASE("exact and oracle agree on curved queries: meeting") { for_all_kinds("meeting", meeting_query, 300); }
TEST_CASE("exact and oracle agree on curved queries: coins") { for_elements("coins", coin_query, 300); }
TEST_CASE("exact and oracle agree on curved queries: random doubles") {
  exact_and_oracle_agree("random", random_query, Kind::edge_edge, 150);
  exact_and_oracle_agree("random", random_query, Kind::vertex_face, 150);
}

}  // namespace
}  // namespace touchstone::tests
