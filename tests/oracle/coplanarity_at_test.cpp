// V at a double through CGAL's number types: against known values, and against our own exact arithmetic.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "exact/exact.hpp"
#include "filters/filters.hpp"
#include "oracle/oracle.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/query_text.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

int sign(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

/// Each is within 2^-50 of V, or within the least double where it underflows.
bool near_each_other(double a, double b) {
  if (std::isinf(a) || std::isinf(b)) return a == b || std::min(std::fabs(a), std::fabs(b)) > 0x1.ffffp1023;
  return std::fabs(a - b) <= 0x1p-49 * std::max(std::fabs(a), std::fabs(b)) + 2 * 0x1p-1074;
}

long asked = 0;
double counted_coplanarity_at(const Query& query, double t) {
  ++asked;
  return oracle::coplanarity_at(query, t);
}

}  // namespace

TEST_CASE("V at a double by CGAL, with its exact sign") {
  const Query query(
      EdgeEdge{{{{-1, 0, 0}, {1, 0, 0}, {0, -1, 1}, {0, 1, 1}}}, {{{-1, 0, 0}, {1, 0, 0}, {0, -1, -1}, {0, 1, -1}}}});
  CHECK(oracle::coplanarity_at(query, 0.5) == 0);  // V = 4 - 8t
  CHECK(oracle::coplanarity_at(query, std::nextafter(0.5, 0)) == 8 * 0x1p-54);
  CHECK(oracle::coplanarity_at(query, std::nextafter(0.5, 1)) == -8 * 0x1p-53);
  // v falls from z = 1 to -1 through the face z = 0 with n = (0, 0, 16): V = 16 - 32 t.
  const Query face(
      VertexFace{{{{1, 1, 1}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{{1, 1, -1}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}});
  CHECK(oracle::coplanarity_at(face, 0.5) == 0);
  CHECK(oracle::coplanarity_at(face, 0.25) == 8);
  CHECK(oracle::coplanarity_at(face, 0x1.0000000000001p-1) == -32 * 0x1p-53);
}

TEST_CASE("V by CGAL underflows to the least double of its sign and overflows to infinity") {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double z : {1.0, -1.0}) {
    const auto gap = [z](double size) {
      const std::array<Vec3, 4> corners{{{-size, 0, 0}, {size, 0, 0}, {0, -size, z * size}, {0, size, z * size}}};
      return Query(EdgeEdge{corners, corners});
    };
    CHECK(oracle::coplanarity_at(gap(0x1p-400), 0.5) == z * 0x1p-1074);
    CHECK(oracle::coplanarity_at(gap(0x1p-358), 0.5) == z * 0x1p-1072);
    CHECK(oracle::coplanarity_at(gap(0x1p400), 0.5) == z * kInfinity);
  }
}

TEST_CASE("V by CGAL is V by our own exact arithmetic, in every family and at every sort of time") {
  long zeros = 0, negative = 0, positive = 0;
  for (const FamilyInfo& family : all_families()) {
    for (const Kind kind : {Kind::edge_edge, Kind::vertex_face}) {
      for (std::uint64_t index = 0; index < 60; ++index) {
        const CaseId id{family.family, kind, 91, index};
        const Query query = make(id);
        const Answer answer = exact::decide_exactly(query, 1);
        const double toi = answer.contact ? answer.toi : 0x1.fp-40;
        for (const double t :
             {0.0, 1.0, 0.5, 0x1.5555555555555p-2, toi, answer.contact ? answer.toi_upper : 0x1p-1074}) {
          const double by_cgal = oracle::coplanarity_at(query, t);
          const double ours = exact::coplanarity_at(query, t);
          INFO(case_name(id) << " at " << hexfloat(t) << "  " << cpp_initializer(query));
          REQUIRE(sign(by_cgal) == sign(ours));
          REQUIRE(near_each_other(by_cgal, ours));
          ++(ours == 0 ? zeros : ours < 0 ? negative : positive);
        }
      }
    }
  }
  CHECK(zeros > 1000);
  CHECK(negative > 1000);
  CHECK(positive > 1000);
}

TEST_CASE("the bracket level asks CGAL for values, and decides by them") {
  long decided = 0;
  for (const FamilyInfo& family : all_families()) {
    for (const Kind kind : {Kind::edge_edge, Kind::vertex_face}) {
      for (std::uint64_t index = 0; index < 200; ++index) {
        const CaseId id{family.family, kind, 92, index};
        const Query query = make(id);
        const long before = asked;
        Answer answer;
        const auto [finding, test] = filters::decide_by_filters({query, 1, counted_coplanarity_at}, answer);
        if (asked == before || finding == filters::Outcome::uncertain) continue;
        ++decided;
        const Answer truth = exact::decide_exactly(query, 1);
        INFO(case_name(id) << "  " << cpp_initializer(query));
        REQUIRE((finding == filters::Outcome::contact) == truth.contact);
        if (!truth.contact) continue;
        REQUIRE(answer.toi == truth.toi);
        REQUIRE(answer.toi_upper == truth.toi_upper);
      }
    }
  }
  CHECK(decided > 200);
}
