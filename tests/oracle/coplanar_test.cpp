// Edges whose V is identically zero: parallel, in one plane, with a shared corner, without length.
// SPDX-License-Identifier: MIT
#include "oracle/expected.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

/// On the x axis: edge a from a0 to a1 moves by `shift`, edge b stands still.
Query on_a_line(double a0, double a1, double shift, double b0, double b1) {
  return EdgeEdge{{{{a0, 0, 0}, {a1, 0, 0}, {b0, 0, 0}, {b1, 0, 0}}},
                  {{{a0 + shift, 0, 0}, {a1 + shift, 0, 0}, {b0, 0, 0}, {b1, 0, 0}}}};
}

/// Edge a along x comes down from height 1 to -1 onto edge b on the x axis: they are on one line at t = 1/2.
Query parallel_fall(double a0, double a1, double b0, double b1) {
  return EdgeEdge{{{{a0, 0, 1}, {a1, 0, 1}, {b0, 0, 0}, {b1, 0, 0}}},
                  {{{a0, 0, -1}, {a1, 0, -1}, {b0, 0, 0}, {b1, 0, 0}}}};
}

Expected isolated_at_half(Feature a, Feature b, Weights weights_a, Weights weights_b) {
  return {at(0.5), Nature::isolated, a, b, weights_a, weights_b};
}

}  // namespace

TEST_CASE("a parallel edge comes down") {
  const Feature overlap = Feature::overlap;
  check_contact(parallel_fall(-1, 1, 0, 4), isolated_at_half(overlap, overlap, kSecond, {0.75, 0.25, 0}));
  check_contact(parallel_fall(1, -1, 0, 4), isolated_at_half(overlap, overlap, {0.5, 0.5, 0}, kFirst));
  check_contact(parallel_fall(-1, 1, 4, 0), isolated_at_half(overlap, overlap, kSecond, {0.25, 0.75, 0}));
  check_contact(parallel_fall(0, 4, 1, 2), isolated_at_half(overlap, overlap, {0.5, 0.5, 0}, kSecond));
  check_contact(parallel_fall(0, 4, 2, 1), isolated_at_half(overlap, overlap, {0.5, 0.5, 0}, kFirst));
  check_contact(parallel_fall(1, 2, 0, 4), isolated_at_half(overlap, overlap, kSecond, {0.5, 0.5, 0}));
  check_contact(parallel_fall(0, 1, 0, 1), isolated_at_half(overlap, overlap, kSecond, kSecond));
  check_contact(parallel_fall(0, 1, 1, 2), isolated_at_half(Feature::a1, Feature::b0, kSecond, kFirst));
  check_contact(parallel_fall(0, 1, 2, 1), isolated_at_half(Feature::a1, Feature::b1, kSecond, kSecond));
  check_contact(parallel_fall(1, 0, 1, 2), isolated_at_half(Feature::a0, Feature::b0, kFirst, kFirst));
  check_no_contact(parallel_fall(0, 1, std::nextafter(1, 2), 2));
  check_no_contact(parallel_fall(-1, 1, 0, 4), 0.25);
  CHECK(oracle::decide_by_oracle(parallel_fall(-1, 1, 0, 4), 0.5).nature == Nature::isolated);
}

TEST_CASE("edges on one line") {
  // a1 = -2 + 4t reaches b0 = 0 at t = 1/2, and then slides over it.
  check_contact(on_a_line(-3, -2, 4, 0, 1), {at(0.5), Nature::sustained, Feature::a1, Feature::b0, kSecond, kFirst});
  check_contact(on_a_line(-3, -2, 4, 0, 1), isolated_at_half(Feature::a1, Feature::b0, kSecond, kFirst), 0.5);
  check_no_contact(on_a_line(-3, -2, 4, 0, 1), std::nextafter(0.5, 0));
  check_contact(on_a_line(-4, -3, 9, 0, 1), {kOneThird, Nature::sustained, Feature::a1, Feature::b0, kSecond, kFirst});
  check_contact(on_a_line(0, 1, 8, -1, 3),
                {at(0), Nature::sustained, Feature::overlap, Feature::overlap, kSecond, {0.5, 0.5, 0}});
  check_contact(on_a_line(0, 1, 8, -1, 0), {at(0), Nature::isolated, Feature::a0, Feature::b1, kFirst, kSecond});
  check_contact(on_a_line(0, 1, 0, -1, 0), {at(0), Nature::sustained, Feature::a0, Feature::b1, kFirst, kSecond});
  check_contact(on_a_line(0, 1, 0, -1, 0), {at(0), Nature::isolated, Feature::a0, Feature::b1, kFirst, kSecond}, 0);
  check_no_contact(on_a_line(0, 1, 1, 3, 4));
}

TEST_CASE("edges with no length are touched at their first corner") {
  check_contact(parallel_fall(1, 1, 0, 4), isolated_at_half(Feature::a0, Feature::b, kFirst, {0.75, 0.25, 0}));
  check_contact(parallel_fall(4, 4, 0, 4), isolated_at_half(Feature::a0, Feature::b1, kFirst, kSecond));
  check_contact(parallel_fall(0, 4, 1, 1), isolated_at_half(Feature::a, Feature::b0, {0.75, 0.25, 0}, kFirst));
  check_contact(parallel_fall(2, 2, 2, 2), isolated_at_half(Feature::a0, Feature::b0, kFirst, kFirst));
  check_no_contact(parallel_fall(2, 2, 3, 3));
  check_contact(on_a_line(-1, -1, 2, 0, 0), isolated_at_half(Feature::a0, Feature::b0, kFirst, kFirst));
  check_contact(on_a_line(-1, -1, 2, 0, 1), {at(0.5), Nature::sustained, Feature::a0, Feature::b0, kFirst, kFirst});
}

TEST_CASE("edges with a shared corner touch from the start") {
  const Query query =
      EdgeEdge{{{{1, 2, 3}, {4, 5, 7}, {1, 2, 3}, {3, 1, 1}}}, {{{2, 2, 2}, {9, 4, 1}, {2, 2, 2}, {0, 7, 1}}}};
  check_contact(query, {at(0), Nature::sustained, Feature::a0, Feature::b0, kFirst, kFirst});
  check_contact(query, {at(0), Nature::isolated, Feature::a0, Feature::b0, kFirst, kFirst}, 0);
}

TEST_CASE("edges in one plane at rest") {
  // Edge a, upright in the plane z = 0, moves right; its line meets b's end at x = 0 when t = 1/2.
  const auto upright = [](double y0, double y1) {
    return Query(
        EdgeEdge{{{{-1, y0, 0}, {-1, y1, 0}, {0, 0, 0}, {8, 0, 0}}}, {{{1, y0, 0}, {1, y1, 0}, {0, 0, 0}, {8, 0, 0}}}});
  };
  check_contact(upright(-1, 3), {at(0.5), Nature::sustained, Feature::a, Feature::b0, {0.75, 0.25, 0}, kFirst});
  check_contact(upright(0, 3), {at(0.5), Nature::sustained, Feature::a0, Feature::b0, kFirst, kFirst});
  check_no_contact(upright(0x1p-1074, 3));
}

TEST_CASE("an irrational first time in a plane") {
  // In the plane y = 0, edge b from (-1, t) to (2t, -1) reaches the origin at t = sqrt(1/2), where edge a begins, and
  // then crosses it.
  const Query query =
      EdgeEdge{{{{0, 0, 0}, {5, 0, 5}, {-1, 0, 0}, {0, 0, -1}}}, {{{0, 0, 0}, {5, 0, 5}, {-1, 0, 1}, {2, 0, -1}}}};
  check_contact(
      query,
      {kSqrtHalf, Nature::sustained, Feature::a0, Feature::b, kFirst, {1 - kSqrtTwoMinusOne, kSqrtTwoMinusOne, 0}});
  check_no_contact(query, kSqrtHalf.first);
}

TEST_CASE("two irrational roots of different polynomials at one time") {
  // In the plane y = 0, both edges are (1 + something) times the same moving edge from (-1, t) to (2t, -1): they are
  // parallel, and on one line through the origin exactly at t = sqrt(1/2).
  const Query query =
      EdgeEdge{{{{-1, 0, 0}, {0, 0, -1}, {-2, 0, 0}, {0, 0, -2}}}, {{{-1, 0, 1}, {2, 0, -1}, {-2, 0, 2}, {4, 0, -2}}}};
  // b0 is at twice a0 and b1 at twice a1, on either side of the origin: the whole of a is shared.
  check_contact(query, {kSqrtHalf,
                        Nature::isolated,
                        Feature::overlap,
                        Feature::overlap,
                        kSecond,
                        {0.5 * (1 - kSqrtTwoMinusOne), 0.5 * (1 + kSqrtTwoMinusOne), 0}});
}

TEST_CASE("edges in a plane that turns") {
  // Every corner is at (x(t), y, t y). a1 = -2 + 4t reaches edge b at x = 0, and passes.
  const Query query =
      EdgeEdge{{{{-3, 0, 0}, {-2, 0, 0}, {0, -1, 0}, {0, 3, 0}}}, {{{1, 0, 0}, {2, 0, 0}, {0, -1, -1}, {0, 3, 3}}}};
  check_contact(query, {at(0.5), Nature::sustained, Feature::a1, Feature::b, kSecond, {0.75, 0.25, 0}});
}
