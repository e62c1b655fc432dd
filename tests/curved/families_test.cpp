// The families of curved queries: what they promise, and the methods' agreement on them.
// SPDX-License-Identifier: MIT
#include <array>
#include <cstdio>
#include <string>

#include <touchstone/curved.hpp>
#include <touchstone/error.hpp>

#include "support/answer_check.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/query_text.hpp"
#include "support/slow_build.hpp"

namespace touchstone::tests {
namespace {

constexpr std::uint64_t kSeed = 61;

/// Calls f for `count` cases of every kind of every family of curved queries.
template <typename F>
void for_each_curved_case(std::size_t count, F&& f) {
  for (const FamilyInfo& family : curved_families()) {
    for (const Kind kind : kKinds) {
      for (std::uint64_t index = 0; index < effort(count); ++index) f(CaseId{family.family, kind, kSeed, index});
    }
  }
}

TEST_CASE("curved families: each has its place, its name and its group") {
  CHECK(curved_families().size() >= 20);
  for (const FamilyInfo& family : curved_families()) {
    CHECK(&info(family.family) == &family);
    CHECK(find_family(family.name) == &family);
    CHECK(is_curved(family.family));
    CHECK(family.group == Group::curved);
    CHECK_FALSE(family.about.empty());
    Rng rng(1);
    CHECK_THROWS_AS(make(family.family, Kind::edge_edge, rng), InvalidQuery);
  }
  for (const FamilyInfo& family : all_families()) {
    CHECK(find_family(family.name) == &family);
    CHECK_FALSE(is_curved(family.family));
    Rng rng(1);
    CHECK_THROWS_AS(make_curved(family.family, Kind::edge_edge, rng), InvalidQuery);
  }
  CHECK(find_family("nothing") == nullptr);
}

TEST_CASE("curved families: a case's name makes the same query again") {
  const CaseId id{Family::near_meeting, Kind::vertex_face, 7, 1234};
  CHECK(case_name(id) == "near_meeting vertex-face 7 1234");
  const auto parsed = parse_case(case_name(id));
  REQUIRE(parsed.has_value());
  for_each_curved_case(2, [](const CaseId& each) {
    const auto again = parse_case(case_name(each));
    REQUIRE(again.has_value());
    const CurvedSample one = make_curved(each), other = make_curved(*again);
    CHECK(curved_text(one.query) == curved_text(other.query));
    CHECK(one.t_max == other.t_max);
    CHECK(one.touches_at == other.touches_at);
  });
}

// This fixes the generators on every machine: a case's name in a report means one query everywhere.
TEST_CASE("curved families: the numbers of a case are the same on every machine") {
  std::uint64_t hash = 0;
  for (const Family family : {Family::turn_meets_half, Family::gears, Family::spline, Family::large_turn}) {
    const CurvedSample sample = make_curved({family, Kind::edge_edge, 3, 14});
    for (const char c : curved_text(sample.query)) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3u;
  }
  CHECK(hash == 0xf8e402bba38bf4b0u);
}

TEST_CASE("curved families: elements touch where the construction says so") {
  std::size_t planned = 0;
  for_each_curved_case(20, [&](const CaseId& id) {
    const CurvedSample sample = make_curved(id);
    if (!sample.touches_at) return;
    ++planned;
    INFO(case_name(id) << "\n" << curved_text(sample.query));
    CHECK(*sample.touches_at <= sample.t_max);
    bool touches = false;
    for (const ContactInterval& interval : contact_times(sample.query)) {
      touches =
          touches || (interval.first.upper() <= *sample.touches_at && interval.last.lower() >= *sample.touches_at);
    }
    CHECK(touches);
  });
  std::printf("%zu planned contacts\n", planned);
  CHECK(planned > 20);
}

/// What a family's queries came to.
struct Seen {
  std::size_t queries = 0, contacts = 0, by_filter = 0;
  std::array<std::size_t, 5> natures{};
};

void check_agreement(const CaseId& id, bool by_oracle, Seen& seen) {
  const CurvedSample sample = make_curved(id);
  const Answer exact = solve(sample.query, {.t_max = sample.t_max, .method = Method::exact});
  const Answer fast = solve(sample.query, sample.t_max);
  ++seen.queries;
  seen.contacts += exact.contact;
  seen.by_filter += fast.level != Level::exact;
  ++seen.natures[static_cast<std::size_t>(exact.nature)];
  INFO(case_name(id) << ", t_max " << hexfloat(sample.t_max) << "\n" << curved_text(sample.query));
  INFO("exact:  " << describe(exact));
  CHECK(decision_difference(exact, fast) == "");
  CHECK(weight_difference(exact, fast) == "");
  CHECK(malformation(id.kind, exact, sample.t_max) == "");
  if (!by_oracle) return;
  const Answer oracle = solve(sample.query, {.t_max = sample.t_max, .method = Method::oracle});
  INFO("oracle: " << describe(oracle));
  CHECK(decision_difference(exact, oracle) == "");
  CHECK(weight_difference(exact, oracle) == "");
}

TEST_CASE("curved families: fast, exact and oracle agree, and every family has contacts and misses") {
  constexpr std::size_t kCases = 24, kOraclesOf = 6;
  for (const FamilyInfo& family : curved_families()) {
    Seen seen;
    for (const Kind kind : kKinds) {
      for (std::uint64_t index = 0; index < effort(kCases); ++index) {
        check_agreement({family.family, kind, kSeed, index}, index % kOraclesOf == 0, seen);
      }
    }
    std::printf(
        "%-17s %zu queries, %zu contacts: %zu crossing, %zu grazing, %zu sustained, %zu isolated; %zu by filters\n",
        std::string(family.name).c_str(), seen.queries, seen.contacts, seen.natures[1], seen.natures[2],
        seen.natures[3], seen.natures[4], seen.by_filter);
    if (!whole_effort("that every curved family has contacts and misses")) continue;
    INFO(family.name);
    CHECK(seen.contacts > 0);
    const bool touch_at_once = family.family == Family::turn_meets_start;  // for any t_max
    CHECK((seen.contacts < seen.queries) == !touch_at_once);
  }
}

}  // namespace
}  // namespace touchstone::tests
