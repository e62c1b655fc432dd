// `touchstone fuzz-steps --bodies`: programs that are asked over pipes about whole bodies, and what is refused.
// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "io/temporary_folder.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace touchstone::tests;

namespace {

/// A program in Python that gives each line one reply; `reply` is an expression of `step`.
Run ask_about_bodies(const TemporaryFolder& folder, const std::string& reply, const std::vector<std::string>& more) {
  const std::string program = folder.write("program.py",
                                           "import json, os, sys, time\n"
                                           "for line in sys.stdin:\n"
                                           "    step = json.loads(line)\n"
                                           "    print(" +
                                               reply + ", flush=True)\n");
  std::vector<std::string> words = {"fuzz-steps",         "--bodies",  "--solver-command",
                                    "python3 " + program, "--threads", "2"};
  words.insert(words.end(), more.begin(), more.end());
  return run_program(words);
}

}  // namespace

TEST_CASE("fuzz-steps --bodies: the library itself is right, and the verdict says what was left out") {
  const Run run = run_program({"fuzz-steps", "--bodies", "--cases", "30", "--no-separation", "--no-groups"});
  CAPTURE(run.out, run.err);
  CHECK(run.status == 0);
  CHECK(run.out ==
        "touchstone: 30 steps asked, 0 with a wrong reply; separations and radii were left out; pairs of bodies that "
        "never collide were left out; intersections at the start were not asked about\nnothing found\n");
}

TEST_CASE_WITH("python3",
               "fuzz-steps --bodies: waypoints miss contacts, and the files of a finding are read by bodies") {
  const TemporaryFolder folder;
  const std::string program = std::string("python3 ") + TOUCHSTONE_SOURCE_DIR "/src/fuzz/examples/bodies.py";
  const Run run = run_program({"fuzz-steps", "--bodies", "--solver-command", program, "--cases", "12", "--family",
                               "bodies_quarter", "--once", "--no-separation", "--out", folder.path("out")});
  CAPTURE(run.out, run.err);
  CHECK(run.status == 1);
  CHECK(occurrences(run.out, "12 steps asked, ") == 1);
  const std::string found = "  found as ";
  const std::size_t at = run.out.find(found) + found.size();
  const std::string name = run.out.substr(at, run.out.find('\n', at) - at);
  CHECK(occurrences(run.out, " --bodies --solver-command '" + program + "' --no-separation --once --case '" + name +
                                 "'\n") == 1);
  const Run again =
      run_program({"fuzz-steps", "--bodies", "--solver-command", program, "--once", "--no-separation", "--case", name});
  CHECK(again.status == 1);
  CHECK(occurrences(again.out, "1 step asked, 1 with a wrong reply") == 1);
  const std::string kind = run.out.find("\nlate ") < run.out.find("\nmissed ") ? "late" : "missed";
  const std::string files = folder.path("out/free-" + kind);
  CHECK(occurrences(run.out, "  touchstone bodies " + files + "-0.obj " + files +
                                 "-1.obj --as-given --no-start "
                                 "--poses " +
                                 files + "-poses.csv --html step.html\n") == 1);
  const Run shown = run_program(
      {"bodies", files + "-0.obj", files + "-1.obj", "--as-given", "--no-start", "--poses", files + "-poses.csv"});
  CAPTURE(shown.out, shown.err);
  CHECK(shown.status == 1);
  CHECK(occurrences(shown.out, "1 step: 0 free, 1 not free") == 1);
  CHECK(folder.read("out/free-" + kind + ".json").starts_with("{\"bodies\":[{\"points\":[["));
}

TEST_CASE_WITH("python3", "fuzz-steps --bodies: a program that ends, hangs, or says no reply is told so") {
  const TemporaryFolder folder;
  const auto found = [&](const std::string& reply, const std::string& words, std::vector<std::string> more = {}) {
    more.insert(more.end(), {"--case", "bodies_quarter 1 0"});
    const Run run = ask_about_bodies(folder, reply, more);
    CAPTURE(reply, run.out, run.err);
    CHECK(run.status == 1);
    CHECK(occurrences(run.out, words) == 1);
  };
  found("sys.exit(3)", ", all: exit status 3");
  found("'{\"free\": '", "is no reply; a reply is such as {\"free\": 0.5}");
  found(R"('{"candidates": [["edge-edge", [0, 3], [1, 99999999999]]]}')",
        "edge-edge [0, 3] [1, 4294967295] names an element that the bodies have not");
  found(R"('{"candidates": [["edge-edge", [0, 3], [2, 0]]]}')", "names an element that the bodies have not");
  found(R"(time.sleep(20) if globals().get("n") else globals().update(n=1) or '{"free": 0.002}')",
        "no reply within 100 ms (a program must flush its replies)", {"--limit", "0.1"});
}

TEST_CASE("fuzz-steps --bodies: families and cases are those of bodies") {
  const auto refused = [](std::vector<std::string> words, const std::string& reason) {
    words.insert(words.begin(), "fuzz-steps");
    const Run run = run_program(words);
    CAPTURE(run.out, run.err, reason);
    CHECK(run.status == 2);
    CHECK(run.out.empty());
    CHECK(occurrences(run.err, reason) == 1);
  };
  refused({"--bodies", "--family", "steps_rods"},
          "steps_rods is no family of bodies; see touchstone fuzz-steps --help");
  refused({"--family", "bodies_gears"}, "bodies_gears is no family; see");
  refused({"--bodies", "--case", "steps_rods 1 1"}, "steps_rods 1 1 is no case");
  refused({"--case", "bodies_gears 1 1"}, "bodies_gears 1 1 is no case");
  refused({"--bodies", "--solver-command", "./no-such-program"}, "cannot be started");
}
