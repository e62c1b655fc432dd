// A run that is cancelled in the middle of a step: the check is called often, and the state is unchanged.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <stdexcept>

#include "scene/shipped_scenes.hpp"
#include "sim/checkpoint.hpp"
#include "sim/simulation.hpp"
#include "support/catch.hpp"

using namespace touchstone::sim;

TEST_CASE("a check that throws inside a step leaves the state of the last complete step") {
  constexpr int kNever = 1'000'000'000;
  struct Case {
    const char* scene;
    Index size;
    int steps;    // before the one that is cancelled
    bool solves;  // whether that one has contacts in its potential
  };
  const Case given = GENERATE(Case{"cable-drop", 80, 7, false}, Case{"hoop", 200, 30, true});
  CAPTURE(given.scene);
  int twin_checks = 0;
  SimulationOptions counting;
  counting.check_cancelled = [&] { ++twin_checks; };
  Simulation twin(make_shipped_scene(given.scene, given.size), counting);
  int checks = 0, last = kNever;  // the last check that lets the run go on
  SimulationOptions throwing;
  throwing.check_cancelled = [&] {
    if (++checks > last) throw std::runtime_error("enough");
  };
  Simulation simulation(make_shipped_scene(given.scene, given.size), throwing);
  for (int step = 0; step < given.steps; ++step) {
    simulation.step();
    twin.step();
  }
  const std::string before = checkpoint_to_json(simulation);
  REQUIRE((before == checkpoint_to_json(twin)));

  twin_checks = 0;
  int iterations = 0, solves = 0;
  for (const SubstepRecord& record : twin.step()) {
    iterations += record.newton_iterations;
    solves += record.response.solves;
  }
  if (given.solves) CHECK(solves > 0);
  CHECK(twin_checks > iterations);  // at least one in each iteration, and others in the passes over contacts

  const int stride = std::max(1, twin_checks / 20);
  for (last = 0; last < twin_checks; last += stride) {
    CAPTURE(last, twin_checks);
    checks = 0;
    CHECK_THROWS_WITH(simulation.step(), "enough");
    CHECK(checks == last + 1);
    CHECK((checkpoint_to_json(simulation) == before));
    CHECK(simulation.steps() == static_cast<std::uint64_t>(given.steps));
  }
  last = kNever;
  simulation.step();
  CHECK((checkpoint_to_json(simulation) == checkpoint_to_json(twin)));
}
