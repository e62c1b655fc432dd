// `touchstone fuzz-steps --solver`: plugins that are asked about whole steps, good and bad.
// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "support/catch.hpp"

using namespace touchstone::tests;

namespace {

Run ask(const std::string& plugin, std::vector<std::string> more = {}, const std::string& what = "") {
  std::vector<std::string> words = {"fuzz-steps", "--solver", plugin, "--cases", "26", "--threads", "2"};
  words.insert(words.end(), more.begin(), more.end());
  ::setenv("BAD_STEPS", what.c_str(), 1);
  return run_program(words);
}

}  // namespace

TEST_CASE("a plugin's broad phase of the start is found, as that of the same program in Python is") {
  const Run run = ask(TOUCHSTONE_STEP_PLUGIN, {"--no-groups"});
  CAPTURE(run.out, run.err);
  CHECK(run.status == 1);
  CHECK(run.out.starts_with(TOUCHSTONE_STEP_PLUGIN ": 26 steps asked, "));
  CHECK(occurrences(run.out, "1 kind of failure\n") == 1);
  CHECK(occurrences(run.out, "times, candidates: ") == 1);
  CHECK(occurrences(run.out, "  touchstone fuzz-steps --solver ") == 1);
  const std::string name = run.out.substr(run.out.find("--case ") + 8);
  const Run again = run_program(
      {"fuzz-steps", "--solver", TOUCHSTONE_STEP_PLUGIN, "--no-groups", "--case", name.substr(0, name.find('\''))});
  CHECK(again.status == 1);
}

TEST_CASE("plugins that misbehave about steps are told so") {
  const auto found = [](const std::string& what, const std::string& words) {
    const Run run = ask(TOUCHSTONE_BAD_STEPS, {}, what);
    CAPTURE(what, run.out, run.err);
    CHECK(run.status == 1);
    CHECK(occurrences(run.out, words) >= 1);
  };
  found("says nothing", ": it says nothing: neither free, nor first_contact, nor has_candidates");
  found("refuses", "exit status 1: its touchstone_ask_step returned 3");
  found("crashes", "signal 6");
  found("leaves", "exit status 0");
  found("no kind", ": it adds a candidate of the kind 7, which is none of touchstone_kind");
  found("a kind beyond a byte", ": it adds a candidate of the kind 256, which is none of touchstone_kind");
  found("hidden candidates", ": it adds candidates, and has_candidates is 0");
  // These two return a number above 0 where they do not find what is promised.
  for (const char* what : {"reads its input", "no step"}) {
    found(what, ": a stall");
    CHECK(occurrences(ask(TOUCHSTONE_BAD_STEPS, {}, what).out, "returned") == 0);
  }
  found("an endless step", ": a time is infinite");
}

TEST_CASE("a file that is no plugin about steps is refused before the search") {
  const auto refused = [](const std::string& path, const std::string& words) {
    const Run run = ask(path);
    CAPTURE(path, run.out, run.err);
    CHECK(run.status == 2);
    CHECK(run.out.empty());
    CHECK(occurrences(run.err, words) == 1);
  };
  refused("/nowhere.so", "/nowhere.so: there is no such plugin");
  refused("/", "/: is a folder, not a plugin");
  refused(TOUCHSTONE_EXAMPLE_PLUGIN,
          "the plugin cannot be used: exit status 1: it has no function touchstone_ask_step");
  refused(TOUCHSTONE_PROGRAM, "the plugin cannot be used: exit status 1: ");
  const Run bodies = ask(TOUCHSTONE_STEP_PLUGIN, {"--bodies"});
  CHECK(bodies.status == 2);
  CHECK(occurrences(bodies.err, "--solver is for steps of a mesh") == 1);
  CHECK(ask(TOUCHSTONE_STEP_PLUGIN, {"--solver-command", "cat"}).status == 2);
}
