// The engine on curved queries: our solvers have no failure, planted bugs and the baselines have, and findings say how
// to repeat them.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include <touchstone/curved.hpp>
#include <touchstone/error.hpp>

#include "fuzz/answering_solver.hpp"
#include "fuzz/engine.hpp"
#include "fuzz/judging/finding_text.hpp"
#include "fuzz/margin.hpp"
#include "fuzz/named_solvers.hpp"
#include "fuzz/run_case.hpp"
#include "fuzz/shrinking/simplicity.hpp"
#include "support/catch.hpp"
#include "support/query_text.hpp"
#include "support/slow_build.hpp"

namespace touchstone::tests {
namespace {

fuzz::Settings curved_settings(std::uint64_t cases) {
  fuzz::Settings settings;
  settings.curved = true;
  settings.cases = effort(cases);
  settings.seed = 5;
  return settings;
}

fuzz::SolverFactory named(const char* name) {
  return [name] { return fuzz::named_solver(name); };
}

/// Gives the exact answer, but denies a contact after t = 1/4 where the first corner is on a body.
class PlantedBug final : public fuzz::AnsweringSolver {
 public:
  const std::string& name() const override { return name_; }
  bool supports(Kind) const override { return true; }
  bool takes_curves() const override { return true; }
  Answer answer(const Query& query) override { return solve(query); }
  fuzz::Reply ask(const Query&) override { return {}; }
  Answer answer_curved(const CurvedQuery& query, double t_max) override {
    Answer answer = solve(query, t_max);
    const bool on_body = query.corners[0].motion != CurvedCorner::kOnCurve;
    return on_body && answer.contact && answer.toi > 0.25 ? Answer() : answer;
  }
  fuzz::Reply ask_curved(const CurvedQuery&, double) override { return {}; }

 private:
  std::string name_ = "planted";
};

std::string text_of(const fuzz::SearchOutcome& outcome) {
  std::string text = std::to_string(outcome.queries);
  for (const fuzz::Finding& finding : outcome.findings) {
    text.append("\n").append(name_of(finding.failure)).append(fuzz::case_text(finding.example.name));
    text.append(std::to_string(finding.count)).append(fuzz::corners_text(finding.example.query, " "));
  }
  return text;
}

TEST_CASE("fuzzing curves: our methods have no failure, and the oracle agrees") {
  const fuzz::SearchOutcome fast = fuzz::run(named("touchstone"), curved_settings(4000));
  CHECK(fast.queries == effort(4000));
  CHECK(fast.kinds_of_failure == 0);
  fuzz::Settings by_oracle = curved_settings(300);
  by_oracle.judge = Method::oracle;
  CHECK(fuzz::run(named("touchstone"), by_oracle).kinds_of_failure == 0);
  for (const families::FamilyInfo& family : families::curved_families()) {
    INFO(family.name);
    CHECK(fast.table.of(family.family).cases > 0);
  }
}

TEST_CASE("fuzzing curves: a planted bug is found, shrunk, and repeated by the case's name") {
  const auto planted = [] { return std::make_unique<PlantedBug>(); };
  fuzz::Settings settings = curved_settings(1000);
  settings.most_findings = 4;
  const fuzz::SearchOutcome outcome = fuzz::run(planted, settings);
  REQUIRE(!outcome.findings.empty());
  for (const fuzz::Finding& finding : outcome.findings) {
    CHECK(finding.failure == fuzz::FailureClass::missed);
    CHECK(finding.degeneracy.curved);
    const auto& shrunk = std::get<CurvedQuery>(finding.example.query);
    INFO(curved_text(shrunk));
    CHECK(solve(shrunk, finding.example.t_max).toi > 0.25);
    CHECK(shrunk.corners[0].motion >= 0);
    const fuzz::CaseName& name = finding.example.name;
    const auto parsed = fuzz::parse_case_text(fuzz::case_text(name));
    REQUIRE(parsed.has_value());
    const fuzz::Asked asked = fuzz::asked_in_case(*parsed, fuzz::case_source(settings));
    CHECK(fuzz::difficulty(shrunk) <= fuzz::difficulty(std::get<CurvedQuery>(asked.query)));
    PlantedBug bug;
    fuzz::Settings one = settings;
    one.shrink_tries = 0;
    const auto again = fuzz::run_case(bug, *parsed, one).finding;
    REQUIRE(again.has_value());
    CHECK(again->failure == finding.failure);
  }
}

TEST_CASE("fuzzing curves: the outcome does not depend on the number of threads") {
  fuzz::Settings settings = curved_settings(400);
  settings.climb = 3;
  settings.most_findings = 3;
  settings.shrink_tries = 500;
  const std::string one = text_of(fuzz::run(named("curved_advancement"), settings));
  settings.threads = 4;
  CHECK(text_of(fuzz::run(named("curved_advancement"), settings)) == one);
}

TEST_CASE("fuzzing curves: the baselines are broken in the ways that they are known to fail") {
  fuzz::Settings settings = curved_settings(800);
  settings.shrink_tries = 0;
  const auto failures = [&](const char* name, fuzz::FailureClass failure) {
    return fuzz::run(named(name), settings).table.total().failures[fuzz::FailureTable::index(failure)];
  };
  if (!whole_effort("that the fuzzer breaks the baselines for curved queries")) return;
  CHECK(failures("redon", fuzz::FailureClass::missed) > 0);
  CHECK(failures("redon", fuzz::FailureClass::phantom) > 0);
  CHECK(failures("curved_advancement", fuzz::FailureClass::missed) > 0);
  CHECK(failures("curved_advancement", fuzz::FailureClass::phantom) > 0);
}

TEST_CASE("fuzzing curves: hill climbing goes towards queries on which the filter is only just certain") {
  std::size_t nearer = 0, all = 0;
  for (std::uint64_t index = 0; index < effort(40); ++index) {
    const fuzz::CaseName name{{families::Family::curved_random, Kind::vertex_face, 3, index}};
    const std::vector<fuzz::AnyQuery> none;
    fuzz::Climb climb = fuzz::climb_from(name, {none});
    const auto height = [](const fuzz::AnyQuery& query) {
      return std::fabs(std::log2(std::fabs(fuzz::filter_margin(query))));
    };
    const double start = height(fuzz::start_of_case(name, {none}).query);
    double least = start;
    for (int step = 0; step < 60; ++step) least = std::min(least, height(climb.next()));
    fuzz::CaseName last = name;
    last.step = 60;
    CHECK(std::holds_alternative<CurvedQuery>(fuzz::asked_in_case(last, {none}).query));
    ++all;
    nearer += least < 0.5 * start;
  }
  CHECK(2 * nearer >= all);
}

TEST_CASE("fuzzing curves: the margin of a separation is that of the elements' distance less it") {
  CurvedQuery query;
  query.kind = Kind::point_point;
  query.motions[0].q1 = {1, 0, 0, 1};
  query.corners = {CurvedCorner::on_body(0, {0, 0, 0}), CurvedCorner::on_curve({{5, 0, 0}})};
  CHECK(fuzz::filter_margin(query) > 1);
  CHECK(fuzz::filter_margin(query, Separation{4}) > 1);
  CHECK(std::fabs(fuzz::filter_margin(query, Separation{5})) <= 1);
  CHECK(fuzz::filter_margin(query, Separation{6}) < -1);
}

TEST_CASE("fuzzing curves: solvers that do not take them are refused") {
  const fuzz::Settings settings = curved_settings(100);
  CHECK_THROWS_AS(fuzz::run(named("paper"), settings), InvalidQuery);
  CHECK_THROWS_AS(fuzz::run(named("redon"), fuzz::Settings{}), InvalidQuery);
  fuzz::Settings given;
  given.given = {CurvedQuery()};
  CHECK_THROWS_AS(fuzz::run(named("newton"), given), InvalidQuery);
  given.given = {Query()};
  CHECK_THROWS_AS(fuzz::run(named("redon"), given), InvalidQuery);
}

/// The families whose numbers have about one magnitude. With a separation the exact level takes up to a second for the
/// others.
std::vector<families::Family> families_of_one_scale() {
  std::vector<families::Family> all;
  for (const families::FamilyInfo& family : families::curved_families()) {
    const bool other = family.family == families::Family::long_quaternion ||
                       family.family == families::Family::curved_scale || family.family == families::Family::large_turn;
    if (!other) all.push_back(family.family);
  }
  return all;
}

TEST_CASE("fuzzing curves: ours hold against each other with separations, one for all or of each query's own") {
  const auto name = GENERATE("touchstone", "batch");
  const Metric metric = GENERATE(Metric::euclidean, Metric::max);
  CAPTURE(name, name_of(metric));
  fuzz::Settings settings = curved_settings(320);
  settings.families = families_of_one_scale();
  settings.separation = {0.75, metric};
  settings.own_separations = GENERATE(false, true);
  const fuzz::SearchOutcome outcome =
      fuzz::run([&] { return fuzz::named_solver(name, settings.separation); }, settings);
  CAPTURE(text_of(outcome));
  CHECK(outcome.kinds_of_failure == 0);
  if (!whole_effort("that every family has cases")) return;
  for (const families::Family family : settings.families) {
    INFO(families::info(family).name);
    CHECK(outcome.table.of(family).cases > 0);
  }
}

/// Gives the exact answer for the first distance, whatever distance it is told later.
class ForgetfulSolver final : public fuzz::AnsweringSolver {
 public:
  const std::string& name() const override { return name_; }
  bool supports(Kind) const override { return true; }
  bool takes_curves() const override { return true; }
  Answer answer(const Query& query) override { return solve(query, {.separation = Separation{1}}); }
  fuzz::Reply ask(const Query&) override { return {}; }
  Answer answer_curved(const CurvedQuery& query, double t_max) override {
    return solve(query, {.t_max = t_max, .separation = Separation{1}});
  }

 private:
  std::string name_ = "forgetful";
};

TEST_CASE("fuzzing curves: a solver that is wrong about separations is found out, and its findings keep theirs") {
  fuzz::Settings settings = curved_settings(300);
  settings.families = families_of_one_scale();
  settings.separation = {1, Metric::euclidean};
  settings.own_separations = true;
  settings.shrink_tries = 100;
  settings.most_findings = 4;
  const fuzz::SearchOutcome outcome = fuzz::run([] { return std::make_unique<ForgetfulSolver>(); }, settings);
  CHECK(outcome.table.total().failed() > 0);
  for (const fuzz::Finding& finding : outcome.findings) {
    const fuzz::Asked asked = fuzz::asked_in_case(finding.example.name, fuzz::case_source(settings));
    CHECK(asked.separation.distance == finding.example.separation.distance);
    CHECK(finding.example.separation.distance != 1);
  }
}

TEST_CASE("fuzzing curves: a query as text") {
  CurvedQuery query;
  query.kind = Kind::point_edge;
  query.motions[1].q1 = {0, 0.5, 0, 0};
  query.motions[1].p0 = query.motions[1].p1 = {1, 2, 3};
  query.corners = {CurvedCorner::on_body(1, {0.1, 0, 0}), CurvedCorner::on_curve({{0, 1, 0}}),
                   CurvedCorner::on_curve({{0, 1, 0}, {2, 1, 0}})};
  CHECK(fuzz::corners_text(query, " ") ==
        " p   body 1 (0.1, 0, 0)\n e0  at rest (0, 1, 0)\n e1  curve (0, 1, 0) (2, 1, 0)\n"
        " body 1: q (1, 0, 0, 0) -> (0, 0.5, 0, 0), p (1, 2, 3)\n");
}

}  // namespace
}  // namespace touchstone::tests
