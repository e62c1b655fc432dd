// `touchstone fuzz-steps`: programs that are asked over pipes, and what is refused.
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
Run ask(const TemporaryFolder& folder, const std::string& reply, std::vector<std::string> more = {}) {
  const std::string program = folder.write("program.py",
                                           "import json, os, sys, time\n"
                                           "for line in sys.stdin:\n"
                                           "    step = json.loads(line)\n"
                                           "    print(" +
                                               reply + ", flush=True)\n");
  std::vector<std::string> words = {"fuzz-steps", "--solver-command", "python3 " + program, "--threads", "2"};
  words.insert(words.end(), more.begin(), more.end());
  return run_program(words);
}

}  // namespace

TEST_CASE("fuzz-steps: the library itself is right, and the verdict says what was left out") {
  const Run run = run_program({"fuzz-steps", "--cases", "65", "--no-separation", "--no-groups"});
  CAPTURE(run.out, run.err);
  CHECK(run.status == 0);
  CHECK(run.out ==
        "touchstone: 65 steps asked, 0 with a wrong reply; separations were left out; groups were left out\n"
        "nothing found\n");
}

TEST_CASE_WITH("python3", "fuzz-steps: touchstone mesh is right about steps that it reads from files") {
  const std::string program =
      std::string("python3 ") + TOUCHSTONE_SOURCE_DIR "/tests/fuzz/mesh_program.py " + TOUCHSTONE_PROGRAM;
  const Run run = run_program({"fuzz-steps", "--solver-command", program, "--cases", "130", "--no-groups", "--once"});
  CAPTURE(run.out, run.err);
  CHECK(run.status == 0);
  CHECK(occurrences(run.out, ": 130 steps asked, 0 with a wrong reply; groups were left out\nnothing found\n") == 1);
}

TEST_CASE("fuzz-steps: a program's finding is written as frames that mesh reads, and asked again by its name") {
  const TemporaryFolder folder;
  const std::string out = folder.path("out");
  const Run run =
      ask(folder, R"('{"free": 1, "first_contact": null}')", {"--cases", "26", "--out", out, "--no-groups"});
  CAPTURE(run.out, run.err);
  CHECK(run.status == 1);
  CHECK(occurrences(run.out, "26 steps asked, ") == 1);
  CHECK(occurrences(run.out, "1 kind of failure\n") == 1);
  CHECK(occurrences(run.out, "\nmissed ") == 1);
  CHECK(occurrences(run.out, "times, free: a step of 1 is longer than the way to the first contact: ") == 1);
  CHECK(occurrences(run.out, "  touchstone mesh") == 1);
  const std::string found = "  found as ";
  const std::size_t at = run.out.find(found) + found.size();
  const std::string name = run.out.substr(at, run.out.find('\n', at) - at);
  CHECK(occurrences(run.out, " --no-groups --case '" + name + "'\n") == 1);
  const Run again = ask(folder, R"('{"free": 1}')", {"--case", name, "--no-groups"});
  CHECK(again.status == 1);
  CHECK(occurrences(again.out, "1 step asked, 1 with a wrong reply") == 1);
  std::vector<std::string> words = {"mesh", out + "/free-missed-0.obj", out + "/free-missed-1.obj"};
  if (run.out.find("  separation ") == std::string::npos) CHECK(run_program(words).status == 1);
  CHECK(folder.read("out/free-missed.json").starts_with("{\"vertices\":"));
}

TEST_CASE("fuzz-steps: a program that ends, hangs, or says no reply is told so", "[slow]") {
  const TemporaryFolder folder;
  const auto found = [&](const std::string& reply, const std::string& words, std::vector<std::string> more) {
    more.insert(more.end(), {"--cases", "6"});
    const Run run = ask(folder, reply, more);
    CAPTURE(reply, run.out, run.err);
    CHECK(run.status == 1);
    CHECK(occurrences(run.out, words) == 1);
  };
  const std::vector<std::string> rods = {"--family", "steps_rods"};
  found("sys.exit(3)", ", all: exit status 3", rods);
  found("'no'", ", all: 'no' is no reply; a reply is such as {\"free\": 0.5}", rods);
  found(R"('{"free": 0.0001}\n{}')", ", all: it says more than it was asked", rods);
  found(R"(json.dumps({"free": 0.01 + 1e-9 * (time.time_ns() % 1000)}))", "differs ", {"--family", "steps_sheets"});
  // The first reply of a program has more time.
  found(R"(time.sleep(20) if globals().get("n") else globals().update(n=1) or '{"free": 0.0001}')",
        "no reply within 100 ms (a program must flush its replies)", {"--limit", "0.1", "--family", "steps_sheets"});
}

TEST_CASE("fuzz-steps: a program is asked once if that is wanted, and the command that repeats a finding says so") {
  const TemporaryFolder folder;
  const std::vector<std::string> once = {"--once", "--case", "steps_sheets 1 0"};
  CHECK(ask(folder, R"(json.dumps({"free": 0.01 + 1e-9 * (time.time_ns() % 1000)}))", once).status == 0);
  const Run wrong = ask(folder, R"('{"first_contact": -1}')", once);
  CAPTURE(wrong.out, wrong.err);
  CHECK(wrong.status == 1);
  CHECK(occurrences(wrong.out, " --once --case 'steps_sheets 1 0'\n") == 1);
}

TEST_CASE("fuzz-steps: what cannot be asked is refused") {
  const auto refused = [](std::vector<std::string> words, const std::string& reason) {
    words.insert(words.begin(), "fuzz-steps");
    const Run run = run_program(words);
    CAPTURE(run.out, run.err, reason);
    CHECK(run.status == 2);
    CHECK(run.out.empty());
    CHECK(occurrences(run.err, reason) == 1);
  };
  refused({"--solver-command", "./no-such-program"}, "cannot be started");
  refused({"--solver-command", " "}, "the command is empty");
  refused({"--family", "sheets"}, "sheets is no family");
  refused({"--case", "steps_rods 1"}, "is no case; it must be \"FAMILY SEED INDEX\"");
  refused({"--case", "steps_rods 1 1", "--seed", "2"}, "--seed excludes --case");
  refused({"--cases", "0"}, "must be");
  refused({"--early", "2"}, "2 must be in [0, 1]");
  refused({"--seconds", "0"}, "0 must be a number of seconds above 0");
  refused({"--cases", "5", "--seconds", "1"}, "give one of them");
}
