// Queries that an inexact method answers wrongly, with the right answers.
// SPDX-License-Identifier: MIT
#include <optional>
#include <string>
#include <vector>

#include <touchstone/certify.hpp>
#include <touchstone/solve.hpp>

#include "baselines/baseline.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/query_text.hpp"

// This is why the library exists. A method that gets one of them right after a change has to find its way out of here.
namespace touchstone::tests {
namespace {

struct Failure {
  std::string name;
  Query query;
  Verdict verdict;
  double toi;  ///< the right one, to a few digits; negative where there is no contact
};

void check_failures(const std::string& method_name, const std::vector<Failure>& failures) {
  const baselines::Baseline* method = baselines::find_method(method_name);
  REQUIRE(method != nullptr);
  for (const Failure& failure : failures) {
    const Answer truth = solve(failure.query);
    const baselines::Result result = method->solve(failure.query, 1.0, method->usual_tolerance);
    INFO(method_name << ", " << failure.name << ": said " << hexfloat(result.toi) << ", " << describe(truth));
    // The right answer, by three methods that share little code.
    CHECK(truth.contact == (failure.toi >= 0));
    if (truth.contact) CHECK(truth.toi == Approx(failure.toi));
    CHECK(solve(failure.query, {.method = Method::exact}).toi == truth.toi);
    CHECK(solve(failure.query, {.method = Method::oracle}).toi == truth.toi);
    // The method's own answer.
    const std::optional<double> toi = result.contact ? std::optional<double>(result.toi) : std::nullopt;
    CHECK(name_of(judge({result.contact, toi}, truth)) == name_of(failure.verdict));
  }
}

// A vertex that falls through the corner region of a resting face, at (x, 1/4), from z = 1 to z = end.
Query fall(double x, double end) {
  const Vec3 f0{0, 0, 0}, f1{1, 0, 0}, f2{0, 1, 0};
  return VertexFace{{Vec3{x, 0.25, 1}, f0, f1, f2}, {Vec3{x, 0.25, end}, f0, f1, f2}};
}

TEST_CASE("the paper's method fails on ordinary queries") {
  const std::vector<Failure> failures{
      // V = 9 t^3 - 18 t^2 + 11 t - 2 = 9 (t - 1/3) (t - 2/3) (t - 1), and at t = 2/3 the edges meet in their
      // interiors. The root comes out an ulp off, and there n_x, which is exactly 0 at 2/3, is 1.5e-16: "the
      // equations that don't include any zero's in the denominator" give 0 and 2 for weights that are 3/16 and 7/8.
      {"interiors of two edges on a lattice of 27 points",
       EdgeEdge{{{{-1, 1, -1}, {1, -1, 1}, {0, -1, -1}, {-1, 0, -1}}},
                {{{1, 1, 0}, {-1, -1, -1}, {-1, 1, 0}, {1, 1, 0}}}},
       Verdict::missed, 2.0 / 3},
      // The midpoints of two edges at mid-step, where n_x = 0 again.
      {"midpoint to midpoint",
       EdgeEdge{{{{-1, -1, 2}, {-2, 0, 1}, {2, -2, -2}, {-2, 2, 1}}},
                {{{1, -1, -2}, {1, 1, 0}, {0, 0, 2}, {-1, -1, 0}}}},
       Verdict::missed, 0.5},
      // The vertex meets the face's inside, at (1/2, 1/4, 1/4), at mid-step, and once more n_x = 0.
      {"a vertex through the inside of a face",
       VertexFace{{{{0, 2, 1}, {1, -1, 0}, {-2, -2, -2}, {2, -1, 1}}},
                  {{{1, -2, -1}, {1, 2, 2}, {0, 0, -2}, {0, 1, -1}}}},
       Verdict::missed, 0.5},
      // a1 and b0 are one point at t = 0. V has the root 0 exactly; Cardano's formulas make it 1e-14, enough to put
      // the weights outside [0, 1].
      {"touching at the start",
       EdgeEdge{{{{-3, 4, -3}, {1, 4, -3}, {1, 4, -3}, {3, -3, 3}}}, {{{1, -4, 2}, {2, 1, 1}, {2, 1, -3}, {4, 3, 3}}}},
       Verdict::missed, 0},
      // All in the plane z = 0, so V vanishes identically and has no roots to try: b falls on a resting edge.
      {"planar motion",
       EdgeEdge{{{{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 2, 0}}}, {{{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 0, 0}}}},
       Verdict::missed, 0.5},
      // Parallel edges that fall on one another: V vanishes identically, though nothing is in a plane that rests.
      {"parallel edges",
       EdgeEdge{{{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0, 1}}}, {{{0, 0, 0}, {1, 0, 0}, {0, 0, -3}, {1, 0, -3}}}},
       Verdict::missed, 0.25},
      // The cubic's coefficients are of the order of 1e-330, zero in doubles.
      {"small coordinates",
       VertexFace{{{{0.25e-110, 0.25e-110, 1e-110}, {0, 0, 0}, {1e-110, 0, 0}, {0, 1e-110, 0}}},
                  {{{0.25e-110, 0.25e-110, -1e-110}, {0, 0, 0}, {1e-110, 0, 0}, {0, 1e-110, 0}}}},
       Verdict::missed, 0.5},
      // At V's root near 0.4017 the weights are 1.6 and 1.7: no contact. But n_x is zero there except for
      // rounding. The paper's weights are quotients of rounding noise, 0 and 0.
      {"a phantom",
       EdgeEdge{{{{1, -2, -3}, {3, 4, -2}, {0, -2, -3}, {1, 3, -4}}},
                {{{3, -4, 0}, {3, -1, -2}, {0, -4, 0}, {4, 0, 1}}}},
       Verdict::phantom, -1},
  };
  check_failures("paper", failures);
}

TEST_CASE("the closed form with every care that doubles allow still fails") {
  const std::vector<Failure> failures{
      // All corners stay within 2^-44 of one plane. V's coefficients are about 1e-11 and are differences
      // of numbers near 1000, so they are as small as their rounding. V's computed root is not the time
      // at which the edges' interiors meet.
      {"two edges, coplanar but for 2^-44",
       EdgeEdge{{{{4, 7, -5}, {4, 9, 1}, {-8, -5, -5}, {7, 7 + 0x1p-44, -14}}},
                {{{-2, 1, -5}, {4 + 0x1p-44, 3, -17}, {7, 10 - 0x1p-44, -5 + 0x1p-44}, {-2, 2, -2}}}},
       Verdict::missed, 0.5867},
      // The vertex meets the corner f0 at t = 1/3. The face is so nearly flat then, u x w is of 1e-7,
      // that the vertex's weights are good to half the digits only.
      {"vertex to corner, coplanar but for 2^-21",
       VertexFace{{{{-1, 2, 0}, {0, 3, -2}, {3, 6 + 0x1p-21, -8}, {4 - 0x1p-21, 7, -10}}},
                  {{{1, 0, -3}, {-1, -2, 1}, {-5, -6 - 0x1p-21, 9}, {-6, -7, 11 - 0x1p-21}}}},
       Verdict::missed, 1.0 / 3},
      // The exact time is 1/5; the nearest double lies after it.
      {"a time that is rounded up", fall(0.25, -4), Verdict::late, 0.2},
      // Beside the face by 1e-13, a tenth of the slack.
      {"a near miss", fall(-1e-13, -1), Verdict::phantom, -1},
  };
  check_failures("closed_form", failures);
}

TEST_CASE("Newton to a tolerance fails within it, and beyond") {
  const std::vector<Failure> failures{
      // The vertex meets the corner f0 at mid-step. At t = 1/2 - d the weight of f1 is -16 d,
      // and d is anything up to a quarter of the tolerance.
      {"vertex to corner on a lattice of 27 points",
       VertexFace{{{{-1, -1, 1}, {0, 0, -1}, {-1, -1, 0}, {1, -1, -1}}},
                  {{{0, 0, -1}, {-1, -1, 1}, {1, 0, 0}, {1, -1, 1}}}},
       Verdict::missed, 0.5},
      // A hair of length 1e-10 crosses a resting edge at t = 0.3, along its own direction too: its time is found a
      // little early, when it is not there yet.
      {"a short fast edge",
       EdgeEdge{{{{0.3, -0.3 - 5e-11, -0.3}, {0.3, -0.3 + 5e-11, -0.3}, {0, 0, 0}, {1, 0, 0}}},
                {{{0.3, 0.7 - 5e-11, 0.7}, {0.3, 0.7 + 5e-11, 0.7}, {0, 0, 0}, {1, 0, 0}}}},
       Verdict::missed, 0.3},
      {"a near miss", fall(-1e-7, -1), Verdict::phantom, -1},
  };
  check_failures("newton", failures);
}

// Two points that pass one another at a distance of 7e-8 while t is below 2e-7.
const Query kMissAtStart = PointPoint{{{{0, 0, 0}, {1e-7, 2e-7, 0}}}, {{{0, 0, 0}, {1e-7 - 1, 2e-7 - 1, 0}}}};

// That of a published conservative solver, as start and displacement; a plane separates v from the face all along.
Query published_false_alarm() {
  const Vec3 v{0.35, 0, 0.35};
  const Vec3 f0{0.34604643638, 0.0027847887896, 0.3465812116};
  const Vec3 f1{0.35000819263, -1.5763377304e-06, 0.35001214242};
  const Vec3 f2{0.34903882032, -0.0015866575093, 0.34560164356};
  return VertexFace{{v, f0, f1, f2},
                    {v, f0 + Vec3{1.01203007890e-07, -1.4009994248e-04, -8.5653091896e-05},
                     f1 + Vec3{-9.2976239634e-07, 1.4361165221e-06, 5.5168830145e-07},
                     f2 + Vec3{1.1649271683e-04, -3.6172565398e-05, -4.7128237917e-05}}};
}

TEST_CASE("the conservative interval method invents contacts") {
  const std::vector<Failure> failures{
      // One point passes the other by 1.4e-7 at mid-step.
      {"a near miss", PointPoint{{{{0, 0, 0}, {1, 1 + 2e-7, 0}}}, {{{0, 0, 0}, {-1, -1 + 2e-7, 0}}}}, Verdict::phantom,
       -1},
      // A vertex passes a face that is seen at a slant, 1e-7 beside its edge f0 f1.
      {"a near miss of a slanted face",
       VertexFace{{{{0.5, 0.5 + 1e-7, 1}, {0, 0, 0}, {1, 1, 0}, {1, 0, 0}}},
                  {{{0.5, 0.5 + 1e-7, -1}, {0, 0, 0}, {1, 1, 0}, {1, 0, 0}}}},
       Verdict::phantom, -1},
      {"a near miss at the start", kMissAtStart, Verdict::phantom, -1},
      {"the published false alarm", published_false_alarm(), Verdict::phantom, -1},
  };
  check_failures("interval", failures);
  // "Hit at t = 0": a simulation that steps to the time of impact never gets on.
  CHECK(baselines::solve_interval(kMissAtStart, 1.0, 1e-6).toi == 0);
}

TEST_CASE("conservative advancement invents contacts, and steps over them") {
  const std::vector<Failure> failures{
      {"a near miss", fall(-1e-7, -1), Verdict::phantom, -1},
      // e1 reaches the resting point p at t = 1 exactly. The last step of distance / speed ends just after 1.
      {"touching at the end",
       PointEdge{{{{3, 1, -3}, {-1, -4, 2}, {0, 2, -4}}}, {{{3, 1, -3}, {-1, -2, 2}, {3, 1, -3}}}}, Verdict::missed, 1},
      // In coordinates of 1e11 rounding keeps the distance above 1e-6 at the contact itself, and small steps go on
      // through.
      {"the unit of length is a nanometre",
       VertexFace{{{{0, 0, -1e11}, {1e11, 1e11, 1e11}, {0, -1e11, 0}, {1e11, -1e11, -1e11}}},
                  {{{1e11, -1e11, 1e11}, {-1e11, 1e11, 0}, {1e11, 0, -1e11}, {0, -1e11, 0}}}},
       Verdict::missed, 0.3819662},
  };
  check_failures("conservative_advancement", failures);
}

}  // namespace
}  // namespace touchstone::tests
