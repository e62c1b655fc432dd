// `toi` is never 0 for elements that start apart, `true` never comes with an infinite time, and no_zero_toi makes the
// step of a line search greater than 0 where the separation is lost already.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>

#include <touchstone/distance.hpp>
#include <touchstone/solve.hpp>

#include "dropin/tight_inclusion_query.hpp"
#include "separation/distances.hpp"
#include "support/catch.hpp"
#include "support/report.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Call with(double ms, bool no_zero_toi) {
  Call call;
  call.ms = ms;
  call.no_zero_toi = no_zero_toi;
  return call;
}

}  // namespace

TEST_CASE("a gap of any size gives a time after 0, and true never comes with an infinite time") {
  for (const double gap : {1e-3, 1e-12, 1e-15, 1e-16, 1e-100, 1e-300}) {
    for (const bool no_zero_toi : {false, true}) {
      for (const double ms : {0.0, gap / 2}) {
        for (const long max_itr : {-1L, 1000L, 1000000L}) {
          CAPTURE(gap, no_zero_toi, ms, max_itr);
          Call call = with(ms, no_zero_toi);
          call.max_itr = max_itr;
          for (const double depth : {1.0, 0.0, 1e-15}) {
            const Impact impact = ask(falling_vertex(gap, -depth), call);
            CHECK(impact.exists);
            CHECK(impact.toi > 0);
            CHECK(impact.toi <= 1);
          }
          const Impact away = ask(falling_vertex(gap, 2 * gap), call);
          CHECK_FALSE(away.exists);
          CHECK(away.toi == kInfinity);
        }
      }
    }
  }
}

TEST_CASE("a time below the least positive double is 0, with and without no_zero_toi") {
  // The exact time is 2^-1074 / (2^1000 + 2^-1074): no positive double is safe.
  CHECK(ask(falling_vertex(0x1p-1074, -0x1p1000), with(0, false)).toi == 0);
  CHECK(ask(falling_vertex(0x1p-1074, -0x1p1000), with(0, true)).toi == 0);
  CHECK(ask(falling_vertex(0x1p-1074, -1), with(0, false)).toi == 0);
  CHECK(ask(falling_vertex(0x1p-1073, -1), with(0, false)).toi == 0x1p-1074);
}

TEST_CASE("elements that touch at the start have toi 0, with and without no_zero_toi") {
  for (const double ms : {0.0, 0x1p-1074, 1e-3, 1e300}) {
    for (const bool no_zero_toi : {false, true}) {
      CAPTURE(ms, no_zero_toi);
      for (const double end : {-1.0, 0.0, 1.0}) {
        const Impact impact = ask(falling_vertex(0, end), with(ms, no_zero_toi));
        CHECK(impact.exists);
        CHECK(impact.toi == 0);
      }
    }
  }
}

TEST_CASE("no_zero_toi asks about a separation that the elements still have") {
  // At the height 3/4 within ms = 1; half of the distance is 3/8, and the first of 1/2, 1/4, ... below is 1/4.
  const Query falling = falling_vertex(0.75, -0.25);
  CHECK(ask(falling, with(1, false)).toi == 0);
  CHECK(ask(falling, with(1, true)).toi == 0.5);
  // From 1, equal to ms, half of the distance is 1/2.
  CHECK(ask(falling_vertex(1, 0), with(1, true)).toi == 0.5);
  // Elements that come no nearer than the smaller separation may move.
  const Impact leaving = ask(falling_vertex(0.75, 3), with(1, true));
  CHECK_FALSE(leaving.exists);
  CHECK(leaving.toi == kInfinity);
  CHECK(ask(falling_vertex(0.75, 3), with(1, false)).exists);
  // It changes nothing for elements that start farther apart than ms.
  CHECK(ask(falling_vertex(3, -1), with(1, true)).toi == 0.5);
  CHECK(ask(falling_vertex(3, -1), with(1, false)).toi == 0.5);
}

TEST_CASE("no_zero_toi keeps between a quarter and a half of the distance, for all sorts of queries") {
  Report report;
  std::size_t smaller_separations = 0;
  const auto wanted = [](const FamilyInfo&, Kind kind) { return kind == Kind::edge_edge || kind == Kind::vertex_face; };
  for_each_case(17, 8, wanted, [&](const CaseId& id) {
    Rng rng = rng_of(id);
    const Query query = make_sample(id.family, id.kind, rng).query;
    const double ms = interesting_distance(query, Metric::max, rng);
    const Answer plain = solve(query, {.separation = Separation{ms, Metric::max}, .method = Method::exact});
    const Impact impact = ask(query, with(ms, true));
    std::string wrong;
    if (impact.exists != (impact.toi <= 1)) wrong = "the time does not fit the verdict";
    if (!plain.starts_within && (impact.exists != plain.contact || impact.toi != plain.toi)) {
      wrong = "it changes an answer of elements that start apart";
    }
    const double start = distance(query, 0, Metric::max).value;
    if (plain.starts_within && start == 0 && ms > 0 && compare_distance(query, 0, {0, Metric::max}) == 0 &&
        !(impact.exists && impact.toi == 0)) {
      wrong = "elements that touch may move";
    }
    if (plain.starts_within && start > 0x1p-1000 && ms > 0) {
      ++smaller_separations;
      const double step = impact.exists ? impact.toi : 1;
      // The time itself may be too small for a double where the step is huge.
      const bool can_be_zero = extent(query) / start > 0x1p1000;
      if (!(step > 0) && !can_be_zero) wrong = "the elements are apart at the start, and may not move";
      // The smaller separation lies between a quarter of the distance and half of it.
      if (solve(query, {.t_max = std::nextafter(step, 0.0),
                        .separation = Separation{start / 4 * (1 - 0x1p-50), Metric::max},
                        .wanted = Wanted::contact})
              .contact) {
        wrong = "the step comes nearer than a quarter of the distance";
      }
      if (impact.exists && !solve(query, {.t_max = std::min(std::nextafter(impact.toi, 2.0), 1.0),
                                          .separation = Separation{start / 2 * (1 + 0x1p-50), Metric::max},
                                          .wanted = Wanted::contact})
                                .contact) {
        wrong = "the step ends farther away than half of the distance";
      }
    }
    report.add(id, query, labelled("ms = " + hexfloat(ms), wrong));
  });
  if (whole_effort("that smaller separations are needed")) CHECK(smaller_separations > 50);
  report.finish();
}
