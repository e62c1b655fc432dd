// The bracket level of curved queries: its numbers and polynomials against rationals, with a search for errors that
// come near their bounds, and its answers against the exact level's.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include <gmpxx.h>

#include "curved/expected.hpp"
#include "curved/rational_motion.hpp"
#include "filters/curved/curved_bracket.hpp"
#include "filters/curved/curved_frame.hpp"
#include "filters/curved/curved_paths.hpp"
#include "numbers/doubles/bounded.hpp"
#include "seeded/rng.hpp"
#include "support/query_families.hpp"
#include "support/slow_build.hpp"

namespace touchstone::tests {
namespace {

using filters::CurvedForm;
using filters::CurvedFrame;
using filters::FrameAt;
using numbers::Bounded;
using numbers::BoundedPair;
using seeded::Rng;

constexpr std::uint64_t kSeed = 71;

mpq_class exact(double x) { return mpq_class(x); }
mpq_class value_of(const Bounded& x) { return exact(x.value); }
mpq_class value_of(const BoundedPair& x) { return exact(x.value.high) + exact(x.value.low); }

/// How much of its bound an error takes up; fails where it is more than all of it.
struct Worst {
  double ratio = 0;

  void see(const mpq_class& found, const mpq_class& truth, double bound) {
    const mpq_class off = abs(mpq_class(found - truth));
    if (off == 0) return;
    REQUIRE(off <= exact(bound) * exact(numbers::kBoundSlack));
    ratio = std::max(ratio, mpq_class(off / exact(bound)).get_d());
  }
};

/// A double with many or few digits.
double number(Rng& rng, int magnitude) {
  double x = rng.one_in(4) ? 1 + rng.between(1, 7) * 0x1p-52 : 1 + rng.unit();
  if (rng.one_in(2)) x = -x;
  return std::ldexp(x, magnitude + rng.between(-4, 4));
}

template <class N, class Make>
double worst_of_numbers(std::uint64_t seed, int reach, const Make& make) {
  Worst worst;
  for (std::uint64_t index = 0; index < effort(20000); ++index) {
    Rng rng(seeded::seed_of_stream(seed, index));
    INFO("seed " << seed << ", index " << index);
    const int operations = rng.one_in(2) ? 1 : rng.between(2, 6);
    const int magnitude = operations == 1 ? rng.between(-reach, reach) : rng.between(-5, 5);  // squares of squares
    N x = make(rng, magnitude);
    mpq_class truth = value_of(x);
    for (int i = 0; i < operations; ++i) {
      const N y = make(rng, i == 0 ? magnitude : rng.between(-3, 3));
      switch (rng.between(0, 3)) {
        case 0:
          x = x + y;
          truth += value_of(y);
          break;
        case 1:
          x = x - y;
          truth -= value_of(y);
          break;
        case 2:
          x = x * y;
          truth *= value_of(y);
          break;
        default:
          x = x * x;
          truth *= truth;
          break;
      }
    }
    worst.see(value_of(x), truth, x.error);
    if (x.sign() != 0) REQUIRE(x.sign() == sgn(truth));
  }
  return worst.ratio;
}

TEST_CASE("curved bracket: what numbers are off by is within the bounds that they carry") {
  const double doubles = worst_of_numbers<Bounded>(kSeed, 400, [](Rng& rng, int magnitude) {
    return Bounded{number(rng, magnitude), 0};
  });
  const double pairs = worst_of_numbers<BoundedPair>(kSeed + 1, 400, [](Rng& rng, int magnitude) {
    const double high = number(rng, magnitude);
    const double low = rng.one_in(4) ? 0 : high * 0x1p-53 * rng.symmetric();
    return BoundedPair{numbers::two_sum(high, low), 0};
  });
  std::printf("the largest error is %.2g of the bound, and %.2g for double-doubles\n", doubles, pairs);
  CHECK(doubles > 0.9);
  CHECK(pairs > 0.2);
}

TEST_CASE("curved bracket: no sign is told of what under- or overflows") {
  const Bounded tiny{0x1p-600, 0}, huge{0x1p600, 0};
  CHECK((tiny * tiny).sign() == 0);
  CHECK((huge * huge).sign() == 0);
  CHECK((huge * huge - huge * huge).sign() == 0);
  CHECK((tiny * huge).sign() == 1);
  const BoundedPair tiny_pair{{0x1p-500, 0x1p-554}, 0}, huge_pair{{0x1p600, 0x1p540}, 0};
  CHECK((tiny_pair * tiny_pair).sign() == 0);
  CHECK((huge_pair * huge_pair).sign() == 0);
  CHECK((tiny_pair * -huge_pair).sign() == -1);
  // A product that is rounded to a subnormal number is greater than it should be, and one that is cut off is less.
  const Bounded rounded = Bounded{0x1.4p-537, 0} * Bounded{0x1.4p-537, 0} * Bounded{0x1p60, 0};
  CHECK((rounded - Bounded{0x1.99p-1014, 0}).sign() == 0);
  const BoundedPair cut = numbers::exact_pair(0x1.00001p-520) * numbers::exact_pair(0x1.00001p-520);
  CHECK((cut * numbers::exact_pair(0x1p100) - numbers::exact_pair(0x1.000020000080p-940)).sign() == 0);
}

/// Two elements on bodies or curves, of sizes that are not scaled, with digits that round badly.
CurvedQuery rough_query(Kind kind, Rng& rng) {
  CurvedQuery query;
  query.kind = kind;
  const int size = rng.between(-12, 12), spread = rng.one_in(3) ? rng.between(0, 40) : 0;
  const auto length = [&](int by) { return std::ldexp(number(rng, 0), size - 5 - (rng.one_in(3) ? by : 0)); };
  const auto place = [&] {
    const double x = length(spread), y = length(spread), z = length(spread);
    return Vec3{x, y, z};
  };
  const bool even = rng.one_in(2);  // components of one size: the bound's worst case
  for (RigidMotion& motion : query.motions) {
    const int q_size = rng.between(-8, 8);
    for (std::size_t i = 0; i < 4; ++i) {
      motion.q0[i] = std::ldexp(even ? (rng.one_in(2) ? 1 : -1) * (1 - 0x1p-6 * rng.unit()) : rng.symmetric(), q_size);
      motion.q1[i] = rng.one_in(2) ? motion.q0[i] * (1 + 0.01 * rng.symmetric()) : std::ldexp(rng.symmetric(), q_size);
    }
    motion.p0 = place();
    motion.p1 = place();
  }
  const std::size_t second = kind == Kind::edge_edge ? 2 : 1;
  const std::array<bool, 2> on_body = {!rng.one_in(3), !rng.one_in(3)};
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    const std::size_t element = i < second ? 0 : 1;
    CurvedCorner& corner = query.corners[i];
    corner.motion = on_body[element] ? static_cast<int>(element) : CurvedCorner::kOnCurve;
    corner.control_points = rng.between(1, 4);
    for (Vec3& point : corner.points) point = place();
  }
  return query;
}

/// The frame in rationals, by the definitions.
struct Truth {
  RationalPoint between, u, w;
  mpq_class first, second, v;
};

RationalPoint minus(const RationalPoint& a, const RationalPoint& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Truth truth_at(const CurvedQuery& query, const mpq_class& t) {
  const std::size_t second = query.kind == Kind::edge_edge ? 2 : 1;
  std::array<RationalCorner, 4> x;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) x[i] = corner_at(query, i, t);
  Truth truth;
  truth.second = x[0].weight;
  truth.first = x[second].weight;
  for (std::size_t k = 0; k < 3; ++k) {
    truth.between[k] = x[0].weight * x[second].numerator[k] - x[second].weight * x[0].numerator[k];
  }
  if (query.kind == Kind::edge_edge) {
    truth.u = minus(x[1].numerator, x[0].numerator);
    truth.w = minus(x[3].numerator, x[2].numerator);
  } else if (query.kind == Kind::vertex_face) {
    truth.u = minus(x[2].numerator, x[1].numerator);
    truth.w = minus(x[3].numerator, x[1].numerator);
  } else if (query.kind == Kind::point_edge) {
    truth.w = minus(x[2].numerator, x[1].numerator);
  }
  const auto& [between, u, w, first_weight, second_weight, v] = truth;
  truth.v = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    truth.v += (u[i] * w[j] - u[j] * w[i]) * between[k];
  }
  return truth;
}

/// The polynomial that the coefficients have as computed, at t.
template <std::size_t Dim>
mpq_class evaluate(const CurvedForm<Dim>& form, std::size_t coordinate, const mpq_class& t) {
  mpq_class value = 0;
  for (int k = 0; k <= form.degree; ++k) {
    mpq_class term = exact(form.c[coordinate][static_cast<std::size_t>(k)]);
    for (int i = 0; i < k; ++i) term *= t;
    for (int i = k; i < form.degree; ++i) term *= 1 - t;
    value += term;
  }
  return value;
}

Kind some_kind(Rng& rng) { return static_cast<Kind>(rng.between(0, 3)); }
bool has_v(Kind kind) { return kind == Kind::edge_edge || kind == Kind::vertex_face; }

TEST_CASE("curved bracket: polynomials are within their bounds of the true ones") {
  Worst between, within, multiplier, v, cross, at_time, slopes, over_radius;
  std::size_t known = 0;
  for (std::uint64_t index = 0; index < effort(4000); ++index) {
    Rng rng(seeded::seed_of_stream(kSeed + 2, index));
    INFO("seed " << kSeed + 2 << ", index " << index);
    const CurvedQuery query = rough_query(some_kind(rng), rng);
    const CurvedFrame frame = filters::curved_frame(query);
    if (!frame.known) continue;
    ++known;
    const double time = rng.one_in(4) ? rng.between(0, 1) : rng.unit();
    const mpq_class t = exact(time);
    const Truth truth = truth_at(query, t);
    multiplier.see(evaluate(frame.first_multiplier, 0, t), truth.first, frame.first_multiplier.error);
    multiplier.see(evaluate(frame.second_multiplier, 0, t), truth.second, frame.second_multiplier.error);
    for (std::size_t k = 0; k < 3; ++k) {
      const mpq_class value = evaluate(frame.between, k, t);
      between.see(value, truth.between[k], frame.between.error);
      REQUIRE(abs(value) <= exact(frame.between.size) * exact(numbers::kBoundSlack));
      if (query.kind != Kind::point_point) within.see(evaluate(frame.w, k, t), truth.w[k], frame.w.error);
      if (has_v(query.kind)) within.see(evaluate(frame.u, k, t), truth.u[k], frame.u.error);
    }
    if (query.kind == Kind::point_edge) {
      const auto component = filters::cross_component_of(frame, 2);
      const mpq_class expected = truth.between[0] * truth.w[1] - truth.between[1] * truth.w[0];
      cross.see(evaluate(component, 0, t), expected, component.error);
    }
    if (!has_v(query.kind)) continue;
    const auto form = filters::coplanarity_of(frame);
    v.see(evaluate(form, 0, t), truth.v, form.error);
    const Bounded value = filters::value_at(form, time);
    at_time.see(exact(value.value), evaluate(form, 0, t), value.error - form.error);
    REQUIRE(abs(mpq_class(exact(value.value) - truth.v)) <= exact(value.error));

    // The derivative of the polynomial as computed, from its values: a difference, of a small width.
    const auto slope = filters::derivative_of(form);
    const mpq_class width = mpq_class(1) / mpq_class(mpz_class(1) << 80);
    const mpq_class near = t < mpq_class(1, 2) ? mpq_class(t + width) : mpq_class(t - width);
    const mpq_class quotient = (evaluate(form, 0, near) - evaluate(form, 0, t)) / (near - t);
    slopes.see(evaluate(slope, 0, t), quotient, (slope.error - 2 * form.degree * form.error) + 0x1p-60 * form.size);
    const double bound = filters::slope_of(form);
    REQUIRE(abs(quotient) <= exact(bound) * exact(numbers::kBoundSlack));
    const double radius = std::ldexp(1.0, -rng.between(1, 50));
    const double other = time < 0.5 ? time + radius * rng.unit() : time - radius * rng.unit();
    const Bounded over = filters::value_at(form, time, radius, bound);
    const mpq_class moved = truth_at(query, exact(other)).v;
    over_radius.see(exact(over.value), moved, over.error);
  }
  std::printf(
      "%zu frames, the largest errors are of their bounds: between %.2g, within %.2g, multipliers %.2g, V %.2g, "
      "components %.2g, values %.2g, slopes %.2g, beside a time %.2g\n",
      known, between.ratio, within.ratio, multiplier.ratio, v.ratio, cross.ratio, at_time.ratio, slopes.ratio,
      over_radius.ratio);
  CHECK(known > effort(4000) / 2);
  if (!whole_effort("how near the errors come to their bounds")) return;
  CHECK(between.ratio > 0.05);
  CHECK(within.ratio > 0.05);
  CHECK(multiplier.ratio > 0.05);
  CHECK(v.ratio > 0.01);
  CHECK(cross.ratio > 0.01);
  CHECK(at_time.ratio > 0.01);
  CHECK(slopes.ratio > 0.05);
  CHECK(over_radius.ratio > 0.2);
}

TEST_CASE("curved bracket: the frame at one time in double-doubles") {
  Worst worst;
  for (std::uint64_t index = 0; index < effort(3000); ++index) {
    Rng rng(seeded::seed_of_stream(kSeed + 3, index));
    INFO("seed " << kSeed + 3 << ", index " << index);
    const CurvedQuery query = rough_query(some_kind(rng), rng);
    if (!filters::curved_frame(query).known) continue;
    BoundedPair time = numbers::exact_pair(rng.unit());
    mpq_class t = value_of(time);
    if (rng.one_in(2) && time.value.high > 0) {
      time.value = numbers::two_sum(time.value.high, time.value.high * 0x1p-54 * rng.symmetric());
      time.error = std::ldexp(rng.unit(), -rng.between(60, 110));
      t = value_of(time) + exact(time.error) * rng.between(-1, 1);
      if (t < 0 || t > 1) continue;
    }
    const FrameAt frame = filters::frame_at(query, time);
    const Truth truth = truth_at(query, t);
    const auto see = [&](const BoundedPair& found, const mpq_class& expected) {
      worst.see(value_of(found), expected, found.error);
    };
    see(frame.first_multiplier, truth.first);
    see(frame.second_multiplier, truth.second);
    for (std::size_t k = 0; k < 3; ++k) {
      see(frame.between[k], truth.between[k]);
      if (query.kind != Kind::point_point) see(frame.w[k], truth.w[k]);
      if (has_v(query.kind)) see(frame.u[k], truth.u[k]);
    }
    if (has_v(query.kind)) see(geometry::dot(geometry::cross(frame.u, frame.w), frame.between), truth.v);
  }
  std::printf("the largest error of a frame at a time is %.2g of its bound\n", worst.ratio);
  CHECK(worst.ratio > 0.1);
}

TEST_CASE("curved bracket: its answers are the exact level's, and it decides what is not degenerate") {
  struct Tally {
    std::size_t hits = 0, misses = 0, exact_hits = 0, exact_misses = 0;
  };
  for (const Family family :
       {Family::turning_bodies, Family::curved_random, Family::near_meeting, Family::curved_scale}) {
    Tally tally;
    for (const Kind kind : kKinds) {
      for (std::uint64_t index = 0; index < effort(500); ++index) {
        const CaseId id{family, kind, kSeed, index};
        const CurvedSample sample = make_curved(id);
        Answer bracket;
        const filters::Outcome finding = filters::decide_in_brackets(sample.query, sample.t_max, bracket);
        const Answer exact = solve(sample.query, {.t_max = sample.t_max, .method = Method::exact});
        if (finding == filters::Outcome::uncertain) {
          ++(exact.contact ? tally.exact_hits : tally.exact_misses);
          continue;
        }
        ++(exact.contact ? tally.hits : tally.misses);
        INFO(case_name(id) << ", t_max " << hexfloat(sample.t_max) << "\n" << curved_text(sample.query));
        INFO("exact:   " << describe(exact) << "\nbracket: " << describe(bracket));
        REQUIRE((finding == filters::Outcome::contact) == exact.contact);
        REQUIRE(decision_difference(exact, bracket) == "");
        REQUIRE(weight_difference(exact, bracket) == "");
      }
    }
    std::printf("%-15s contacts: %zu by the bracket level, %zu not; misses: %zu, %zu\n",
                std::string(info(family).name).c_str(), tally.hits, tally.exact_hits, tally.misses, tally.exact_misses);
    CHECK(tally.hits > 0);
    CHECK(tally.misses > 0);
    const bool ordinary = family == Family::turning_bodies || family == Family::curved_random;
    if (ordinary) CHECK(tally.exact_hits + tally.exact_misses < (tally.hits + tally.misses) / 20);
  }
}

TEST_CASE("curved bracket: a direction for each part of the step") {
  // A rod turns by 120 degrees about z past a corner at rest: it is near the corner all the time, on all sides of it.
  RigidMotion turn;
  turn.q0 = {1, 0, 0, -0.5773502691896257};
  turn.q1 = {1, 0, 0, 0.5773502691896257};
  const auto rod = [&](double radius) {
    return curved(Kind::point_edge, {rest({0, 0, 0}), body(0, {radius, -0.1, 0}), body(0, {radius, 0.1, 0.01})},
                  {turn});
  };
  REQUIRE_FALSE(filters::certainly_farther(rod(1), {0.9, Metric::euclidean}));
  const Answer apart = solve(rod(1), {.separation = Separation{0.9, Metric::euclidean}});
  CHECK_FALSE(apart.contact);
  CHECK(apart.level == Level::bracket);
  CHECK(solve(rod(1), {.separation = Separation{1.001, Metric::euclidean}}).contact);
  // A separation of 0 is below all that the roots of one component tell apart.
  CHECK_FALSE(solve(rod(0x1p-20)).contact);
}

TEST_CASE("curved bracket: a contact at t_max, or just before it, or just after") {
  // A point turns by a quarter about z, from (5, 0, 0) to (0, 5, 0), and crosses a triangle in a plane through z.
  RigidMotion turn;
  turn.q1 = {1, 0, 0, 1};
  const CurvedQuery query =
      curved(Kind::vertex_face, {body(0, {5, 0, 0}), rest({0, 0, -9}), rest({30, 20, -9}), rest({6, 4, 9})}, {turn});
  const Answer whole = solve(query);
  REQUIRE(whole.contact);
  REQUIRE(whole.toi < whole.toi_upper);
  CHECK(whole.level == Level::bracket);
  CHECK(decision_difference(solve(query, {.method = Method::exact}), whole) == "");
  for (const double t_max : {whole.toi, std::nextafter(whole.toi, 0)}) {
    const Answer before = solve(query, t_max);
    CHECK_FALSE(before.contact);
    CHECK(before.level == Level::bracket);
  }
  CHECK(solve(query, whole.toi_upper).contact);
  CHECK(solve(query, {.t_max = whole.toi_upper, .wanted = Wanted::contact}).contact);
  CHECK_FALSE(solve(query, {.t_max = whole.toi, .wanted = Wanted::contact}).contact);
}

}  // namespace
}  // namespace touchstone::tests
