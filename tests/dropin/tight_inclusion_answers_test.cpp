// The drop-in's answers are exact, whatever its arguments for searching say: compared with the oracle on queries that
// are hard for solvers, and with times that are known as fractions.
// SPDX-License-Identifier: MIT
#include <tight_inclusion/ccd.hpp>
#include <tight_inclusion/interval_root_finder.hpp>

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include <touchstone/error.hpp>
#include <touchstone/solve.hpp>

#include "dropin/tight_inclusion_query.hpp"
#include "separation/distances.hpp"
#include "support/catch.hpp"
#include "support/report.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

/// Whether `toi` is the greatest double that is not after numerator / denominator, both integers below 2^53. A fused
/// product and sum has the sign of the exact one.
bool is_lower_neighbour(double toi, double numerator, double denominator) {
  const double next = std::nextafter(toi, 2.0);
  return std::fma(toi, denominator, -numerator) <= 0 && std::fma(next, denominator, -numerator) > 0;
}

}  // namespace

TEST_CASE("the drop-in for Tight-Inclusion answers as the oracle does, by each of its functions", "[slow]") {
  Report report;
  std::size_t contacts = 0, starts = 0;
  const auto wanted = [](const FamilyInfo&, Kind kind) { return kind == Kind::edge_edge || kind == Kind::vertex_face; };
  for_each_case(13, 4, wanted, [&](const CaseId& id) {
    Rng rng = rng_of(id);
    const Query query = make_sample(id.family, id.kind, rng).query;
    const double ms = rng.one_in(3) ? 0 : interesting_distance(query, Metric::max, rng);
    const double t_max = rng.one_in(3) ? rng.unit() : 1;
    const Answer right =
        solve(query, {.t_max = t_max, .separation = Separation{ms, Metric::max}, .method = Method::oracle});
    const Answer right_to_the_end = solve(query, {.separation = Separation{ms, Metric::max}, .method = Method::oracle});
    contacts += right.contact;
    starts += right.starts_within;
    std::string wrong;
    const auto check = [&](const char* function, const Impact& found, const Answer& answer) {
      if (!wrong.empty() || (found.exists == answer.contact && found.toi == answer.toi)) return;
      wrong = std::string(function) + ": " + (found.exists ? "true" : "false") + " at " + hexfloat(found.toi) +
              ", not " + hexfloat(answer.toi) + " with ms = " + hexfloat(ms) + ", t_max = " + hexfloat(t_max);
    };
    for (const auto method :
         {ticcd::CCDRootFindingMethod::DEPTH_FIRST_SEARCH, ticcd::CCDRootFindingMethod::BREADTH_FIRST_SEARCH}) {
      for (const long max_itr : {-1L, 1L, 1000000L}) {
        Call call;
        call.ms = ms;
        call.t_max = t_max;
        call.max_itr = max_itr;
        call.method = method;
        call.tolerance = rng.one_in(2) ? 1e-6 : 100;
        call.err = rng.one_in(2) ? ticcd::Array3(-1, -1, -1) : ticcd::Array3(1e3, 1e3, 1e3);
        const Impact found = ask(query, call);
        check("CCD", found, right);
        if (wrong.empty() && found.output_tolerance != call.tolerance) wrong = "the tolerance was not reached";
      }
    }
    check("BFS", ask_breadth_first(query, ms, t_max), right);
    check("DFS", ask_depth_first(query, ms), right_to_the_end);
    report.add(id, query, wrong);
  });
  std::printf("%zu queries, %zu contacts, %zu of them at the start\n", report.checked(), contacts, starts);
  if (whole_effort("that there are contacts of both sorts")) {
    CHECK(contacts > 50);
    CHECK(starts > 10);
    CHECK(contacts > starts);
  }
  report.finish();
}

TEST_CASE("a vertex that falls onto a face arrives at the lower neighbour of a known fraction") {
  Rng rng(31);
  const ticcd::Vector3 f0(-0x1p30, -0x1p30, 0), f1(0x1p30, -0x1p30, 0), f2(0, 0x1p30, 0);
  for (int i = 0; i < 2000; ++i) {
    const double height = rng.between(2, 1 << 20), depth = rng.between(0, 1 << 20);
    const double ms = rng.one_in(3) ? 0 : rng.between(1, static_cast<int>(height) - 1);
    const ticcd::Vector3 start(1, 2, height), end(1, 2, -depth);
    CAPTURE(height, depth, ms);
    double toi = -1, output_tolerance = -1;
    // The height is ms at the time (height - ms) / (height + depth), and the face reaches far beyond the vertex.
    REQUIRE(ticcd::vertexFaceCCD(start, f0, f1, f2, end, f0, f1, f2, ticcd::Array3::Zero(), ms, toi, 1e-6, 1, 1000000,
                                 output_tolerance));
    CHECK(is_lower_neighbour(toi, height - ms, height + depth));
  }
}

TEST_CASE("the separation is measured along the axes, and a distance equal to it is a contact") {
  // The vertex passes the edge f1 f2 at the differences (3/8, 3/8, 0): the length of this difference is 0.53.
  const ticcd::Vector3 f0(-1, -1, 0), f1(1, -1, 0), f2(-1, 1, 0), start(0.375, 0.375, 2), end(0.375, 0.375, -2);
  const auto hits = [&](double ms) {
    double toi = -1, output_tolerance = -1;
    const bool hit = ticcd::vertexFaceCCD(start, f0, f1, f2, end, f0, f1, f2, ticcd::Array3::Zero(), ms, toi, 1e-6, 1,
                                          1000000, output_tolerance);
    CHECK(hit == (toi <= 1));
    return hit;
  };
  CHECK(hits(0.375));
  CHECK_FALSE(hits(std::nextafter(0.375, 0.0)));
}

TEST_CASE("a contact at t_max counts, and one after it does not") {
  Call call;
  call.t_max = 0.5;
  const Query query = falling_vertex(1, -1);
  CHECK(ask(query, call).toi == 0.5);
  call.t_max = std::nextafter(0.5, 0.0);
  CHECK_FALSE(ask(query, call).exists);
  call.t_max = 0;
  CHECK_FALSE(ask(query, call).exists);
  CHECK(ask(falling_vertex(0, -1), call).toi == 0);
  call.t_max = 1;
  CHECK(ask(falling_vertex(1, 0), call).toi == 1);
  CHECK(ask_depth_first(falling_vertex(1, 0), 0).toi == 1);
  CHECK(ask_breadth_first(falling_vertex(1, 0), 0, 1).toi == 1);
}

TEST_CASE("arguments without meaning throw, and leave the results alone") {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto refuses = [](const Query& query, const Call& call) {
    double toi = 7, output_tolerance = 8;
    CHECK_THROWS_AS(ask(query, call, toi, output_tolerance), InvalidQuery);
    CHECK(toi == 7);
    CHECK(output_tolerance == 8);
  };
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    refuses(falling_vertex(bad, -1), Call());
    Query query = falling_vertex(1, -1);
    query.kind = Kind::edge_edge;
    query.end[3].y = bad;
    refuses(query, Call());
  }
  for (const bool no_zero_toi : {false, true}) {
    Call call;
    call.no_zero_toi = no_zero_toi;
    for (const double bad : {-1e-300, -1.0, kNan, kInfinity}) {
      call.ms = bad;
      refuses(falling_vertex(1, -1), call);
    }
    call.ms = 0;
    for (const double bad : {-1e-300, 1 + 1e-15, kNan, kInfinity}) {
      call.t_max = bad;
      refuses(falling_vertex(1, -1), call);
    }
  }
  CHECK_THROWS_AS(ask_depth_first(falling_vertex(kNan, 0), 0), InvalidQuery);
  CHECK_THROWS_AS(ask_breadth_first(falling_vertex(1, 0), 0, 2), InvalidQuery);
}
