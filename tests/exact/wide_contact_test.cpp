// What doubles of any exponent tell about a query is what the exact level decides.
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>

#include "exact/exact.hpp"
#include "exact/exact_times.hpp"
#include "exact/wide_contact.hpp"
#include "numbers/exact_number.hpp"
#include "support/catch.hpp"
#include "support/report.hpp"
#include "support/wild_query.hpp"

namespace touchstone::tests {
namespace {

using exact::look_widely;
using exact::WideLook;
using numbers::Exact;
using Verdict = WideLook::Verdict;

struct Part {
  Exact start, end;
};

Part part_of(const WideLook& look) {
  Part part{Exact(0), Exact(1)};
  for (std::size_t i = 0; i < look.steps_taken; ++i) {
    const WideLook::Step& step = look.steps[i];
    const Exact distance = (part.end - part.start) * Exact(step.distance) * numbers::power_of_two(-step.exponent);
    (step.after ? part.start : part.end) = step.from_end ? part.end - distance : part.start + distance;
  }
  return part;
}

/// What is wrong with it; empty when nothing is.
std::string mistake(const Query& query, const WideLook& look) {
  if (look.verdict == Verdict::open) return "";
  const Answer expected = exact::decide_exactly(query, 1);
  if (look.verdict == Verdict::apart) return expected.contact ? "apart, but they touch" : "";
  if (!expected.contact) return "touching, but they do not";
  if (expected.nature != Nature::crossing) return "a contact that is not a crossing";
  const Feature inside = query.kind == Kind::edge_edge ? Feature::b : Feature::f;
  if (expected.feature_b != inside) return "a contact on a border";
  if (query.kind == Kind::edge_edge && expected.feature_a != Feature::a) return "a contact on a border";
  const Part part = part_of(look);
  if ((Exact(expected.toi_upper) - part.start).sign() <= 0) return "the part starts after the contact";
  if ((part.end - Exact(expected.toi)).sign() <= 0) return "the part ends before the contact";
  int contacts = 0;  // at all roots of V in the part, as the side conditions hold there
  for (const auto& time : exact::touching_times(query, 1)) {
    contacts += time.first.compare(part.start) > 0 && time.first.compare(part.end) < 0;
  }
  return contacts == 1 ? "" : "not one root in the part";
}

struct Count {
  std::size_t all = 0, apart = 0, touching = 0;
  void add(Verdict verdict) {
    ++all;
    apart += verdict == Verdict::apart;
    touching += verdict == Verdict::touching;
  }
};

}  // namespace

TEST_CASE("wide doubles tell of queries of wild magnitudes what is true, and of most of them") {
  Rng rng(91);
  Count count;
  int wrong = 0;
  for (std::size_t i = 0; i < effort(60000); ++i) {
    const Query query = wild_query(i % 2 == 0 ? Kind::edge_edge : Kind::vertex_face, rng);
    const WideLook look = look_widely(query);
    count.add(look.verdict);
    const std::string what = mistake(query, look);
    if (!what.empty() && ++wrong <= 5) std::printf("query %zu: %s\n", i, what.c_str());
  }
  std::printf("%zu queries: %zu apart, %zu touching\n", count.all, count.apart, count.touching);
  CHECK(wrong == 0);
  CHECK(count.apart * 10 > count.all * 3);
  CHECK(count.touching * 100 > count.all);
}

TEST_CASE("wide doubles tell of every family what is true") {
  Report report;
  Count count;
  for_each_case(
      92, 300, [](const FamilyInfo&, Kind kind) { return kind != Kind::point_point; },
      [&](const CaseId& id) {
        const Query query = make(id);
        const WideLook look = look_widely(query);
        count.add(look.verdict);
        report.add(id, query, mistake(query, look));
      });
  std::printf("%zu queries: %zu apart, %zu touching\n", count.all, count.apart, count.touching);
  CHECK(count.apart * 10 > count.all * 2);
  CHECK(count.touching * 100 > count.all * 2);
  report.finish();
}

TEST_CASE("V has the sign at the start of the part that wide doubles tell") {
  // Both edges' lines meet at t = 1/2, where V changes its sign, from V(0) = 1.
  Query query;
  query.start = {{{-1, 0, 0}, {1, 0, 0}, {0, -1, -1}, {0, 1, -1}}};
  query.end = {{{-1, 0, 0}, {1, 0, 0}, {0, -1, 1}, {0, 1, 1}}};
  const WideLook look = look_widely(query);
  REQUIRE(look.verdict == Verdict::touching);
  CHECK(look.axis == 2);
  const int expected = exact::coplanarity_at(query, 0) > 0 ? 1 : -1;
  CHECK(look.sign_at_start == expected);
  std::swap(query.start, query.end);
  CHECK(look_widely(query).sign_at_start == -expected);

  // A vertex falls through a face.
  query.kind = Kind::vertex_face;
  query.start = {{{0.25, 0.25, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  query.end = {{{0.25, 0.25, -1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  CHECK(look_widely(query).verdict == Verdict::touching);
  CHECK(look_widely(query).sign_at_start == (exact::coplanarity_at(query, 0) > 0 ? 1 : -1));
  std::swap(query.start, query.end);
  CHECK(look_widely(query).sign_at_start == (exact::coplanarity_at(query, 0) > 0 ? 1 : -1));
}

TEST_CASE("wide doubles tell nearly all points and edges of wild magnitudes apart that do not touch") {
  Rng rng(93);
  std::size_t apart = 0, all = 0;
  int wrong = 0;
  for (std::size_t i = 0; i < effort(40000); ++i) {
    const Query query = wild_query(Kind::point_edge, rng);
    const bool contact = exact::decide_exactly(query, 1).contact;
    all += !contact;
    const Verdict verdict = look_widely(query).verdict;
    REQUIRE(verdict != Verdict::touching);
    apart += verdict == Verdict::apart;
    wrong += contact && verdict == Verdict::apart;
  }
  CHECK(wrong == 0);
  CHECK(apart * 10 > all * 9);
  CHECK(apart < all);
}

TEST_CASE("a point that passes behind the end of an edge, and one that touches the end, in wide doubles") {
  // It crosses the line at t = 1/2, at `place` for an edge from 0 to 1.
  const auto query_at = [](double place) {
    Query query;
    query.kind = Kind::point_edge;
    query.start = {{{place, -1, 0}, {0, 0, 0}, {1, 0, 0}}};
    query.end = {{{place, 1, 0}, {0, 0, 0}, {1, 0, 0}}};
    return query;
  };
  for (const double place : {-0.125, 1.125, -1.0, 2.0}) {
    CHECK(look_widely(query_at(place)).verdict == Verdict::apart);
  }
  for (const double place : {0.0, 0.5, 1.0}) CHECK(look_widely(query_at(place)).verdict == Verdict::open);
}

TEST_CASE("wide doubles tell nothing of two points") {
  Rng rng(94);
  for (int i = 0; i < 100; ++i) REQUIRE(look_widely(wild_query(Kind::point_point, rng)).verdict == Verdict::open);
}

}  // namespace touchstone::tests
