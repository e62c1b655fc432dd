// Verdicts: each combination of claim and truth, and toi's one double before, at and after the exact time.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include <touchstone/certify.hpp>
#include <touchstone/contact_times.hpp>
#include <touchstone/solve.hpp>

#include "certify/tally.hpp"
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

TEST_CASE("verdicts have the names that reports use") {
  CHECK(verdict_name(Verdict::holds) == "holds");
  CHECK(verdict_name(Verdict::missed) == "missed");
  CHECK(verdict_name(Verdict::phantom) == "phantom");
  CHECK(verdict_name(Verdict::late) == "late");
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
