// The engine finds planted failures and counts them. Its result is the same for any number of threads.
// SPDX-License-Identifier: MIT
#include "fuzz/engine.hpp"

#include <chrono>
#include <set>
#include <sstream>
#include <thread>

#include <touchstone/error.hpp>

#include "fuzz/named_solvers.hpp"
#include "fuzz/run_case.hpp"
#include "fuzz/toys.hpp"
#include "support/catch.hpp"
#include "support/query_text.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;
using fuzz::FailureClass;
using fuzz::Reply;

namespace {

fuzz::Settings lattice_settings(std::uint64_t cases = 8000) {
  fuzz::Settings settings;
  settings.families = {families::Family::lattice2, families::Family::at_end};
  settings.cases = cases;
  settings.shrink_tries = 500;
  return settings;
}

std::uint64_t failures(const fuzz::SearchOutcome& outcome, FailureClass failure) {
  return outcome.table.total().failures[fuzz::FailureTable::index(failure)];
}

/// All results of a run except its time.
std::string text_of(const fuzz::SearchOutcome& outcome) {
  std::ostringstream text;
  text << outcome.queries << ' ' << outcome.kinds_of_failure << '\n';
  for (const families::FamilyInfo& family : families::all_families()) {
    const auto& row = outcome.table.of(family.family);
    text << row.cases << ':';
    for (const auto count : row.failures) text << ' ' << count;
    text << '\n';
  }
  for (const fuzz::Finding& finding : outcome.findings) {
    text << name_of(finding.failure) << ' ' << fuzz::degeneracy_text(finding.degeneracy) << ' ' << finding.count << ' '
         << fuzz::case_text(finding.example.name) << ' ' << cpp_initializer(std::get<Query>(finding.example.query))
         << '\n';
  }
  return text.str();
}

struct Planted {
  FailureClass failure;
  void (*spoil)(const Query&, Reply&);
};

void deny(const Query& query, Reply& reply) {
  if (strikes(query)) reply = Reply{};
}
void invent(const Query& query, Reply& reply) {
  if (strikes(query) && !reply.contact) reply.contact = true;
}
void delay(const Query& query, Reply& reply) {
  if (strikes(query) && reply.toi) reply.toi = std::nextafter(*reply.toi, 2.0);
}
void hurry(const Query& query, Reply& reply) {
  if (strikes(query) && reply.toi) reply.toi = 0.5 * *reply.toi;
}
void lose(const Query& query, Reply& reply) {
  if (strikes(query) && reply.toi) reply.toi = std::numeric_limits<double>::quiet_NaN();
}
void throw_something(const Query& query, Reply&) {
  if (strikes(query)) throw std::runtime_error("out of cheese");
}
void babble(const Query& query, Reply& reply) {
  if (!strikes(query)) return;
  reply.state = Reply::State::malformed;
  reply.detail = "the line \"maybe\"";
}
void hang(const Query& query, Reply& reply) {  // as a solver in a child process reports it
  if (strikes(query)) reply.state = Reply::State::hung;
}

}  // namespace

TEST_CASE("a planted bug of every class is found, counted and kept through shrinking", "[slow]") {
  const Planted planted = GENERATE(Planted{FailureClass::missed, deny}, Planted{FailureClass::phantom, invent},
                                   Planted{FailureClass::late, delay}, Planted{FailureClass::early, hurry},
                                   Planted{FailureClass::nan, lose}, Planted{FailureClass::crash, throw_something},
                                   Planted{FailureClass::malformed, babble}, Planted{FailureClass::hang, hang});
  CAPTURE(name_of(planted.failure));
  fuzz::Settings settings = lattice_settings();
  settings.allowance.early.fraction = 0.01;
  const fuzz::SearchOutcome outcome = fuzz::run(toy(planted.spoil), settings);
  CHECK(outcome.queries == 8000);
  CHECK(failures(outcome, planted.failure) > 100);
  CHECK(failures(outcome, planted.failure) == outcome.table.total().failed());
  REQUIRE_FALSE(outcome.findings.empty());
  std::uint64_t counted = 0;
  std::set<fuzz::Degeneracy> kinds;
  const auto solver = toy(planted.spoil)();
  for (const fuzz::Finding& finding : outcome.findings) {
    counted += finding.count;
    CHECK(kinds.insert(finding.degeneracy).second);
    const auto& query = std::get<Query>(finding.example.query);
    const Answer truth = solve(query, {.method = Method::exact});
    const auto failure = fuzz::failure_of(query, solver->ask(query), truth, settings.allowance.early);
    REQUIRE(failure.has_value());
    CHECK(failure->failure == planted.failure);
    CHECK(failure->failure == finding.failure);
    CHECK(fuzz::degeneracy_of(query, truth) == finding.degeneracy);
    CHECK(strikes(query));
  }
  CHECK(counted == outcome.table.total().failed());
}

TEST_CASE("a solver that is right is found right") {
  const fuzz::SearchOutcome outcome = fuzz::run(toy([](const Query&, Reply&) {}), lattice_settings());
  CHECK(outcome.queries == 8000);
  CHECK(outcome.table.total().failed() == 0);
  CHECK(outcome.findings.empty());
}

TEST_CASE("one query in a thousand that is wrong is found") {
  const auto factory = toy([](const Query& query, Reply& reply) {
    if (query.kind == Kind::edge_edge && query.start[3].z == 2 && query.end[0].x == -2 && query.start[1].y == 0 &&
        query.end[2].y == 1 && reply.contact) {
      reply = Reply{};
    }
  });
  fuzz::Settings settings = lattice_settings(40'000);
  settings.families = {families::Family::lattice2};
  const fuzz::SearchOutcome outcome = fuzz::run(factory, settings);
  CHECK(outcome.table.total().failed() > 0);
  CHECK(outcome.table.total().failed() < 100);
  REQUIRE_FALSE(outcome.findings.empty());
  CHECK(outcome.findings.front().failure == FailureClass::missed);
}

TEST_CASE("of whole answers everything is compared") {
  const auto wrong = GENERATE(0, 1, 2, 3, 4, 5);
  CAPTURE(wrong);
  const auto spoil = [wrong](const Query& query, Answer& answer) {
    if (!answer.contact || !strikes(query)) return;
    switch (wrong) {
      case 0: answer.toi_upper = std::nextafter(answer.toi_upper, 2.0); break;
      case 1: answer.nature = answer.nature == Nature::crossing ? Nature::grazing : Nature::crossing; break;
      case 2: answer.feature_a = Feature::overlap; break;
      case 3: answer.feature_b = Feature::overlap; break;
      case 4: answer.weights_a[0] += 0x1p-48; break;
      default: answer.weights_b[1] -= 0x1p-48; break;
    }
  };
  const fuzz::SearchOutcome outcome =
      fuzz::run([spoil] { return std::make_unique<WholeToy>(spoil); }, lattice_settings());
  CHECK(failures(outcome, FailureClass::differs) > 100);
  CHECK(failures(outcome, FailureClass::differs) == outcome.table.total().failed());
  CHECK_FALSE(outcome.findings.front().example.detail.empty());
}

TEST_CASE("ours hold against each other in every family, with hill climbing and without", "[slow]") {
  const auto name = GENERATE("touchstone", "exact", "oracle", "fast-cgal", "batch");
  CAPTURE(name);
  fuzz::Settings settings;
  settings.climb = GENERATE(0u, 10u);
  const bool slow = std::string(name) == "oracle" || std::string(name) == "fast-cgal";
  settings.cases = slow ? (settings.climb > 0 ? 160 : 1600) : 32'000 / (settings.climb + 1);
  const fuzz::SearchOutcome outcome = fuzz::run([name] { return fuzz::named_solver(name); }, settings);
  CHECK(outcome.queries >= (slow ? 1500u : 30'000u));
  CHECK(text_of(outcome).find("differs") == std::string::npos);
  CHECK(outcome.table.total().failed() == 0);
  for (const families::FamilyInfo& family : families::all_families()) {
    CHECK((outcome.table.of(family.family).cases > 0) == (family.group != families::Group::separation));
  }
}

TEST_CASE("ours hold against each other with separations of their own, with hill climbing and without", "[slow]") {
  const auto name = GENERATE("touchstone", "oracle", "batch");
  const Metric metric = GENERATE(Metric::euclidean, Metric::max);
  CAPTURE(name, name_of(metric));
  fuzz::Settings settings;
  settings.own_separations = true;
  settings.separation = {1, metric};
  settings.climb = GENERATE(0u, 10u);
  const bool slow = std::string(name) == "oracle";
  settings.cases = (slow || TOUCHSTONE_SLOW_BUILD ? 208 : metric == Metric::max ? 416 : 2080);
  if (settings.climb > 0) settings.cases = *settings.cases / settings.climb;
  const fuzz::SearchOutcome outcome =
      fuzz::run([&] { return fuzz::named_solver(name, settings.separation); }, settings);
  CAPTURE(text_of(outcome));
  CHECK(outcome.queries >= 200);
  CHECK(outcome.table.total().failed() == 0);
  for (const families::FamilyInfo& family : families::all_families()) {
    if (settings.climb == 0) CHECK(outcome.table.of(family.family).cases > 0);
  }
}

TEST_CASE("a solver that keeps the first separation is found out") {
  class Forgetful final : public fuzz::SolverUnderTest {
   public:
    const std::string& name() const override { return name_; }
    bool supports(Kind) const override { return true; }
    Reply ask(const Query& query) override {
      const Answer answer = solve(query, {.separation = Separation{1, Metric::euclidean}});
      Reply reply;
      reply.contact = answer.contact;
      if (answer.contact) reply.toi = answer.toi;
      return reply;
    }

   private:
    std::string name_ = "forgetful";
  };
  fuzz::Settings settings;
  settings.own_separations = true;
  settings.separation.distance = 1;
  settings.families = {families::Family::gap_crossing};
  settings.cases = 400;
  settings.shrink_tries = 200;
  const fuzz::SearchOutcome outcome = fuzz::run([] { return std::make_unique<Forgetful>(); }, settings);
  CHECK(failures(outcome, FailureClass::missed) > 10);
  CHECK(failures(outcome, FailureClass::phantom) + failures(outcome, FailureClass::late) > 10);
  for (const fuzz::Finding& finding : outcome.findings) {
    const fuzz::Asked asked = fuzz::asked_in_case(finding.example.name, fuzz::case_source(settings));
    CHECK(asked.separation.distance == finding.example.separation.distance);
    CHECK(finding.example.separation.distance != 1);
  }
}

TEST_CASE("every judge judges alike") {
  fuzz::Settings settings = lattice_settings(2000);
  settings.shrink_tries = 0;
  std::string first;
  for (const Method judge : {Method::exact, Method::fast, Method::oracle, Method::fast_cgal}) {
    settings.judge = judge;
    const std::string text = text_of(fuzz::run([] { return fuzz::named_solver("paper"); }, settings));
    if (first.empty()) first = text;
    CHECK(text == first);
  }
  CHECK(first.find("missed") != std::string::npos);
}

TEST_CASE("the outcome does not depend on the number of threads", "[slow]") {
  fuzz::Settings settings;
  settings.cases = 20'011;
  settings.climb = GENERATE(0u, 1u);
  settings.shrink_tries = 300;
  settings.most_findings = 12;
  const auto run_on = [&](int threads) {
    settings.threads = threads;
    return text_of(fuzz::run([] { return fuzz::named_solver("closed_form"); }, settings));
  };
  const std::string one = run_on(1);
  CHECK(one.find("late") != std::string::npos);
  CHECK(run_on(2) == one);
  CHECK(run_on(7) == one);
}

TEST_CASE("another seed makes other queries") {
  fuzz::Settings settings = lattice_settings(2000);
  settings.shrink_tries = 0;
  const auto run_with = [&](std::uint64_t seed) {
    settings.seed = seed;
    return text_of(fuzz::run([] { return fuzz::named_solver("paper"); }, settings));
  };
  CHECK(run_with(1) == run_with(1));
  CHECK(run_with(1) != run_with(2));
}

TEST_CASE("a case alone shows the finding that the run kept", "[slow]") {
  fuzz::Settings settings = lattice_settings(4000);
  settings.climb = 2;
  settings.families.clear();
  const auto factory = [] { return fuzz::named_solver("paper"); };
  const fuzz::SearchOutcome outcome = fuzz::run(factory, settings);
  REQUIRE(outcome.findings.size() > 10);
  for (const fuzz::Finding& finding : outcome.findings) {
    CAPTURE(fuzz::case_text(finding.example.name));
    const auto name = fuzz::parse_case_text(fuzz::case_text(finding.example.name));
    REQUIRE(name.has_value());
    const auto again = fuzz::run_case(*factory(), *name, settings).finding;
    REQUIRE(again.has_value());
    CHECK(again->failure == finding.failure);
    CHECK(again->degeneracy == finding.degeneracy);
    CHECK(again->example.difficulty == finding.example.difficulty);
  }
  CHECK_FALSE(
      fuzz::run_case(*toy([](const Query&, Reply&) {})(), outcome.findings.front().example.name, settings).finding);
}

TEST_CASE("the watch is told how far it is and can end the search") {
  fuzz::Settings settings;
  settings.threads = 2;
  std::uint64_t calls = 0, seen = 0;
  const fuzz::SearchOutcome outcome = fuzz::run([] { return fuzz::named_solver("paper"); }, settings,
                                                [&](const fuzz::Progress& progress) {
                                                  CHECK(progress.queries >= seen);
                                                  seen = progress.queries;
                                                  return ++calls < 3;
                                                });
  CHECK(outcome.stopped);
  CHECK(calls == 3);
  CHECK(outcome.queries >= seen);
  CHECK(outcome.table.total().cases == outcome.queries);
  CHECK(outcome.kinds_of_failure > 0);
}

TEST_CASE("a limit in seconds ends the search") {
  fuzz::Settings settings;
  settings.seconds = 0.2;
  const fuzz::SearchOutcome outcome = fuzz::run(toy([](const Query&, Reply&) {}), settings);
  CHECK_FALSE(outcome.stopped);
  CHECK(outcome.queries > 100);
  CHECK(outcome.seconds >= 0.2);
  CHECK(outcome.seconds < 5);
}

TEST_CASE("the time in which a solver starts does not count", "[slow]") {
  const auto quick = toy([](const Query&, Reply&) {});
  const auto slow = [&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(600));
    return quick();
  };
  fuzz::Settings settings;
  settings.seconds = 0.5;
  CHECK(fuzz::run(slow, settings).queries > 0);
}

TEST_CASE("of given queries the outcome says how many there are, how many were asked, and which cannot be") {
  const auto points_only = [] {
    return fuzz::callable_solver("points only", right_reply, [](Kind kind) { return kind == Kind::point_point; });
  };
  fuzz::Settings settings;
  settings.threads = 2;
  for (std::uint64_t i = 0; i < 6; ++i) {
    const Kind kind = i % 2 == 0 ? Kind::edge_edge : Kind::point_point;
    settings.given.push_back(families::make({families::Family::lattice1, kind, 1, i}));
  }
  const auto numbers = [](const fuzz::SearchOutcome& outcome) {
    return std::vector<std::uint64_t>{outcome.queries, outcome.given_asked, outcome.given, outcome.given_not_taken};
  };
  CHECK(numbers(fuzz::run(points_only, settings)) == std::vector<std::uint64_t>{3, 3, 6, 3});
  settings.cases = 2;
  CHECK(numbers(fuzz::run(points_only, settings)) == std::vector<std::uint64_t>{2, 2, 6, 3});
  settings.kinds = {Kind::point_point};
  CHECK(numbers(fuzz::run(points_only, settings)) == std::vector<std::uint64_t>{2, 2, 3, 0});
  settings.kinds = {Kind::vertex_face, Kind::point_point};
  settings.given = {settings.given[0]};
  CHECK_THROWS_AS(fuzz::run(points_only, settings), InvalidQuery);
  settings.kinds = {};
  CHECK_THROWS_AS(fuzz::run(points_only, settings), InvalidQuery);
}

TEST_CASE("kinds that a solver does not take are not asked, and none at all is an error") {
  const auto factory = [] {
    return fuzz::callable_solver(
        "points only",
        [](const Query& query) {
          CHECK(query.kind == Kind::point_point);
          return right_reply(query);
        },
        [](Kind kind) { return kind == Kind::point_point; });
  };
  fuzz::Settings settings = lattice_settings(500);
  CHECK(fuzz::run(factory, settings).queries == 500);
  settings.kinds = {Kind::edge_edge, Kind::vertex_face};
  CHECK_THROWS_AS(fuzz::run(factory, settings), InvalidQuery);
}

TEST_CASE("what goes wrong beside the solver reaches the caller") {
  const auto no_solver = []() -> std::unique_ptr<fuzz::SolverUnderTest> { throw std::runtime_error("no such thing"); };
  CHECK_THROWS_WITH(fuzz::run(no_solver, lattice_settings()), "no such thing");
}

TEST_CASE("a watch that throws ends the run") {
  const auto factory = [] { return fuzz::named_solver("paper"); };
  const auto watch = [](const fuzz::Progress&) -> bool { throw std::runtime_error("nobody looks"); };
  fuzz::Settings settings;
  settings.threads = 2;
  CHECK_THROWS_WITH(fuzz::run(factory, settings, watch), "nobody looks");
}
