// Neighbours in a mesh: decided without the cubic, exactly as the exact level decides.
// SPDX-License-Identifier: MIT
#include "filters/shared_corner.hpp"

#include <touchstone/solve.hpp>

#include "exact/exact.hpp"
#include "support/answer_check.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/query_text.hpp"

using namespace touchstone;
using namespace touchstone::tests;

TEST_CASE("queries with a shared corner are decided without the cubic, but for edges that are parallel there") {
  for (const Kind kind : kKinds) {
    long filtered = 0;
    for (std::uint64_t index = 0; index < 2000; ++index) {
      const CaseId id{Family::shared_corner, kind, 71, index};
      const Query query = make(id);
      for (const double t_max : {1.0, 0.5, 0.0}) {
        const Answer answer = solve(query, t_max);
        INFO(case_name(id) << " t_max " << t_max << "  " << cpp_initializer(query));
        REQUIRE(decision_difference(answer, exact::decide(query, t_max)).empty());
        REQUIRE(answer.nature == (t_max > 0 ? Nature::sustained : Nature::isolated));
        filtered += answer.level == Level::filter;
      }
    }
    CHECK(filtered > 5000);
  }
}

TEST_CASE("what looks like a shared corner is not always one") {
  Answer answer;
  // The corners coincide at the start only.
  CHECK_FALSE(filters::touch_in_shared_corner(
      EdgeEdge{{{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 1, 0}}}, {{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 1}}}}, 1, answer));
  // Edges that leave the shared corner in one direction overlap.
  const std::array<Vec3, 4> folded = {{{0, 0, 0}, {2, 0, 0}, {0, 0, 0}, {1, 0, 0}}};
  CHECK_FALSE(filters::touch_in_shared_corner(EdgeEdge{folded, folded}, 1, answer));
  CHECK(solve(EdgeEdge{folded, folded}).feature_a == Feature::overlap);
  // An edge of zero length is no direction.
  const std::array<Vec3, 4> point = {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 0, 0}}};
  CHECK_FALSE(filters::touch_in_shared_corner(EdgeEdge{point, point}, 1, answer));
  // v shares f2, where f1 happens to be at the start, too: the first name counts.
  const VertexFace face{{{{1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}}}, {{{1, 1, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}}}};
  CHECK(filters::touch_in_shared_corner(face, 1, answer));
  CHECK(answer.feature_b == Feature::f1);
}
