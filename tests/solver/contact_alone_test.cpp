// Contact without its time: the same yes or no as the whole answer's.
// SPDX-License-Identifier: MIT
#include <touchstone/error.hpp>
#include <touchstone/solve.hpp>

#include <cmath>
#include <limits>

#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/query_text.hpp"

using namespace touchstone;
using namespace touchstone::tests;

TEST_CASE("the contact alone is that of solve, for every family and up to any time") {
  long contacts = 0, cut = 0;
  for (const FamilyInfo& family : all_families()) {
    for (const Kind kind : kKinds) {
      for (std::uint64_t index = 0; index < 120; ++index) {
        const CaseId id{family.family, kind, 81, index};
        const Query query = make(id);
        const Answer answer = solve(query, {.method = Method::exact});
        INFO(case_name(id) << "  " << cpp_initializer(query));
        REQUIRE(solve(query, {.wanted = Wanted::contact}).contact == answer.contact);
        if (!answer.contact) continue;
        ++contacts;
        // Up to the exact time and just short of it.
        REQUIRE(solve(query, {.t_max = answer.toi_upper, .wanted = Wanted::contact}).contact);
        if (answer.toi < answer.toi_upper)
          REQUIRE_FALSE(solve(query, {.t_max = answer.toi, .wanted = Wanted::contact}).contact);
        if (answer.toi == answer.toi_upper && answer.toi > 0) {
          REQUIRE_FALSE(solve(query, {.t_max = std::nextafter(answer.toi, 0.0), .wanted = Wanted::contact}).contact);
          ++cut;
        }
      }
    }
  }
  CHECK(contacts > 1000);
  CHECK(cut > 100);
}

TEST_CASE("the contact alone is refused as solve refuses") {
  Query query;
  CHECK_THROWS_AS(solve(query, {.t_max = 1.5, .wanted = Wanted::contact}), InvalidQuery);
  query.end[3].z = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(solve(query, {.wanted = Wanted::contact}), InvalidQuery);
}
