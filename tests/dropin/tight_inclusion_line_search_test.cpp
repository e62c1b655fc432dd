// The law of line searches: the path of a step that the drop-in allowed is free, and the next step is greater than 0.
// The positions after a step are rounded. So the law is tested where they are exact, where a separation is larger than
// the rounding, and for steps of 0.8 toi, as programs take them.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdio>

#include <touchstone/distance.hpp>
#include <touchstone/solve.hpp>

#include "dropin/tight_inclusion_query.hpp"
#include "support/catch.hpp"
#include "support/report.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

double stepped(double x0, double x1, double step) { return x0 + step * (x1 - x0); }

/// The corners after a step along the query's paths, rounded as a program rounds them.
std::array<Vec3, 4> stepped(const Query& query, double step) {
  std::array<Vec3, 4> x;
  for (std::size_t i = 0; i < 4; ++i) {
    x[i] = {stepped(query.start[i].x, query.end[i].x, step), stepped(query.start[i].y, query.end[i].y, step),
            stepped(query.start[i].z, query.end[i].z, step)};
  }
  return x;
}

Query moving(Kind kind, const std::array<Vec3, 4>& start, const std::array<Vec3, 4>& end) {
  Query query;
  query.kind = kind;
  query.start = start;
  query.end = end;
  return query;
}

bool edge_edge_or_vertex_face(const FamilyInfo&, Kind kind) {
  return kind == Kind::edge_edge || kind == Kind::vertex_face;
}

/// Random elements in a box, whose targets lie there too.
Query random_step(Kind kind, double scale, Rng& rng) {
  Query query;
  query.kind = kind;
  for (auto* corners : {&query.start, &query.end}) {
    for (Vec3& x : *corners) {
      x.x = scale * rng.symmetric();
      x.y = scale * rng.symmetric();
      x.z = scale * rng.symmetric();
    }
  }
  return query;
}

bool oracle_finds_contact(const Query& query) { return solve(query, {.method = Method::oracle}).contact; }

}  // namespace

TEST_CASE("the time before toi is free of contact, and the time after it is not") {
  Report report;
  std::size_t contacts = 0;
  for_each_case(19, 8, edge_edge_or_vertex_face, [&](const CaseId& id) {
    Rng rng = rng_of(id);
    const Query query = make_sample(id.family, id.kind, rng).query;
    Call call;
    const Impact impact = ask(query, call);
    std::string wrong;
    if (impact.exists && impact.toi > 0) {
      ++contacts;
      call.t_max = std::nextafter(impact.toi, 0.0);
      if (solve(query, {.t_max = call.t_max, .method = Method::exact}).contact || ask(query, call).exists)
        wrong = "a contact before toi";
      call.t_max = std::min(std::nextafter(impact.toi, 2.0), 1.0);
      if (!solve(query, {.t_max = call.t_max, .method = Method::exact}).contact || !ask(query, call).exists)
        wrong = "no contact after toi";
    }
    report.add(id, query, wrong);
  });
  if (whole_effort("that there are contacts")) CHECK(contacts > 50);
  report.finish();
}

TEST_CASE("after a step to less than toi the next query starts free, where positions are exact") {
  int steps = 0;
  Rng rng(23);
  for (std::size_t i = 0; i < effort(20000); ++i) {
    Query query = random_step(rng.one_in(2) ? Kind::edge_edge : Kind::vertex_face, 1, rng);
    for (auto* corners : {&query.start, &query.end}) {
      for (Vec3& x : *corners) x = {std::floor(8 * x.x), std::floor(8 * x.y), std::floor(8 * x.z)};
    }
    const Impact impact = ask(query, Call());
    // The greatest multiple of 2^-20 before toi: the products and sums of small integers with it are exact.
    const double step = std::ceil(impact.toi * 0x1p20 - 1) * 0x1p-20;
    if (!impact.exists || !(step > 0)) continue;
    ++steps;
    REQUIRE(step < impact.toi);
    const auto next = stepped(query, step);
    CAPTURE(step, cpp_initializer(query));
    CHECK_FALSE(ask(moving(query.kind, query.start, next), Call()).exists);
    const Impact rest = ask(moving(query.kind, next, query.end), Call());
    CHECK(rest.exists);
    CHECK(rest.toi > 0);
  }
  std::printf("%d steps\n", steps);
  if (whole_effort("that there are steps")) CHECK(steps > 1000);
}

TEST_CASE("a step to toi itself is free of touching, where the separation is larger than the rounding") {
  int steps = 0;
  for (const double scale : {1e-100, 0.01, 1.0, 1000.0}) {
    Rng rng(29);
    for (std::size_t i = 0; i < effort(1000); ++i) {
      Query query = random_step(rng.one_in(2) ? Kind::edge_edge : Kind::vertex_face, scale, rng);
      Call call;
      call.ms = scale * std::ldexp(1.0, -rng.between(8, 30));
      call.no_zero_toi = true;
      if (compare_distance(query, 0, {2 * call.ms, Metric::max}) <= 0) continue;
      // The same target again and again, as a line search that gets stuck: every step must be free.
      for (int k = 0; k < 4; ++k) {
        const Impact impact = ask(query, call);
        if (!impact.exists) break;
        ++steps;
        CAPTURE(scale, call.ms, k, cpp_initializer(query));
        REQUIRE(impact.toi > 0);
        const auto next = stepped(query, impact.toi);
        const Query path = moving(query.kind, query.start, next);
        CHECK_FALSE(ask(path, Call()).exists);
        if (rng.one_in(8)) CHECK_FALSE(oracle_finds_contact(path));
        query.start = next;
      }
    }
  }
  std::printf("%d steps\n", steps);
  if (whole_effort("that there are steps")) CHECK(steps > 1000);
}

TEST_CASE("steps of 0.8 toi are free, and the next step is greater than 0") {
  int steps = 0;
  for (const double scale : {1e-100, 0.01, 1.0, 1000.0}) {
    Rng rng(37);
    for (std::size_t i = 0; i < effort(1000); ++i) {
      Query query = random_step(rng.one_in(2) ? Kind::edge_edge : Kind::vertex_face, scale, rng);
      if (compare_distance(query, 0, {1e-3 * scale, Metric::max}) <= 0) continue;
      // Each step leaves a fifth of the way to the contact, so the gap stays far above the rounding.
      for (int k = 0; k < 6; ++k) {
        const Impact impact = ask(query, Call());
        if (!impact.exists) break;
        ++steps;
        CAPTURE(scale, k, cpp_initializer(query));
        REQUIRE(impact.toi > 0);
        const auto next = stepped(query, 0.8 * impact.toi);
        const Query path = moving(query.kind, query.start, next);
        CHECK_FALSE(ask(path, Call()).exists);
        if (rng.one_in(8)) CHECK_FALSE(oracle_finds_contact(path));
        query.start = next;
      }
    }
  }
  std::printf("%d steps\n", steps);
  if (whole_effort("that there are steps")) CHECK(steps > 1000);
}
