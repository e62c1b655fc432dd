// Each test of the filters decides something that the tests before it cannot, and decides it correctly.
// SPDX-License-Identifier: MIT
#include <array>
#include <cstdio>

#include <touchstone/solve.hpp>

#include "filters/deciding_test.hpp"
#include "oracle/oracle.hpp"
#include "support/answer_check.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/query_text.hpp"

using namespace touchstone;
using namespace touchstone::tests;
using filters::Outcome;
using filters::Test;

namespace {

Query edges(Vec3 a0, Vec3 a1, Vec3 b0, Vec3 b1) {
  Query query;
  query.start = query.end = {a0, a1, b0, b1};
  return query;
}

}  // namespace

TEST_CASE("each test of the filters decides a query that no test before it decides") {
  // Skew lines whose boxes overlap: V is constant and not zero.
  CHECK(deciding_test(edges({0, 0, 0}, {4, 4, 4}, {4, 0, 0}, {0, 4, 4.5})) == Test::same_side);
  // Edges from one corner in two directions.
  CHECK(deciding_test(edges({0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 1, 0})) == Test::shared_corner);
  // In one plane (V is zero), boxes apart.
  CHECK(deciding_test(edges({0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {3, 1, 0})) == Test::boxes);
  // One edge falls through the other: V has one sign change.
  Query falling = edges({-1, 0, 0}, {1, 0, 0}, {0, -1, 1}, {0, 1, 1});
  falling.end[2].z = falling.end[3].z = -1;
  CHECK(deciding_test(falling) == Test::bracket);
  // In one plane, boxes overlapping, apart in the plane.
  CHECK(deciding_test(edges({0, 0, 0}, {4, 4, 0}, {1, 0, 0}, {4, 3, 0})) == Test::separated);
  // Touching in one plane: nothing decides.
  CHECK(deciding_test(edges({0, 0, 0}, {4, 4, 0}, {0, 4, 0}, {4, 0, 0})) == Test::none);
}

TEST_CASE("what the filters decide is so, and every test decides in the families") {
  constexpr std::array kNames = {"same side", "shared corner", "boxes", "bracket", "separated", "rescaled", "none"};
  static_assert(kNames.size() == static_cast<std::size_t>(Test::none) + 1);
  std::array<long, kNames.size()> tally{};
  for (const Kind kind : kKinds) {
    for (const FamilyInfo& family : all_families()) {
      for (std::uint64_t index = 0; index < 40; ++index) {
        const Query query = make({family.family, kind, 7, index});
        const filters::Decision decision = decision_by_filters(query);
        ++tally[static_cast<std::size_t>(decision.test)];
        CHECK((decision.finding == Outcome::uncertain) == (decision.test == Test::none));
        if (decision.finding == Outcome::uncertain) continue;
        INFO(case_name({family.family, kind, 7, index}) << "  " << cpp_initializer(query));
        REQUIRE(oracle::decide_by_oracle(query, 1.0).contact == (decision.finding == Outcome::contact));
      }
    }
  }
  for (std::size_t i = 0; i < tally.size(); ++i) {
    std::printf("filter test %-14s %ld\n", kNames[i], tally[i]);
    CHECK(tally[i] > 0);
  }
}

TEST_CASE("edges so long that a product of their lengths overflows are left to the exact level") {
  // The middle coefficient of (u x w)_x is infinite in doubles, while b0 and b3 are finite and above 0. So doubles see
  // a cubic without roots, but 3 b1 and 3 b2 are below 0.
  constexpr double kLong = 0x1.8p511, kThin = 0x1p-46;
  for (const double r : {1.0, 0x1p-100, 0x1p100}) {
    EdgeEdge query{{{{0, 0, 0}, {0, kLong, 0}, {kThin * r, r, -r / 8}, {kThin * r, r, kLong}}},
                   {{{0, 0, 0}, {kLong, kLong, 0}, {r / 2, r / 4, -r / 8}, {r / 2, r / 4, kLong}}}};
    const Answer truth = oracle::decide_by_oracle(query, 1);
    REQUIRE(truth.contact);
    CHECK(decision_difference(solve(query), truth).empty());
  }
}
