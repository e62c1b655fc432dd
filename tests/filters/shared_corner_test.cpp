// Neighbours in a mesh are decided without the cubic, and exactly as the exact level decides them.
// SPDX-License-Identifier: MIT
#include "filters/apart/shared_corner.hpp"

#include <array>
#include <cmath>
#include <cstdint>

#include <touchstone/solve.hpp>

#include "support/answer_check.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/query_text.hpp"

// The bound under test is private to this file, which is compiled here a second time.
#include "filters/apart/shared_corner.cpp"  // NOLINT(bugprone-suspicious-include)

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
        REQUIRE(decision_difference(answer, solve(query, {.t_max = t_max, .method = Method::exact})).empty());
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
      EdgeEdge{{{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 1, 0}}}, {{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 1}}}}, 1,
      answer));
  // Edges that leave the shared corner in one direction overlap.
  const std::array<Vec3, 4> folded = {{{0, 0, 0}, {2, 0, 0}, {0, 0, 0}, {1, 0, 0}}};
  CHECK_FALSE(filters::touch_in_shared_corner(EdgeEdge{folded, folded}, 1, answer));
  CHECK(solve(EdgeEdge{folded, folded}).feature_a == Feature::overlap);
  // An edge of zero length has no direction.
  const std::array<Vec3, 4> point = {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 0, 0}}};
  CHECK_FALSE(filters::touch_in_shared_corner(EdgeEdge{point, point}, 1, answer));
  // v shares f2, where f1 happens to be at the start, too: the first name counts.
  const VertexFace face{{{{1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}}}, {{{1, 1, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}}}};
  CHECK(filters::touch_in_shared_corner(face, 1, answer));
  CHECK(answer.feature_b == Feature::f1);
}

TEST_CASE("edges that are parallel are never certainly not parallel, at any magnitude") {
  // One edge is three times the other, in integers. The rounded difference of its corners is not exact.
  Rng rng(88);
  long differ = 0;
  for (int i = 0; i < 60000; ++i) {
    const int scale = i % 3 == 0 ? -53 : i % 3 == 1 ? -568 + i % 5 : 400;  // products of 1, just subnormal, and huge
    Query query;
    for (double Vec3::*const axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
      constexpr std::int64_t kMost = std::int64_t{1} << 53;  // doubles hold the whole numbers up to here
      auto length = static_cast<std::int64_t>(rng.bits() >> 12);
      auto from = -static_cast<std::int64_t>(rng.bits() >> 11);
      if (from + 3 * length > kMost) {
        length /= 4;
        from = -3 * length;
      }
      const auto put = [&](Vec3& corner, std::int64_t n) { corner.*axis = std::ldexp(static_cast<double>(n), scale); };
      put(query.start[0], from);
      put(query.start[1], from + 3 * length);
      put(query.start[2], 0);
      put(query.start[3], length);
    }
    const Vec3 &a = query.start[0], &b = query.start[1], &c = query.start[3];
    differ += (b.x - a.x) * c.y != (b.y - a.y) * c.x;
    REQUIRE_FALSE(filters::certainly_not_parallel(query));
  }
  CHECK(differ > 1000);
}
