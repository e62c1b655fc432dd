// The text of theorems for Coq. tests/proved has coqc check them.
// SPDX-License-Identifier: MIT
#include "proofs/theorem.hpp"

#include <string>

#include <touchstone/curved.hpp>
#include <touchstone/error.hpp>
#include <touchstone/solve.hpp>

#include "support/catch.hpp"

using namespace touchstone;

namespace {

template <class Q>
std::string theorem(const Q& query, const Separation& separation = {}, const std::string& origin = "a test") {
  return proofs::theorem_of({"query_7", origin}, query, solve(query, {.separation = separation}), separation);
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A vertex that falls through a face from z = 1 to `end`.
VertexFace falling(double end) {
  return {{{{0.25, 0.25, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {{{0.25, 0.25, end}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}};
}

}  // namespace

TEST_CASE("a theorem ends with the corners and the statement, in the words of Statement.v and of a person") {
  const std::string text = theorem(Query(falling(-1)));
  const std::string end = R"((* The corner v moves straight on
   from (0.25, 0.25, 1) at the time 0
   to (0.25, 0.25, -1) at the time 1. *)
Definition corner_v : corner := On_curve
  [Rational (1 # 4) (1 # 4) 1;
   Rational (1 # 4) (1 # 4) (-1)].
(* The corner f0 stays at (0, 0, 0). *)
Definition corner_f0 : corner := On_curve
  [Rational 0 0 0;
   Rational 0 0 0].
(* The corner f1 stays at (1, 0, 0). *)
Definition corner_f1 : corner := On_curve
  [Rational 1 0 0;
   Rational 1 0 0].
(* The corner f2 stays at (0, 1, 0). *)
Definition corner_f2 : corner := On_curve
  [Rational 0 1 0;
   Rational 0 1 0].

(* The point v and the face f0 f1 f2 touch
   at the time 0.5,
   and at no time before it, from 0 on. *)
Theorem query_7 : holds
  {| first := [corner_v];
     second := [corner_f0; corner_f1; corner_f2];
     apart := Zero |}
  (Contact_at (1 # 2)).
Proof. apply check_sound with certificate. vm_cast_no_check (eq_refl true). Qed.
Print Assumptions query_7.
)";
  CAPTURE(text);
  REQUIRE(text.size() > end.size());
  CHECK(text.substr(text.size() - end.size()) == end);
  CHECK(text.rfind("(* a test\n", 0) == 0);
  CHECK(has(text, "  coordinate_unit := fold_right Z.lcm 1 [4];\n  turn_unit := 1;\n"));
  CHECK(has(text, "  mantissa := 0x1 * 2^52; places := 53;\n"));
}

TEST_CASE("the answers of a theorem, and its separation") {
  CHECK(has(theorem(Query(falling(0.5))), "touch\n   at no time from 0 to 1. *)"));
  CHECK(has(theorem(Query(falling(0.5))), "apart := Zero |}\n  No_contact.\n"));
  CHECK(has(theorem(Query(falling(0.5))), "mantissa := 0; places := 1074;\n"));
  CHECK(
      has(theorem(Query(falling(-2))), "\n  (Contact_between (6004799503160661 # 2^54) (3002399751580331 # 2^53)).\n"));
  CHECK(has(theorem(Query(falling(-2))),
            "touch\n   at a time between 0.3333333333333333 and 0.33333333333333337, which are neighbouring doubles,\n"
            "   and at no time from 0 to the first of them. *)"));
  const std::string near = theorem(Query(falling(0)), {0.5, Metric::euclidean});
  CHECK(has(near, "are at most 0.5 apart\n   at the time 0.5,"));
  CHECK(has(near, "apart := Euclidean (1 # 2) |}"));
  const std::string box = theorem(Query(falling(0)), {0.1, Metric::max});
  CHECK(has(box, "are at most 0.1 apart (by the greatest difference of coordinates)\n"));
  CHECK(has(box, "apart := Max (3602879701896397 # 2^55) |}"));
}

TEST_CASE("coordinates of a theorem are exact at every size, and fractions are as given") {
  const Query sizes(
      PointPoint{{{{0.1, -0.0, -0x1p-1074}, {0x1.8p+200, 0x1p+90, -1.5}}}, {{{512.001953125, 1, 2}, {3, 4, 5}}}});
  const std::string text = theorem(sizes);
  CAPTURE(text);
  CHECK(has(text, "Rational (3602879701896397 # 2^55) 0 (-1 # 2^1074)"));
  CHECK(has(text, "Rational (3 * 2^199 # 1) (2^90 # 1) (-3 # 2)"));
  CHECK(has(text, "Rational (262145 # 512) 1 2"));
  CHECK(has(text, "(0.1, 0, -5e-324)"));
  RationalQuery fractions;
  fractions.kind = Kind::point_point;
  for (auto* end : {&fractions.start, &fractions.end}) {
    (*end)[0] = {{{"1", "3"}, {"-4", "6"}, {"0", "7"}}};
    (*end)[1] = {{{"-12345678901234567890123", "1"}, {"6", "10"}, {"05", "1"}}};
  }
  const std::string given = theorem(fractions);
  CAPTURE(given);
  CHECK(has(given, "Rational (1 # 3) (-4 # 6) 0;"));
  CHECK(has(given, "Rational (-12345678901234567890123) (6 # 10) 05;"));
  CHECK(has(given, "(0.3333333333333333, -0.6666666666666666, 0)"));
  CHECK(has(given, "coordinate_unit := fold_right Z.lcm 1 [10; 3; 6];"));
}

TEST_CASE("a theorem about curved motion has the motions and the curves of its corners") {
  CurvedQuery query;
  query.kind = Kind::point_edge;
  query.motions[2] = {{1, 0, 0, 0}, {0.5, 0, 0, 0.5}, {0, 0, 0}, {0, 0, 4}};
  query.corners[0] = CurvedCorner::on_curve({{0, 0, 9}, {1, 0, 9}, {0, 2, 9}});
  query.corners[1] = CurvedCorner::on_body(2, {1, 0, 0.125});
  query.corners[2] = CurvedCorner::on_body(2, {2, 0, 0});
  const std::string text = theorem(query);
  CAPTURE(text);
  CHECK(has(text,
            "(* The corner p moves on the Bezier curve with the control points\n   (0, 0, 9)\n   (1, 0, 9)\n   (0, 2, "
            "9). *)\n"
            "Definition corner_p : corner := On_curve\n  [Rational 0 0 9;\n   Rational 1 0 9;\n   Rational 0 2 9].\n"));
  CHECK(has(text,
            "Definition motion_2 : motion := {|\n"
            "  s_0 := 1; v_0 := Rational 0 0 0;\n  s_1 := (1 # 2); v_1 := Rational 0 0 (1 # 2);\n"
            "  p_0 := Rational 0 0 0;\n  p_1 := Rational 0 0 4 |}.\n"));
  CHECK(has(text, "Definition corner_e0 : corner := On_body 2 motion_2\n  (Rational 1 0 (1 # 8)).\n"));
  CHECK(text.find("Definition motion_2") == text.rfind("Definition motion_2"));
  CHECK(has(text, "coordinate_unit := fold_right Z.lcm 1 [8];\n  turn_unit := fold_right Z.lcm 1 [2];\n"));
}

TEST_CASE("no text of the query's origin ends the comment that it stands in") {
  const std::string text = theorem(Query(falling(-1)), {}, "a \"b *) Axiom x : False. (* c\nd");
  CHECK(text.rfind("(* a \\x22b \\x2a) Axiom x : False. (\\x2a c d\n", 0) == 0);
}

TEST_CASE("an answer without a proof is no theorem") {
  Answer answer = solve(Query(falling(-1)));
  answer.toi = answer.toi_upper = 0.25;
  CHECK_THROWS_AS(proofs::theorem_of({"query_7", ""}, Query(falling(-1)), answer), Error);
}
