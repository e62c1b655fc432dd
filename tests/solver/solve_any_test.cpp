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

TEST_CASE("solve_any says what solve says, for every family and up to any time") {
  long contacts = 0, cut = 0;
  for (const FamilyInfo& family : all_families()) {
    for (const Kind kind : kKinds) {
      for (std::uint64_t index = 0; index < 120; ++index) {
        const CaseId id{family.family, kind, 81, index};
        const Query query = make(id);
        const Answer answer = solve(query, Method::exact);
        INFO(case_name(id) << "  " << cpp_initializer(query));
        REQUIRE(solve_any(query) == answer.contact);
        if (!answer.contact) continue;
        ++contacts;
        // Up to the exact time and just short of it.
        REQUIRE(solve_any(query, answer.toi_upper));
        if (answer.toi < answer.toi_upper) REQUIRE_FALSE(solve_any(query, answer.toi));
        if (answer.toi == answer.toi_upper && answer.toi > 0) {
          REQUIRE_FALSE(solve_any(query, std::nextafter(answer.toi, 0.0)));
          ++cut;
        }
      }
    }
  }
  CHECK(contacts > 1000);
  CHECK(cut > 100);
}

TEST_CASE("solve_any rejects what solve rejects") {
  Query query;
  CHECK_THROWS_AS(solve_any(query, 1.5), InvalidQuery);
  query.end[3].z = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(solve_any(query), InvalidQuery);
}
