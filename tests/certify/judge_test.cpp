// Verdicts: each combination of claim and truth, with toi at the exact time and one double before and after it.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include <touchstone/certify.hpp>
#include <touchstone/contact_times.hpp>
#include <touchstone/error.hpp>
#include <touchstone/solve.hpp>

#include "certify/tally.hpp"
#include "io/times.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/query_text.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

Answer contact(double toi, double toi_upper) {
  Answer answer;
  answer.contact = true;
  answer.nature = Nature::crossing;
  answer.toi = toi;
  answer.toi_upper = toi_upper;
  return answer;
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("claims without a toi are judged on contact alone") {
  CHECK(judge({false, {}}, Answer()) == Verdict::holds);
  CHECK(judge({true, {}}, Answer()) == Verdict::phantom);
  CHECK(judge({false, {}}, contact(0.5, 0.5)) == Verdict::missed);
  CHECK(judge({true, {}}, contact(0.5, 0.5)) == Verdict::holds);
}

TEST_CASE("a claim is late when its toi is after the exact time, by one double or more") {
  const double before = std::nextafter(0.5, 0.0);
  const double after = std::nextafter(0.5, 1.0);
  SECTION("the exact time is a double") {
    const Answer truth = contact(0.5, 0.5);
    CHECK(judge({true, before}, truth) == Verdict::holds);
    CHECK(judge({true, 0.5}, truth) == Verdict::holds);
    CHECK(judge({true, after}, truth) == Verdict::late);
  }
  SECTION("the exact time lies between two doubles: the upper one is after it") {
    const Answer truth = contact(0.5, after);
    CHECK(judge({true, 0.5}, truth) == Verdict::holds);
    CHECK(judge({true, after}, truth) == Verdict::late);
  }
  SECTION("at both ends") {
    CHECK(judge({true, 0.0}, contact(0, 0)) == Verdict::holds);
    CHECK(judge({true, -0.0}, contact(0, 0)) == Verdict::holds);
    CHECK(judge({true, std::numeric_limits<double>::denorm_min()}, contact(0, 0)) == Verdict::late);
    CHECK(judge({true, 1.0}, contact(1, 1)) == Verdict::holds);
    CHECK(judge({true, std::nextafter(1.0, 2.0)}, contact(1, 1)) == Verdict::late);
    CHECK(judge({true, -1.0}, contact(0, 0)) == Verdict::holds);
  }
  CHECK(judge({true, 0.25}, Answer()) == Verdict::phantom);
}

TEST_CASE("late agrees with exact comparison against the exact time") {
  constexpr std::uint64_t kSeed = 99;
  CAPTURE(kSeed);
  Rng rng(kSeed);
  int late = 0;
  int between_doubles = 0;
  for (const Family family : {Family::prescribed, Family::random_doubles, Family::grazing_apart, Family::lattice4}) {
    for (int i = 0; i < 40; ++i) {
      const Query query = make(family, Kind::edge_edge, rng);
      const Answer answer = solve(query);
      if (!answer.contact) continue;
      CAPTURE(cpp_initializer(query), describe(answer));
      if (answer.toi != answer.toi_upper) ++between_doubles;
      const ExactTime first = contact_times(query).at(0).first;
      for (const double toi : {std::nextafter(answer.toi, -kInfinity), answer.toi, answer.toi_upper,
                               std::nextafter(answer.toi_upper, kInfinity)}) {
        const bool after = first.compare(toi) < 0;
        REQUIRE(judge({true, toi}, answer) == (after ? Verdict::late : Verdict::holds));
        late += after ? 1 : 0;
      }
    }
  }
  CHECK(late > 50);
  CHECK(between_doubles > 5);
}

namespace {

/// Two points of which one moves along x from `from` to `to`; the other stands at 0.
Query meeting(double from, double to) {
  PointPoint points;
  points.start[0].x = from;
  points.end[0].x = to;
  return points;
}

template <class AnyQuery>
Verdict as_written(const std::string& text, const AnyQuery& query) {
  return judge({true, io::parse_rounded_double(text), text}, query, solve(query));
}

}  // namespace

TEST_CASE("a time as written is compared exactly, not by its nearest double") {
  SECTION("the exact time is a double, 1/2") {
    const Query query = meeting(-1, 1);
    CHECK(as_written("0.5", query) == Verdict::holds);
    CHECK(as_written("0.500000000000000000000000000", query) == Verdict::holds);
    CHECK(as_written("0.50000000000000000001", query) == Verdict::late);
    CHECK(as_written("0.49999999999999999999", query) == Verdict::holds);
    CHECK(as_written("0x0.80000000000000000000000001p0", query) == Verdict::late);
  }
  SECTION("the exact time is 1/10, which no double is") {
    const Query query = meeting(-1, 9);
    CHECK(as_written("0.1", query) == Verdict::holds);
    CHECK(as_written("1e-1", query) == Verdict::holds);
    CHECK(as_written("0.10000000000000000000000001", query) == Verdict::late);
    CHECK(as_written("0.09999999999999999999999999", query) == Verdict::holds);
    CHECK(as_written("0x1.999999999999ap-4", query) == Verdict::late);
    CHECK(as_written("0x1.9999999999999p-4", query) == Verdict::holds);
    CHECK(as_written("0x1.99999999999999999999p-4", query) == Verdict::holds);
    CHECK(as_written("0.2", query) == Verdict::late);
    // The nearest double decides where there is no text.
    CHECK(judge({true, 0.1}, query, solve(query)) == Verdict::late);
    CHECK(judge({true, 0.1}, solve(query)) == Verdict::late);
  }
  SECTION("the exact time is the square root of 1/2") {
    PointEdge moving;
    moving.start = {{{0, 0.5, 0}, {0, 0, 0}, {1, 0, 0}}};
    moving.end = {{{1, 0.5, 0}, {0, 0, 0}, {1, 1, 0}}};
    const Query query = moving;
    CHECK(as_written("0.70710678118654752440084436210484903928", query) == Verdict::holds);
    CHECK(as_written("0.70710678118654752440084436210484903929", query) == Verdict::late);
    const std::string root =
        "0.707106781186547524400844362104849039284835937688474036588339868995366239231053519425193"
        "76716382078636750692311545614851246241802792536860632206074854996791570661133296375279637";
    CHECK(as_written(root, query) == Verdict::holds);
    CHECK(as_written(root.substr(0, root.size() - 1) + "9", query) == Verdict::late);
  }
  SECTION("the query is rational") {
    RationalQuery query;
    query.kind = Kind::point_point;
    query.start[0][0] = {"-1", "7"};
    query.end[0][0] = {"2", "7"};
    CHECK(as_written("0.33333333333333333333333333", query) == Verdict::holds);
    CHECK(as_written("0.33333333333333333333333334", query) == Verdict::late);
  }
}

TEST_CASE("times closer to 0 than any double are compared exactly") {
  const Query at_once = meeting(0, 1);
  CHECK(as_written("1e-400", at_once) == Verdict::late);
  CHECK(as_written("0x1p-2000", at_once) == Verdict::late);
  CHECK(as_written("-1e-400", at_once) == Verdict::holds);
  CHECK(as_written("0e-400", at_once) == Verdict::holds);
  // 2^-1074 / (2^-1074 + 2^997) = 3.68...e-624
  const Query soon = meeting(-0x1p-1074, 0x1p997);
  REQUIRE(solve(soon).toi == 0);
  CHECK(as_written("1e-400", soon) == Verdict::late);
  CHECK(as_written("3.68e-624", soon) == Verdict::holds);
  CHECK(as_written("3.69e-624", soon) == Verdict::late);
  CHECK(as_written("0x1p-2071", soon) == Verdict::late);
  CHECK(as_written("0x.ffffffp-2071", soon) == Verdict::holds);
}

TEST_CASE(
    "a time as written agrees with the nearest double wherever that decides, and is refused when it is no number") {
  constexpr std::uint64_t kSeed = 12;
  CAPTURE(kSeed);
  Rng rng(kSeed);
  for (int i = 0; i < 200; ++i) {
    const Query query = make(Family::prescribed, Kind::edge_edge, rng);
    const Answer answer = solve(query);
    if (!answer.contact) continue;
    for (const double toi : {0.0, answer.toi, answer.toi_upper, std::nextafter(answer.toi, 2.0), 0.75, 1.0, 2.0}) {
      REQUIRE(judge({true, toi, io::hexfloat(toi)}, query, answer) == judge({true, toi}, answer));
    }
  }
  const Query query = meeting(-1, 1);
  for (const char* text : {"half", "1e-9999", "nan"}) {
    CHECK_THROWS_AS(judge({true, 0.5, text}, query, solve(query)), InvalidQuery);
  }
  CHECK(judge({true, {}, "half"}, query, solve(query)) == Verdict::holds);
  CHECK(judge({false, {}, ""}, query, solve(query)) == Verdict::missed);
}

TEST_CASE("a claim that holds as written is no double early when its nearest double is after the exact time") {
  certify::Tally tally;
  const Query query = meeting(-1, 9);
  const Claim claim{true, 0.1, "0.1"};
  tally.add(claim, solve(query), judge(claim, query, solve(query)));
  CHECK(tally.verdicts.holds == 1);
  CHECK(tally.early.most_ulps() == 0);
  CHECK(tally.early.most_time() == 0);
}

TEST_CASE("verdicts have the names that reports use") {
  CHECK(name_of(Verdict::holds) == "holds");
  CHECK(name_of(Verdict::missed) == "missed");
  CHECK(name_of(Verdict::phantom) == "phantom");
  CHECK(name_of(Verdict::late) == "late");
}

TEST_CASE("a tally counts verdicts, levels, natures and early claims, and parts add up to the whole") {
  Answer sustained = contact(0.5, 0.5);
  sustained.nature = Nature::sustained;
  sustained.level = Level::oracle;
  Answer none;
  none.level = Level::filter;
  certify::Tally parts[2];
  const auto add = [&](int part, const Claim& claim, const Answer& answer) {
    parts[part].add(claim, answer, judge(claim, answer));
  };
  add(0, {true, 0.5}, sustained);   // holds, not early
  add(0, {true, 0.75}, sustained);  // late
  add(1, {true, 0.25}, sustained);  // holds, early
  add(1, {true, {}}, sustained);    // holds, no toi
  add(1, {true, 0.25}, none);       // phantom
  add(0, {false, {}}, none);        // holds
  add(1, {false, {}}, sustained);   // missed
  certify::Tally whole;
  for (const auto& part : parts) whole.merge(part);
  CHECK(whole.verdicts.holds == 4);
  CHECK(whole.verdicts.missed == 1);
  CHECK(whole.verdicts.phantom == 1);
  CHECK(whole.verdicts.late == 1);
  CHECK(whole.verdicts.refuted() == 3);
  CHECK(whole.verdicts.claims() == 7);
  CHECK(whole.levels[static_cast<std::size_t>(Level::filter)] == 2);
  CHECK(whole.levels[static_cast<std::size_t>(Level::oracle)] == 5);
  CHECK(whole.natures[static_cast<std::size_t>(Nature::none)] == 2);
  CHECK(whole.natures[static_cast<std::size_t>(Nature::sustained)] == 5);
  CHECK(whole.early.claims() == 2);
  CHECK(whole.early.least_time() == 0.0);
  CHECK(whole.early.most_time() == 0.25);
}
