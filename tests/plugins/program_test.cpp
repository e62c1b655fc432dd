// `touchstone fuzz` with other people's solvers: the shipped examples are broken within seconds, and a crash is a
// finding.
// SPDX-License-Identifier: MIT
#include <string>

#include "cli/run_program.hpp"
#include "support/catch.hpp"

using namespace touchstone::tests;

TEST_CASE("the example plugin is broken, on every core, and its failures can be asked again") {
  const TemporaryFolder folder;
  const Run run = run_program({"fuzz", "--solver", TOUCHSTONE_EXAMPLE_PLUGIN, "--cases", "4000", "--threads", "2",
                               "--out", folder.path("broken")});
  CAPTURE(run.out, run.err);
  CHECK(run.status == 1);
  CHECK(occurrences(run.out, "missed") > 0);
  CHECK(occurrences(run.out, TOUCHSTONE_EXAMPLE_PLUGIN) > 1);
  CHECK(occurrences(run.out, "point-edge") == 0);
}

TEST_CASE("the example program is broken") {
  const Run run =
      run_program({"fuzz", "--solver-command", TOUCHSTONE_EXAMPLE_PROGRAM, "--cases", "1000", "--threads", "1"});
  CAPTURE(run.out, run.err);
  CHECK(run.status == 1);
  CHECK(occurrences(run.out, "missed") > 0);
  CHECK(occurrences(run.out, "--solver-command") > 0);
}

TEST_CASE("a plugin that crashes now and then is a finding, not the end of the run", "[slow]") {
  // Lattices of small integers hold every order that the bad plugin takes; a hang each time would take too long.
  const Run run = run_program({"fuzz", "--solver", TOUCHSTONE_BAD_PLUGIN, "--family", "lattice1", "--cases", "300",
                               "--limit", "0.5", "--threads", "1"});
  CAPTURE(run.out, run.err);
  CHECK(run.status == 1);
  CHECK(occurrences(run.out, "crash") > 0);
  CHECK(occurrences(run.out, "missed") > 0);  // it denies every contact otherwise
  CHECK(occurrences(run.out, "--limit 0.5") > 0);
}

TEST_CASE("a solver that is not there is bad usage") {
  const Run plugin = run_program({"fuzz", "--solver", "./nowhere.so", "--cases", "1"});
  CHECK(plugin.status == 2);
  CHECK(occurrences(plugin.err, "./nowhere.so: there is no such plugin") == 1);
  const Run program = run_program({"fuzz", "--solver-command", "/nowhere/solver", "--cases", "1"});
  CHECK(program.status == 2);
  CHECK(occurrences(program.err, "No such file or directory") == 1);
  CHECK(run_program({"fuzz", "--solver-command", "true", "--cases", "1"}).status == 2);
  CHECK(run_program({"fuzz", "--limit", "0", "--cases", "1"}).status == 2);
  CHECK(run_program({"fuzz", "--limit", "nan", "--cases", "1"}).status == 2);
}
