// The kind of degeneracy: nature, features and the polynomials that vanish at all times.
// SPDX-License-Identifier: MIT
#include "fuzz/judging/degeneracy.hpp"

#include <touchstone/solve.hpp>

#include "support/catch.hpp"
#include "support/query_families.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

std::string text_of(const Query& query) { return fuzz::degeneracy_text(fuzz::degeneracy_of(query, solve(query))); }

Query edges(const std::array<Vec3, 4>& start, const std::array<Vec3, 4>& end) { return EdgeEdge{start, end}; }

}  // namespace

TEST_CASE("kinds of degeneracy for a person") {
  const Vec3 o{}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  CHECK(text_of(edges({Vec3{-1, 0, 0}, x, Vec3{0, -1, 1}, Vec3{0, 1, 1}},
                      {Vec3{-1, 0, 0}, x, Vec3{0, -1, -1}, Vec3{0, 1, -1}})) == "crossing, a against b");
  CHECK(text_of(edges({o, x, o, x}, {o, x, o, x})) == "sustained, overlap, V = n = r x u = r x w = 0 at all times");
  CHECK(text_of(edges({o, x, y, Vec3{1, 1, 0}}, {o, x, y, Vec3{1, 1, 0}})) == "no contact, V = n = 0 at all times");
  CHECK(text_of(edges({o, o, z, x}, {o, o, z, x})) == "no contact, V = n = r x u = u = 0 at all times");
  CHECK(text_of(VertexFace{{z, o, x, y}, {Vec3{0, 0, -1}, o, x, y}}) == "crossing, v against f0");
  CHECK(text_of(VertexFace{{z, o, x, x}, {z, o, x, x}}) == "no contact, V = n = f2 - f1 = 0 at all times");
  CHECK(text_of(PointEdge{{o, o, x}, {o, o, x}}) ==
        "sustained, p against e0, (p - e0) x (e1 - e0) = p - e0 = 0 at all times");
  CHECK(text_of(PointPoint{{o, x}, {o, x}}) == "no contact");
  CHECK(text_of(PointPoint{{o, o}, {x, x}}) == "sustained, p against q, q - p = 0 at all times");
}

TEST_CASE("V vanishes at all times exactly where the nature says so") {
  std::size_t vanishing = 0;
  for (const FamilyInfo& family : all_families()) {
    for (const Kind kind : {Kind::edge_edge, Kind::vertex_face}) {
      for (std::uint64_t index = 0; index < 50; ++index) {
        const Query query = make(CaseId{family.family, kind, 8, index});
        const Answer truth = solve(query);
        if (!truth.contact) continue;
        const bool of_cubic = truth.nature == Nature::crossing || truth.nature == Nature::grazing;
        const bool v_vanishes = (fuzz::degeneracy_of(query, truth).vanishing & 1) != 0;
        CHECK(v_vanishes != of_cubic);
        vanishing += v_vanishes;
      }
    }
  }
  CHECK(vanishing > 100);
}
