// touchstone mesh --resume: a run that is killed at any moment goes on, and its report is that of one run.
// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "io/sha256.hpp"
#include "seeded/rng.hpp"
#include "sequence/needle.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

/// A sequence, and the report of one run about it.
struct StoppedRun {
  TemporaryFolder folder;
  std::vector<std::string> files;
  std::string whole;
  std::string out;

  StoppedRun(std::size_t side, std::size_t frames) : files(write_needles(folder, "f", side, frames, falling_tip)) {
    const Run run = mesh({"--report", folder.path("whole.json")});
    REQUIRE(run.status == 1);
    whole = folder.read("whole.json");
    out = run.out;
  }

  Run mesh(std::vector<std::string> arguments, const RunOptions& options = {}) const {
    arguments.insert(arguments.begin(), "mesh");
    arguments.insert(arguments.end(), files.begin(), files.end());
    return run_program(arguments, options);
  }
  Run report(const std::vector<std::string>& more = {}, const RunOptions& options = {}) const {
    std::vector<std::string> arguments = {"--report", folder.path("r.json")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return mesh(arguments, options);
  }
  bool has(const std::string& name) const { return std::filesystem::exists(folder.path(name)); }

  /// Leaves the journal of a run that failed at the frame `broken`, which is whole again afterwards.
  void leave_journal(std::size_t broken) const {
    const std::string name = "f-" + std::to_string(broken) + ".obj", text = folder.read(name);
    folder.write(name, "nonsense\n");
    REQUIRE(report({"--threads", "1"}).status == 2);
    folder.write(name, text);
    REQUIRE(has("r.json.progress"));
    REQUIRE_FALSE(has("r.json"));
  }
};

std::size_t count_of_lines(const std::string& text) { return occurrences(text, "\n"); }

}  // namespace

TEST_CASE("a run that is killed at random moments, again and again, ends with the report of one run", "[slow]") {
  const StoppedRun sample(48, 24);
  const auto start = std::chrono::steady_clock::now();
  REQUIRE(sample.report().status == 1);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  REQUIRE(sample.folder.read("r.json") == sample.whole);
  seeded::Rng rng(20260115);
  int killed = 0, gone_on = 0;
  for (std::size_t round = 0; round < effort(6); ++round) {
    std::filesystem::remove(sample.folder.path("r.json"));
    for (int attempt = 0; attempt < 100; ++attempt) {
      RunOptions options;
      if (attempt < 4) options.kill_after = seconds * rng.uniform(0.02, 0.6);
      const bool journal = sample.has("r.json.progress");
      const Run run = sample.report({"--resume", "--threads", rng.one_in(2) ? "1" : "2"}, options);
      CAPTURE(run.err, run.status);
      if (run.status == 128 + 9) {
        ++killed;
        continue;
      }
      REQUIRE(run.status == 1);
      gone_on += journal ? 1 : 0;
      CHECK(run.out == sample.out);
      break;
    }
    CHECK(sample.folder.read("r.json") == sample.whole);
    CHECK_FALSE(sample.has("r.json.progress"));
  }
  if (!whole_effort("that a run was killed and went on")) return;
  CHECK(killed >= 6);
  CHECK(gone_on >= 1);
}

TEST_CASE("a run goes on where the earlier one stopped, wherever the journal is torn", "[slow]") {
  const StoppedRun sample(5, 8);
  sample.leave_journal(6);
  const std::string journal = sample.folder.read("r.json.progress");
  CHECK(count_of_lines(journal) >= 4);
  for (std::size_t cut = 0; cut <= journal.size(); cut += 53) {
    std::filesystem::remove(sample.folder.path("r.json"));
    sample.folder.write("r.json.progress", journal.substr(0, cut));
    const std::size_t lines = count_of_lines(journal.substr(0, cut));
    const Run run = sample.report({"--resume"});
    CAPTURE(cut, run.err);
    CHECK(run.status == 1);
    CHECK(run.out == sample.out);
    CHECK(occurrences(run.err, " of 8 results are those of ") == (lines > 1 ? 1 : 0));
    CHECK(sample.folder.read("r.json") == sample.whole);
    CHECK_FALSE(sample.has("r.json.progress"));
  }
}

TEST_CASE("a report that cannot be written is named as the command names it, and not its journal") {
  const StoppedRun sample(5, 8);
  const std::string report = sample.folder.path("no/r.json");
  CHECK(sample.mesh({"--report", report}).err.starts_with(report + ": cannot be written: No such file"));
}

TEST_CASE("finished steps are not checked again: their results are those of the journal") {
  const StoppedRun sample(5, 8);
  sample.leave_journal(6);
  const std::string journal = sample.folder.read("r.json.progress");
  CHECK(count_of_lines(journal) == 7);  // the heading, frame 0 and the steps up to 4 -> 5
  // A journal with a digest that is right, and a result that is not: it says that step 2 -> 3 is free.
  std::string forged;
  std::istringstream lines(journal);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find("\"result\":{\"from\":2,\"to\":3,\"free\":false");
    if (at != std::string::npos) {
      const std::string json = line.substr(17, at - 17) + "\"result\":{\"from\":2,\"to\":3,\"free\":true}}";
      line = io::sha256(json).substr(0, 16) + " " + json;
    }
    forged += line + "\n";
  }
  CHECK(forged.size() < journal.size());
  sample.folder.write("r.json.progress", forged);
  const Run run = sample.report({"--resume"});
  CHECK(run.status == 0);
  CHECK(lines_of(run.out).back().starts_with("7 steps, all free (28 vertices, "));
}

TEST_CASE("a frame that has changed since the earlier run is named") {
  const StoppedRun sample(5, 8);
  sample.leave_journal(6);
  const std::string journal = sample.folder.read("r.json.progress"), text = sample.folder.read("f-3.obj");
  sample.folder.write("f-3.obj", text + "# a comment\n");
  const Run run = sample.report({"--resume"});
  CHECK(run.status == 2);
  CHECK(occurrences(run.err, "f-3.obj: it has changed since " + sample.folder.path("r.json.progress")) == 1);
  CHECK(sample.folder.read("r.json.progress") == journal);
  sample.folder.write("f-3.obj", text);
  CHECK(sample.report({"--resume"}).status == 1);
  CHECK(sample.folder.read("r.json") == sample.whole);
}

TEST_CASE("without --resume the journal of an earlier run is refused, and nothing is lost") {
  const StoppedRun sample(5, 8);
  sample.leave_journal(6);
  const std::string journal = sample.folder.read("r.json.progress");
  const Run run = sample.report();
  CHECK(run.status == 2);
  CHECK(run.out == "");
  CHECK(occurrences(run.err,
                    "r.json.progress: is there: an earlier run with this report did not finish; --resume goes "
                    "on with it, or remove the file\n") == 1);
  const Run other = sample.report({"--resume", "--separation", "0.25"});
  CHECK(other.status == 2);
  CHECK(occurrences(other.err, "is about touching, euclidean, and this run about separation 0x1p-2, euclidean\n") == 1);
  CHECK(sample.folder.read("r.json.progress") == journal);
}

TEST_CASE("the option --resume starts without a journal, and with the finished report it is done") {
  const StoppedRun sample(5, 6);
  const Run first = sample.report({"--resume"});
  CHECK(first.status == 1);
  CHECK(first.err == "");
  const auto written = std::filesystem::last_write_time(sample.folder.path("r.json"));
  const Run again = sample.report({"--resume", "--pairs", sample.folder.path("p.csv")});
  CHECK(again.status == 1);
  CHECK(again.out == sample.out);
  CHECK(occurrences(again.err, "touchstone: 6 of 6 results are those of " + sample.folder.path("r.json\n")) == 1);
  CHECK(occurrences(sample.folder.read("p.csv"), ",first,") == 1);
  CHECK(std::filesystem::last_write_time(sample.folder.path("r.json")) == written);
  CHECK(sample.folder.read("r.json") == sample.whole);
  const Run other = sample.report({"--resume", "--separation", "0.25"});
  CHECK(other.status == 2);
  CHECK(occurrences(other.err, "r.json: is about touching, euclidean, and this run about separation 0x1p-2") == 1);
  CHECK_FALSE(sample.has("r.json.progress"));
  // Without --resume the report is made again.
  CHECK(sample.report({"--separation", "0.25"}).status == 1);
  CHECK(sample.folder.read("r.json") != sample.whole);
}

TEST_CASE("a report that goes to a pipe has no journal beside it") {
  const StoppedRun sample(5, 6);
  const std::string pipe = sample.folder.path("pipe");
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  const int reader = ::open(pipe.c_str(), O_RDWR | O_CLOEXEC);
  REQUIRE(reader >= 0);
  sample.folder.write("pipe.progress", "mine");
  const Run resumed = sample.mesh({"--report", pipe, "--resume"});
  CHECK(resumed.status == 2);
  CHECK(occurrences(resumed.err, "pipe is a pipe or device, and keeps nothing of an earlier run; name a file") == 1);
  CHECK(sample.mesh({"--report", pipe}).status == 1);
  CHECK(sample.folder.read("pipe.progress") == "mine");
  std::string text(sample.whole.size() + 1, '\0');
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, ::read(reader, text.data(), text.size()))));
  ::close(reader);
  CHECK(text == sample.whole);
}

TEST_CASE("query files and tables are whole after a run that went on") {
  const StoppedRun sample(5, 8);
  const auto files = [&](const std::string& name) {
    return std::vector<std::string>{"--pairs", sample.folder.path(name + ".csv"), "--queries",
                                    sample.folder.path(name)};
  };
  CHECK(sample.report(files("one")).status == 1);
  std::filesystem::remove(sample.folder.path("r.json"));
  sample.leave_journal(6);
  auto arguments = files("two");
  arguments.push_back("--resume");
  CHECK(sample.report(arguments).status == 1);
  CHECK(sample.folder.read("two.csv") == sample.folder.read("one.csv"));
  CHECK(sample.folder.read("two/vertex-face/contacts.csv") == sample.folder.read("one/vertex-face/contacts.csv"));
}

TEST_CASE("two processes cannot make one report at the same time") {
  const StoppedRun sample(5, 4);
  sample.folder.write("r.json.progress", "");
  const int held = ::open(sample.folder.path("r.json.progress").c_str(), O_RDWR | O_CLOEXEC);
  REQUIRE(::flock(held, LOCK_EX | LOCK_NB) == 0);
  const Run run = sample.report({"--resume"});
  CHECK(run.status == 2);
  CHECK(occurrences(run.err, "r.json.progress: is in use: another process is making this report\n") == 1);
  ::close(held);
  CHECK(sample.report({"--resume"}).status == 1);
}

TEST_CASE("Ctrl-C keeps what is finished") {
  const StoppedRun sample(48, 24);
  RunOptions options;
  options.interrupt_after = 0.15;
  const Run run = sample.report({"--threads", "1"}, options);
  if (run.status == 1) return;  // it was faster than the signal
  CHECK(run.status == 128 + 2);
  CHECK_FALSE(sample.has("r.json"));
  CHECK(sample.report({"--resume"}).status == 1);
  CHECK(sample.folder.read("r.json") == sample.whole);
}

TEST_CASE("Ctrl-C ends a step that takes long") {
  const TemporaryFolder folder;
  constexpr int kFaces = 4000;  // in each other's way: 4 million intersections
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::string soup;
  for (int i = 0; i < 3 * kFaces; ++i) {
    soup += "v";
    for (int k = 0; k < 3; ++k) soup += " " + std::to_string(coordinate(random));
    soup += "\n";
  }
  for (int i = 0; i < kFaces; ++i) {
    soup += "f";
    for (int k = 1; k <= 3; ++k) soup += " " + std::to_string(3 * i + k);
    soup += "\n";
  }
  RunOptions options;
  options.interrupt_after = 0.5;
  const Run run = mesh({"--check", "--threads", "1", folder.write("soup.obj", soup)}, options);
  CHECK(run.status == 128 + 2);
  CHECK(run.out == "");
}
