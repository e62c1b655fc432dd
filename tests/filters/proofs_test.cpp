// Each filter test proves something that the ones before it cannot, and never a contact away.
// SPDX-License-Identifier: MIT
#include <array>
#include <cstdio>

#include <touchstone/solve.hpp>

#include "filters/filters.hpp"
#include "oracle/oracle.hpp"
#include "support/answer_check.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/query_text.hpp"

using namespace touchstone;
using namespace touchstone::tests;
using filters::Proof;

namespace {

Query edges(Vec3 a0, Vec3 a1, Vec3 b0, Vec3 b1) {
  Query query;
  query.start = query.end = {a0, a1, b0, b1};
  return query;
}

}  // namespace

TEST_CASE("each test of the filters proves a query that no test before it proves") {
  // Skew lines whose boxes overlap: V is constant and not zero.
  CHECK(filters::separation_proof(edges({0, 0, 0}, {4, 4, 4}, {4, 0, 0}, {0, 4, 4.5})) == Proof::same_side);
  // In one plane (V is zero), boxes apart.
  CHECK(filters::separation_proof(edges({0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {3, 1, 0})) == Proof::boxes);
  // In one plane, boxes overlapping, apart in the plane.
  CHECK(filters::separation_proof(edges({0, 0, 0}, {4, 4, 0}, {1, 0, 0}, {4, 3, 0})) == Proof::closest_points);
  // Touching: nothing proves it away.
  CHECK(filters::separation_proof(edges({0, 0, 0}, {4, 4, 0}, {0, 4, 0}, {4, 0, 0})) == Proof::none);
}

TEST_CASE("what the filters prove is so, and every proof occurs in the families") {
  std::array<long, 6> tally{};
  for (const Kind kind : kKinds) {
    for (const FamilyInfo& family : all_families()) {
      for (std::uint64_t index = 0; index < 40; ++index) {
        const Query query = make({family.family, kind, 7, index});
        const Proof proof = filters::separation_proof(query);
        ++tally[static_cast<std::size_t>(proof)];
        if (proof == Proof::none) continue;
        INFO(case_name({family.family, kind, 7, index}) << "  " << cpp_initializer(query));
        REQUIRE_FALSE(oracle::decide(query, 1.0).contact);
      }
    }
  }
  static const char* names[] = {"none", "same side", "boxes", "closest points", "normal", "centres"};
  for (std::size_t i = 0; i < tally.size(); ++i) {
    std::printf("filter proof %-14s %ld\n", names[i], tally[i]);
    CHECK(tally[i] > 0);
  }
}

TEST_CASE("edges so long that a product of their lengths overflows are left to the exact level") {
  // Of u x w, the middle coefficient along x is infinite in doubles, while b0 and b3 are finite and above 0: so doubles see a
  // cubic without roots, but 3 b1 and 3 b2 are below 0.
  constexpr double kLong = 0x1.8p511, kThin = 0x1p-46;
  for (const double r : {1.0, 0x1p-100, 0x1p100}) {
    EdgeEdge query{{{{0, 0, 0}, {0, kLong, 0}, {kThin * r, r, -r / 8}, {kThin * r, r, kLong}}},
                   {{{0, 0, 0}, {kLong, kLong, 0}, {r / 2, r / 4, -r / 8}, {r / 2, r / 4, kLong}}}};
    const Answer truth = oracle::decide(query, 1);
    REQUIRE(truth.contact);
    CHECK(decision_difference(solve(query), truth).empty());
  }
}
