// The roots that the bracket level certifies on the way to its answer, against exact arithmetic.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "exact/exact.hpp"
#include "filters/apart/separating_direction.hpp"
#include "filters/bernstein_cubic.hpp"
#include "filters/bracket.hpp"
#include "filters/step_frame.hpp"
#include "numbers/integers/exact_number.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/report.hpp"

using namespace touchstone;
using namespace touchstone::tests;
using filters::BernsteinCubic;
using filters::Outcome;
using numbers::Exact;

namespace {

/// A frame given by 18 doubles (differences that are doubles themselves), and V's exact power coefficients, from the
/// rule of Sarrus over polynomials.
struct FrameSample {
  filters::StepFrame<double> frame;
  double size;
  std::array<Exact, 4> power;

  explicit FrameSample(const std::vector<double>& x) {
    const auto vector = [&](std::size_t i) { return filters::Vector{{x[3 * i], x[3 * i + 1], x[3 * i + 2]}}; };
    frame = {{vector(0), vector(1), vector(2)}, {vector(3), vector(4), vector(5)}};
    const auto largest = [&](std::size_t i) {
      double m = 0;
      for (std::size_t k = 0; k < 3; ++k) m = std::max({m, std::fabs(x[3 * i + k]), std::fabs(x[9 + 3 * i + k])});
      return m;
    };
    size = largest(0) * largest(1) * largest(2);
    static constexpr int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}, {0, 2, 1}, {1, 0, 2}};
    for (int o = 0; o < 6; ++o) {
      std::array<Exact, 4> term = {Exact(1), Exact(0), Exact(0), Exact(0)};
      for (std::size_t v = 0; v < 3; ++v) {
        const std::size_t at = 3 * v + static_cast<std::size_t>(orders[o][v]);
        const Exact start(x[at]);
        const Exact change = Exact(x[9 + at]) - start;
        for (std::size_t i = 4; i-- > 0;) term[i] = term[i] * start + (i > 0 ? term[i - 1] * change : Exact(0));
      }
      for (std::size_t i = 0; i < 4; ++i) power[i] = o < 3 ? power[i] + term[i] : power[i] - term[i];
    }
  }

  BernsteinCubic cubic() const { return {filters::coplanarity_coefficients(frame), size}; }
  Exact value(const Exact& t) const { return ((power[3] * t + power[2]) * t + power[1]) * t + power[0]; }
  Exact slope(const Exact& t) const { return (Exact(3) * power[3] * t + Exact(2) * power[2]) * t + power[1]; }
};

Exact magnitude(const Exact& x) { return x.sign() < 0 ? -x : x; }

std::vector<double> random_frame(Rng& rng) {
  std::vector<double> x(18);
  const int spread = rng.between(0, 30);
  for (double& v : x) v = std::ldexp(rng.symmetric(), -rng.between(0, spread));
  if (rng.one_in(2)) {  // V's ends of opposite signs
    for (std::size_t k = 0; k < 3; ++k) x[15 + k] = -x[6 + k] * (1 + 0.25 * rng.symmetric());
  }
  if (rng.one_in(3)) {  // small integers: zeros and ties
    for (double& v : x) v = rng.between(-3, 3);
  }
  return x;
}

}  // namespace

TEST_CASE("a certified root is there, and its slope and curvature bounds hold") {
  Rng rng(61);
  long certain = 0, none = 0, split = 0;
  for (int i = 0; i < 60000; ++i) {
    const FrameSample sample(random_frame(rng));
    if (sample.size == 0) continue;
    const BernsteinCubic cubic = sample.cubic();
    // Over the step, or a little more of the line, where the same is promised.
    const double margin = rng.one_in(2) ? 0 : BernsteinCubic::kMargin;
    double points[4] = {-margin, 1 + margin};
    int segments = 1;
    if (cubic.variations(-margin, 1 + margin) == BernsteinCubic::Variations::uncertain) {
      segments = cubic.split_points(-margin, 1 + margin, points);
    }
    REQUIRE(points[0] == -margin);
    REQUIRE(points[segments] == 1 + margin);
    split += segments > 1;
    for (int s = 0; s < segments; ++s) {
      REQUIRE(points[s] < points[s + 1]);
      const BernsteinCubic::Variations variations = cubic.variations(points[s], points[s + 1]);
      if (variations == BernsteinCubic::Variations::uncertain) break;
      const int at_start = sample.value(Exact(points[s])).sign();
      const int at_end = sample.value(Exact(points[s + 1])).sign();
      REQUIRE(at_start != 0);
      if (variations == BernsteinCubic::Variations::none) {
        ++none;
        REQUIRE(at_start == at_end);
        for (int k = 1; k < 8; ++k) {
          REQUIRE(sample.value(Exact(points[s] + (points[s + 1] - points[s]) * k / 8)).sign() == at_start);
        }
        continue;
      }
      REQUIRE(at_start == -at_end);
      const BernsteinCubic::Root root = cubic.root_between(points[s], points[s + 1]);
      if (!root.certain) continue;
      ++certain;
      const Exact low = Exact(root.t) - Exact(root.radius);
      const Exact high = Exact(root.t) + Exact(root.radius);
      REQUIRE(root.radius <= BernsteinCubic::kGreatestRadius);
      REQUIRE(filters::exact_to_one(root.t) == root.t);
      REQUIRE(low > Exact(points[s]));
      REQUIRE(high < Exact(points[s + 1]));
      REQUIRE(sample.value(low).sign() == at_start);
      REQUIRE(sample.value(high).sign() == at_end);
      for (const Exact& t : {low, Exact(root.t), high}) {
        const Exact spread = Exact(cubic.slope_error()) + Exact(cubic.curvature()) * Exact(root.radius);
        REQUIRE(magnitude(sample.slope(t) - Exact(root.slope)) <= spread);
        REQUIRE(sample.slope(t).sign() == (root.slope > 0 ? 1 : -1));
        REQUIRE(Exact(2) * magnitude(sample.slope(t)) >= magnitude(Exact(root.slope)));
      }
    }
  }
  std::printf("bracket: %ld certified roots, %ld certified empty parts, %ld cubics split\n", certain, none, split);
  CHECK(certain > 5000);
  CHECK(none > 1000);
  CHECK(split > 1000);
}

TEST_CASE("a root just outside of the step is not taken for the one inside") {
  // n = (0, 0, a(t)) with a = t + e, and v at height 3/4 - t: V = (t + e) (3/4 - t); and the same with time reversed. A
  // step from the chord's zero, beside the end, is near the wrong root.
  int decided = 0;
  for (int k = 30; k <= 52; ++k) {
    const double beside = std::ldexp(1.0, -k);
    VertexFace face{{{{0x1p-6, 0.25, 0.75}, {0, 0, 0}, {beside, 0, 0}, {0, 1, 0}}},
                    {{{0x1p-6, 0.25, -0.25}, {0, 0, 0}, {1 + beside, 0, 0}, {0, 1, 0}}}};
    for (const bool reversed : {false, true}) {
      Query query(face);
      if (reversed) std::swap(query.start, query.end);
      CAPTURE(k, reversed);
      Answer answer;
      const Outcome finding = filters::decide_in_brackets({query, 1, exact::coplanarity_at}, answer).finding;
      CHECK(finding != Outcome::no_contact);
      if (finding != Outcome::contact) continue;
      ++decided;
      CHECK(answer.toi == (reversed ? 0.25 : 0.75));
      CHECK(answer.toi_upper == answer.toi);
    }
  }
  CHECK(decided > 10);
}

TEST_CASE("a root just outside of a part is not taken for the one inside") {
  // (t - a) (c - t) with a root beside 1/2, where parts meet, and one inside of the part.
  const auto cubic = [](double a, double c) {
    const double c0 = -a * c;
    const double c1 = a + c;
    return BernsteinCubic({c0, 3 * c0 + c1, 3 * c0 + 2 * c1 - 1, c0 + c1 - 1}, 1);
  };
  int certain = 0;
  for (int k = 20; k <= 46; ++k) {
    const double beside = std::ldexp(1.0, -k);
    for (const double inside : {0.625, 0.75, 0.875, 0.984375}) {
      CAPTURE(k, inside);
      const BernsteinCubic::Root after = cubic(0.5 - beside, inside).root_between(0.5, 1);
      const BernsteinCubic::Root before = cubic(1 - inside, 0.5 + beside).root_between(0, 0.5);
      if (after.certain) CHECK(std::fabs(after.t - inside) < 0x1p-30);
      if (before.certain) CHECK(std::fabs(before.t - (1 - inside)) < 0x1p-30);
      certain += after.certain + before.certain;
    }
  }
  CHECK(certain > 50);
}

TEST_CASE("no direction separates elements that are close at a root") {
  int asked = 0, close = 0;
  for_each_case(
      37, 300, [](const FamilyInfo&, Kind kind) { return filters::has_cubic(kind); },
      [&](const CaseId& id) {
        const Query query = make(id);
        Answer answer;
        ++asked;
        if (!filters::decide_in_brackets({query, 1, exact::coplanarity_at}, answer).close) return;
        ++close;
        INFO(case_name(id));
        CHECK_FALSE(filters::separated(query));
      });
  CHECK(close * 20 > asked);
}

TEST_CASE("contacts at, before and after the ends of the step, against exact arithmetic") {
  int decided = 0;
  int at_an_end = 0;
  for (const Family family : {Family::at_start, Family::at_end, Family::beside_ends, Family::extreme_time}) {
    for (const Kind kind : {Kind::edge_edge, Kind::vertex_face}) {
      for (std::uint64_t i = 0; i < 4000; ++i) {
        const CaseId id{family, kind, 31, i};
        const Query query = make(id);
        Answer answer;
        const Outcome finding = filters::decide_in_brackets({query, 1, exact::coplanarity_at}, answer).finding;
        if (finding == Outcome::uncertain) continue;
        INFO(case_name(id));
        const Answer truth = exact::decide_exactly(query, 1);
        REQUIRE((finding == Outcome::contact) == truth.contact);
        ++decided;
        if (!truth.contact) continue;
        REQUIRE(answer.toi == truth.toi);
        REQUIRE(answer.toi_upper == truth.toi_upper);
        at_an_end += truth.toi_upper == 0 || truth.toi == 1;
      }
    }
  }
  CHECK(decided > 5000);
  CHECK(at_an_end > 500);
}

TEST_CASE("V at a double, with its exact sign") {
  const Query query(
      EdgeEdge{{{{-1, 0, 0}, {1, 0, 0}, {0, -1, 1}, {0, 1, 1}}}, {{{-1, 0, 0}, {1, 0, 0}, {0, -1, -1}, {0, 1, -1}}}});
  CHECK(exact::coplanarity_at(query, 0.5) == 0);  // V = 4 - 8t
  CHECK(exact::coplanarity_at(query, std::nextafter(0.5, 0)) == 8 * 0x1p-54);
  CHECK(exact::coplanarity_at(query, std::nextafter(0.5, 1)) == -8 * 0x1p-53);
  // v falls from z = 1 to -1 through the face z = 0 with n = (0, 0, 16): V = 16 - 32 t.
  const Query face(
      VertexFace{{{{1, 1, 1}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{{1, 1, -1}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}});
  CHECK(exact::coplanarity_at(face, 0.5) == 0);
  CHECK(exact::coplanarity_at(face, 0.25) == 8);
  CHECK(exact::coplanarity_at(face, 0x1.0000000000001p-1) == -32 * 0x1p-53);
}
