// Queries of coordinates of two sizes, far apart: their answers come from a query with a narrower gap.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstdio>

#include "exact/exact.hpp"
#include "exact/gap.hpp"
#include "support/answer_check.hpp"
#include "support/catch.hpp"
#include "support/report.hpp"

namespace touchstone::tests {
namespace {

Vec3 small_integers(Rng& rng, int reach) {
  const double x = rng.between(-reach, reach);
  const double y = rng.between(-reach, reach);
  const double z = rng.between(-reach, reach);
  return {x, y, z};
}

/// Small integers, often in a plane, at rest in part or with a shared corner; some of those along some axes are times
/// one very small power of two.
Query gapped(Kind kind, Rng& rng) {
  Query query;
  query.kind = kind;
  const int reach = rng.between(1, 3);
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    query.start[i] = small_integers(rng, reach);
    query.end[i] = rng.one_in(4) ? query.start[i] : small_integers(rng, reach);
  }
  if (rng.one_in(3)) {  // a common plane, or line
    const bool line = rng.one_in(4);
    for (std::size_t i = 0; i < corner_count(kind); ++i) {
      query.start[i].z = query.end[i].z = 0;
      if (line) query.start[i].y = query.end[i].y = 0;
    }
  }
  if (rng.one_in(8)) {  // an edge without length, or a flat face
    query.start[1] = query.start[0];
    query.end[1] = query.end[0];
  }
  if (rng.one_in(8)) {
    query.start[3] = query.start[2];
    query.end[3] = query.end[2];
  }
  for (std::size_t i = corner_count(kind); i < 4; ++i) query.start[i] = query.end[i] = {0, 0, 0};
  if (rng.one_in(4)) query.start[2] = query.start[0];
  if (rng.one_in(8)) query.end[2] = query.end[0];
  if (kind == Kind::point_point && rng.one_in(2)) {  // a meeting, or almost
    query.start[1] = query.start[0];
    for (double Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z})
      query.start[1].*axis += query.end[0].*axis - query.end[1].*axis;
  }
  constexpr int kLast = 1074;
  const int least = rng.one_in(3) ? 40 : rng.one_in(2) ? 100 : kLast - 100;
  const int exponent = -rng.between(least, least + 100);
  const int axes = rng.between(1, 7), rarity = rng.between(1, 7);
  static constexpr double Vec3::*members[] = {&Vec3::x, &Vec3::y, &Vec3::z};
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    for (Vec3* x : {&query.start[i], &query.end[i]}) {
      for (int k = 0; k < 3; ++k) {
        if ((axes >> k & 1) != 0 && rng.one_in(rarity)) x->*members[k] = std::ldexp(x->*members[k], exponent);
      }
    }
  }
  if (rng.one_in(3)) {  // layers, or almost: V has the root of their distance besides those of n
    const auto distance = [&] {
      const double large = rng.one_in(4) ? 0 : rng.between(-3, 3);
      return rng.one_in(2) ? large : std::ldexp(rng.between(-3, 3), exponent);
    };
    const double start_a = distance(), end_a = distance();
    double start_b = distance(), end_b = distance();
    if (rng.one_in(4)) {  // the base's layers meet at a double of 7 bits
      start_b = -rng.between(1, 127);
      end_b = 128 + start_b;
    }
    for (std::size_t i = 0; i < corner_count(kind); ++i) {
      if (rng.one_in(8)) continue;
      const bool in_a = i < (kind == Kind::edge_edge ? 2U : 1U);
      query.start[i].z = in_a ? start_a : start_b;
      query.end[i].z = in_a ? end_a : end_b;
    }
  }
  return query;
}

}  // namespace

TEST_CASE("a gap: queries of small integers and very small ones are answered as the exact level does") {
  const std::size_t count = effort(60000);
  Rng rng(31);
  std::size_t gaps = 0, answers = 0, contacts = 0;
  for (std::size_t i = 0; i < count; ++i) {
    static constexpr Kind kinds[] = {Kind::edge_edge,   Kind::vertex_face, Kind::edge_edge,
                                     Kind::vertex_face, Kind::point_edge,  Kind::point_point};
    const Query query = gapped(kinds[i % 6], rng);
    if (!exact::Gap::of(query)) continue;
    ++gaps;
    const std::optional<Answer> nearby = exact::decide_nearby(query, 1);
    if (!nearby) continue;
    ++answers;
    const Answer expected = exact::decide_exactly(query, 1);
    contacts += expected.contact;
    INFO("query " << i << ": " << cpp_initializer(query));
    REQUIRE(decision_difference(*nearby, expected) == "");
    REQUIRE(weight_difference(*nearby, expected) == "");
    const std::optional<Answer> time = exact::decide_nearby(query, 1, Wanted::time);
    REQUIRE(time.has_value());
    REQUIRE(time->toi == expected.toi);
    REQUIRE(time->toi_upper == expected.toi_upper);
  }
  std::printf("%zu gaps, %zu answers, %zu contacts\n", gaps, answers, contacts);
  CHECK(gaps * 10 > count * 6);
  CHECK(answers * 10 > gaps * 9);
  CHECK(contacts * 5 > answers);
}

TEST_CASE("a gap: a root as far from a double as the cube root of the small number") {
  // With s = k (t - time), u = (1, s, 0), w = (0, 1, s - d) and r = (c s, 0, d): V = c s^3 - c d s^2 + d.
  std::size_t answers = 0, contacts = 0;
  for (int exponent = 105; exponent < 420; ++exponent) {
    for (int i = 1; i < 8; ++i) {
      for (const double speed : {-2.0, 1.0, 4.0}) {
        const double time = i / 8.0, d = std::ldexp(exponent % 2 == 0 ? 1 : -3, -exponent);
        Query query;
        query.kind = Kind::edge_edge;
        for (const bool at_end : {false, true}) {
          const double s = speed * ((at_end ? 1 : 0) - time), f = i % 2 == 0 ? 0.5 : 0.25, c = 0.25;
          auto& corners = at_end ? query.end : query.start;
          corners[0] = {0, 0, 0};
          corners[1] = {1, s, 0};
          corners[2] = {f + c * s, f * s, d};
          corners[3] = {f + c * s, f * s + 1, s};
        }
        INFO(cpp_initializer(query));
        const std::optional<Answer> nearby = exact::decide_nearby(query, 1);
        if (!nearby) continue;
        ++answers;
        const Answer expected = exact::decide_exactly(query, 1);
        contacts += expected.contact;
        REQUIRE(decision_difference(*nearby, expected) == "");
        REQUIRE(weight_difference(*nearby, expected) == "");
      }
    }
  }
  std::printf("%zu answers, %zu contacts\n", answers, contacts);
  CHECK(answers > 100);
  CHECK(contacts > 100);
}

TEST_CASE("a gap: most queries of the families that have one are answered across it") {
  std::size_t wide = 0, answers = 0;
  for (const Family family : {Family::grazing_apart, Family::grazing_gone, Family::triple_root, Family::beside_ends}) {
    for (const Kind kind : {Kind::edge_edge, Kind::vertex_face}) {
      for (std::uint64_t i = 0; i < 400; ++i) {
        const Query query = make({family, kind, 32, i});
        if (!exact::Gap::of(query)) continue;
        ++wide;
        answers += exact::decide_nearby(query, 1).has_value();
      }
    }
  }
  std::printf("%zu wide, %zu answers\n", wide, answers);
  CHECK(wide > 400);
  CHECK(answers * 100 > wide * 98);
}

TEST_CASE("a gap: none in queries of one size, or of too many bits") {
  Query query = make({Family::lattice2, Kind::edge_edge, 33, 0});
  CHECK_FALSE(exact::Gap::of(query));
  query.start[0] = {1, 1, 1};
  query.end[1].z = 0x1p-400;
  CHECK(exact::Gap::of(query));
  query.start[1].y = 0x1.23456789abcdep-3;
  CHECK_FALSE(exact::Gap::of(query));
}

}  // namespace touchstone::tests
