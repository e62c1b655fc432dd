// Method::fast_cgal against Method::fast, in every part of the answer.
// SPDX-License-Identifier: MIT
#include <array>
#include <cstdio>

#include <touchstone/solve.hpp>

#include "support/answer_check.hpp"
#include "support/report.hpp"

namespace touchstone::tests {
namespace {

constexpr std::uint64_t kSeed = 6;

// Empty when both methods agree. The same filters run first; below them the level tells whose arithmetic decided.
std::string disagreement(const Query& query, double t_max, const Answer& with_cgal) {
  const Answer fast = solve(query, {.t_max = t_max, .method = Method::fast});
  if (with_cgal.level == Level::exact) return "Method::fast_cgal answers by Level::exact";
  std::string found;
  if (fast.level == Level::filter || with_cgal.level == Level::filter) {
    found = bit_difference(fast, with_cgal, true);  // level included
  } else {
    found = decision_difference(fast, with_cgal);
    if (found.empty()) found = weight_difference(fast, with_cgal);
    const Level expected = fast.level == Level::exact ? Level::oracle : fast.level;
    if (found.empty() && with_cgal.level != expected) found = "another level than of Method::fast";
  }
  if (found.empty()) found = malformation(query.kind, with_cgal, t_max);
  if (found.empty()) return found;
  return found + " with t_max = " + hexfloat(t_max) + "\n    fast      " + describe(fast) + "\n    fast_cgal " +
         describe(with_cgal);
}

void check_kind(Kind kind) {
  Report report;
  LevelCounts counts;
  for_each_case(
      kSeed, 300, [kind](const FamilyInfo&, Kind k) { return k == kind; },
      [&](const CaseId& id) {
        const Query query = make(id);
        const Answer answer = solve(query, {.method = Method::fast_cgal});
        counts.filter += answer.level == Level::filter;
        counts.bracket += answer.level == Level::bracket;
        counts.oracle += answer.level == Level::oracle;
        report.add(id, query, disagreement(query, 1, answer));
        // Up to the exact time, and up to the double before it.
        for (const double t_max : {answer.toi_upper, answer.toi}) {
          if (answer.contact)
            report.add(id, query,
                       disagreement(query, t_max, solve(query, {.t_max = t_max, .method = Method::fast_cgal})));
        }
      });
  std::printf("seed %llu, %s: %zu comparisons; filter %zu, bracket %zu, CGAL %zu\n",
              static_cast<unsigned long long>(kSeed), name_of(kind).data(), report.checked(), counts.filter,
              counts.bracket, counts.oracle);
  if (!chosen_case()) {
    CHECK(counts.filter > 0);
    CHECK(counts.oracle > 100);
    if (kind == Kind::edge_edge || kind == Kind::vertex_face) CHECK(counts.bracket > 100);
  }
  report.finish();
}

TEST_CASE("methods agree: fast_cgal and fast, edge-edge") { check_kind(Kind::edge_edge); }
TEST_CASE("methods agree: fast_cgal and fast, vertex-face") { check_kind(Kind::vertex_face); }
TEST_CASE("methods agree: fast_cgal and fast, point-edge") { check_kind(Kind::point_edge); }
TEST_CASE("methods agree: fast_cgal and fast, point-point") { check_kind(Kind::point_point); }

}  // namespace
}  // namespace touchstone::tests
