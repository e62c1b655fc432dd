// Each inexact method on queries that it gets wrong, and what is right. This is why the library exists; a method that gets
// one of them right after a change to it has to find its way out of this file.
// SPDX-License-Identifier: MIT
#include <optional>
#include <string>
#include <vector>

#include <touchstone/certify.hpp>
#include <touchstone/solve.hpp>

#include "baselines/baseline.hpp"
#include "support/catch.hpp"
#include "support/query_text.hpp"

namespace touchstone::tests {
namespace {

struct Failure {
  std::string name;
  Query query;
  Verdict verdict;
  double toi;  ///< the right one, to a few digits; negative where there is no contact
};

void check_failures(const std::string& method_name, const std::vector<Failure>& failures) {
  const baselines::Method* method = baselines::find_method(method_name);
  REQUIRE(method != nullptr);
  for (const Failure& failure : failures) {
    const Answer truth = solve(failure.query);
    const baselines::Result result = method->solve(failure.query, 1.0, method->usual_tolerance);
    INFO(method_name << ", " << failure.name << ": said " << hexfloat(result.toi) << ", " << describe(truth));
    // What is right, by three methods that share little code.
    CHECK(truth.contact == (failure.toi >= 0));
    if (truth.contact) CHECK(truth.toi == Approx(failure.toi));
    CHECK(solve(failure.query, Method::exact).toi == truth.toi);
    CHECK(solve(failure.query, Method::oracle).toi == truth.toi);
    // And what the method says of it.
    const std::optional<double> toi = result.contact ? std::optional<double>(result.toi) : std::nullopt;
    CHECK(verdict_name(judge({result.contact, toi}, truth)) == verdict_name(failure.verdict));
  }
}

// A vertex that falls through the corner region of a resting face, at (x, 1/4), from z = 1 to z = end.
Query fall(double x, double end) {
  const Vec3 f0{0, 0, 0}, f1{1, 0, 0}, f2{0, 1, 0};
  return VertexFace{{Vec3{x, 0.25, 1}, f0, f1, f2}, {Vec3{x, 0.25, end}, f0, f1, f2}};
}

TEST_CASE("the paper's method fails on ordinary queries") {
  check_failures(
      "paper",
      {
          // V = 9 t^3 - 18 t^2 + 11 t - 2 = 9 (t - 1/3) (t - 2/3) (t - 1), and at t = 2/3 the edges meet in their interiors. The
          // root comes out one ulp off, and there n_x, which is exactly 0 at 2/3, is rounding noise: "the equations that do
          // not include any zeros in the denominator" are solved by 0 / 0 in disguise.
          {"interiors of two edges on a lattice of 27 points",
           EdgeEdge{{{{-1, 1, -1}, {1, -1, 1}, {0, -1, -1}, {-1, 0, -1}}},
                    {{{1, 1, 0}, {-1, -1, -1}, {-1, 1, 0}, {1, 1, 0}}}},
           Verdict::missed, 2.0 / 3},
          // The midpoints of two edges at mid-step.
          {"midpoint to midpoint",
           EdgeEdge{{{{-1, -1, 2}, {-2, 0, 1}, {2, -2, -2}, {-2, 2, 1}}},
                    {{{1, -1, -2}, {1, 1, 0}, {0, 0, 2}, {-1, -1, 0}}}},
           Verdict::missed, 0.5},
          // The vertex meets the face's inside, at (1/2, 1/4, 1/4), at mid-step.
          {"a vertex through the inside of a face",
           VertexFace{{{{0, 2, 1}, {1, -1, 0}, {-2, -2, -2}, {2, -1, 1}}},
                      {{{1, -2, -1}, {1, 2, 2}, {0, 0, -2}, {0, 1, -1}}}},
           Verdict::missed, 0.5},
          // a1 and b0 are one point at t = 0. V has the root 0 exactly; Cardano's formulas put it just before 0.
          {"touching at the start",
           EdgeEdge{{{{-3, 4, -3}, {1, 4, -3}, {1, 4, -3}, {3, -3, 3}}},
                    {{{1, -4, 2}, {2, 1, 1}, {2, 1, -3}, {4, 3, 3}}}},
           Verdict::missed, 0},
          // All in the plane z = 0, so V vanishes identically and has no roots to try: b falls on a resting edge.
          {"planar motion",
           EdgeEdge{{{{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 2, 0}}}, {{{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 0, 0}}}},
           Verdict::missed, 0.5},
          // Parallel edges that fall on one another: V vanishes identically, though nothing is in a plane that rests.
          {"parallel edges",
           EdgeEdge{{{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0, 1}}}, {{{0, 0, 0}, {1, 0, 0}, {0, 0, -3}, {1, 0, -3}}}},
           Verdict::missed, 0.25},
          // The same shift by one for all corners; the cubic's coefficients are of the order of 1e-330, zero in doubles.
          {"small coordinates",
           VertexFace{{{{0.25e-110, 0.25e-110, 1e-110}, {0, 0, 0}, {1e-110, 0, 0}, {0, 1e-110, 0}}},
                      {{{0.25e-110, 0.25e-110, -1e-110}, {0, 0, 0}, {1e-110, 0, 0}, {0, 1e-110, 0}}}},
           Verdict::missed, 0.5},
          // No contact: at V's root near 0.4017 one denominator is zero but for rounding, and the quotients happen to fall
          // between 0 and 1.
          {"a phantom",
           EdgeEdge{{{{1, -2, -3}, {3, 4, -2}, {0, -2, -3}, {1, 3, -4}}},
                    {{{3, -4, 0}, {3, -1, -2}, {0, -4, 0}, {4, 0, 1}}}},
           Verdict::phantom, -1},
      });
}

TEST_CASE("the closed form with every care that doubles allow still fails") {
  check_failures(
      "closed_form",
      {
          // All corners would be in one plane all the time but for 2^-44. V's coefficients, 10^-11, are differences of numbers
          // near 1000, so nearly all of their digits are noise, and where the edges' interiors meet, at t = 0.5867, V's
          // computed root is not.
          {"two edges, coplanar but for 2^-44",
           EdgeEdge{{{{4, 7, -5}, {4, 9, 1}, {-8, -5, -5}, {7, 7 + 0x1p-44, -14}}},
                    {{{-2, 1, -5}, {4 + 0x1p-44, 3, -17}, {7, 10 - 0x1p-44, -5 + 0x1p-44}, {-2, 2, -2}}}},
           Verdict::missed, 0.5867},
          // The vertex meets the corner f0 at t = 1/3, in a motion that is coplanar but for 2^-21: the root loses half its
          // digits, and the weights with it.
          {"vertex to corner, coplanar but for 2^-21",
           VertexFace{{{{-1, 2, 0}, {0, 3, -2}, {3, 6 + 0x1p-21, -8}, {4 - 0x1p-21, 7, -10}}},
                      {{{1, 0, -3}, {-1, -2, 1}, {-5, -6 - 0x1p-21, 9}, {-6, -7, 11 - 0x1p-21}}}},
           Verdict::missed, 1.0 / 3},
          // The exact time is 1/5; the nearest double lies after it.
          {"a time that is rounded up", fall(0.25, -4), Verdict::late, 0.2},
          // Beside the face by 1e-13, a tenth of the slack.
          {"a near miss", fall(-1e-13, -1), Verdict::phantom, -1},
      });
}

TEST_CASE("Newton to a tolerance fails within it, and beyond") {
  check_failures(
      "newton",
      {
          // The vertex meets the corner f0 at mid-step. At t = 1/2 - d the weight of f1 is -16 d, and d is anything up to a
          // quarter of the tolerance.
          {"vertex to corner on a lattice of 27 points",
           VertexFace{{{{-1, -1, 1}, {0, 0, -1}, {-1, -1, 0}, {1, -1, -1}}},
                      {{{0, 0, -1}, {-1, -1, 1}, {1, 0, 0}, {1, -1, 1}}}},
           Verdict::missed, 0.5},
          // A hair of length 1e-8 crosses a resting edge at t = 0.3, along its own direction too: in a quarter of 1e-6 it is
          // past.
          {"a short fast edge",
           EdgeEdge{{{{0.3, -0.3, -0.3}, {0.3, 1e-8 - 0.3, -0.3}, {0, 0, 0}, {1, 0, 0}}},
                    {{{0.3, 0.7, 0.7}, {0.3, 0.7 + 1e-8, 0.7}, {0, 0, 0}, {1, 0, 0}}}},
           Verdict::missed, 0.3},
          {"a near miss", fall(-1e-7, -1), Verdict::phantom, -1},
      });
}

TEST_CASE("the conservative interval method invents contacts") {
  check_failures("interval",
                 {
                     // One point passes the other by 1.4e-7 at mid-step.
                     {"a near miss",
                      PointPoint{{{{0, 0, 0}, {1, 1 + 2e-7, 0}}}, {{{0, 0, 0}, {-1, -1 + 2e-7, 0}}}}, Verdict::phantom, -1},
                     // The same so soon after the start that it says "hit at t = 0": who steps to there never gets on.
                     {"a near miss at the start",
                      PointPoint{{{{0, 0, 0}, {1e-7, 2e-7, 0}}}, {{{0, 0, 0}, {1e-7 - 1, 2e-7 - 1, 0}}}},
                      Verdict::phantom, -1},
                     // A vertex passes a face that is seen at a slant, 1e-7 beside its edge f0 f1.
                     {"a near miss of a slanted face",
                      VertexFace{{{{0.5, 0.5 + 1e-7, 1}, {0, 0, 0}, {1, 1, 0}, {1, 0, 0}}},
                                 {{{0.5, 0.5 + 1e-7, -1}, {0, 0, 0}, {1, 1, 0}, {1, 0, 0}}}},
                      Verdict::phantom, -1},
                 });
}

TEST_CASE("conservative advancement invents contacts, and steps over them") {
  check_failures(
      "conservative_advancement",
      {
          {"a near miss", fall(-1e-7, -1), Verdict::phantom, -1},
          // e1 comes to the resting point p at t = 1 exactly; the last step of distance / speed ends just after 1.
          {"touching at the end",
           PointEdge{{{{3, 1, -3}, {-1, -4, 2}, {0, 2, -4}}}, {{{3, 1, -3}, {-1, -2, 2}, {3, 1, -3}}}},
           Verdict::missed, 1},
          // In coordinates of 1e11 rounding keeps the distance above 1e-6 at the contact itself, and each step adds its own
          // error to t: it walks through.
          {"the unit of length is a nanometre",
           VertexFace{{{{0, 0, -1e11}, {1e11, 1e11, 1e11}, {0, -1e11, 0}, {1e11, -1e11, -1e11}}},
                      {{{1e11, -1e11, 1e11}, {-1e11, 1e11, 0}, {1e11, 0, -1e11}, {0, -1e11, 0}}}},
           Verdict::missed, 0.3819662},
      });
}

}  // namespace
}  // namespace touchstone::tests
