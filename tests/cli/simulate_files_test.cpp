// The files of `touchstone simulate`: names that may be given together, files that cannot be written, and plots.
// SPDX-License-Identifier: MIT
#include <filesystem>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "io/sealed_json.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

namespace fs = std::filesystem;

std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of('\n');
  if (end == std::string::npos) return {};
  const std::size_t before = text.rfind('\n', end);
  return text.substr(before + 1, end - before);
}

}  // namespace

TEST_CASE("files that would take each other's place are refused before anything is written") {
  const TemporaryFolder folder;
  const std::string out = folder.path("out"), queries = folder.path("queries");
  const std::string scene = folder.path("scene.json"), state = folder.path("state.json");
  REQUIRE(run_program({"simulate", "two-edges", "--scene-out", scene}).status == 0);
  REQUIRE(run_program({"simulate", "two-edges", "--steps", "3", "--checkpoint", state}).status == 0);
  const std::string scene_text = folder.read("scene.json"), state_text = folder.read("state.json");
  fs::create_symlink(scene, folder.path("link"));
  const auto names = folder.names();

  const auto check_refused = [&](std::vector<std::string> arguments, const std::string& part) {
    arguments.insert(arguments.begin(), "simulate");
    const Run run = run_program(arguments);
    CAPTURE(arguments, run.err);
    CHECK(run.status == 2);
    CHECK(run.out == "");
    CHECK(occurrences(run.err, "\n") == 1);
    CHECK(occurrences(run.err, part) == 1);
    CHECK(folder.names() == names);
    CHECK(folder.read("scene.json") == scene_text);
    CHECK(folder.read("state.json") == state_text);
  };
  check_refused({"two-edges", "--proof", folder.path("x"), "--energies", folder.path("./y/../x")},
                "--proof and --energies name the same file, ");
  for (const char* name : {"energies.csv", "energies.svg", "frames/frames.vtk.series"}) {
    for (const std::string option : {"--proof", "--energies", "--checkpoint"}) {
      const std::string ending = std::filesystem::path(name).extension().string();
      const bool fits = ending == ".series" || (ending == ".csv" && option != "--checkpoint");
      check_refused(
          {"two-edges", "--out", out, option, out + "/" + name},
          option + (fits ? " and --out name the same file, " : ": " + out + "/" + name + " has the ending of "));
    }
  }
  check_refused({"two-edges", "--out", out, "--proof", out + "/frames/frame-000007.vtk"},
                "name it " + out + "/frames/frame-000007.csv");
  check_refused({"two-edges", "--out", out, "--proof", out}, "/out, which --out needs as a folder");
  check_refused({"two-edges", "--out", out, "--energies", out + "/frames"}, "/frames, which --out needs as a folder");
  for (const char* kind : {"edge-edge", "vertex-face", "point-edge", "point-point"}) {
    const std::string of_kind = queries + "/" + kind;
    check_refused({"two-edges", "--queries", queries, "--proof", of_kind + "/candidates.csv"},
                  "--proof and --queries name the same file, ");
    check_refused({"two-edges", "--queries", queries, "--proof", of_kind + "/candidates-0x1p-3.csv"},
                  "/candidates-0x1p-3.csv, which may be one of the files of --queries");
    check_refused({"two-edges", "--queries", queries, "--checkpoint", of_kind}, ", which --queries needs as a folder");
  }
  check_refused({"two-edges", "--queries", out + "/energies.csv", "--out", out},
                "--out names " + out + "/energies.csv, which --queries needs as a folder");
  check_refused({scene, "--scene-out", scene}, "--scene-out would write over ");
  check_refused({scene, "--proof", folder.path("link")}, "--proof would write over ");
  check_refused({"--resume", state, "--energies", state}, "--energies: " + state + " has the ending of another format");

  // Files that go well together.
  const Run run = run_program({"simulate", "--resume", state, "--checkpoint", state, "--out", out, "--queries", out,
                               "--proof", out + ".csv", "--steps", "2"});
  CAPTURE(run.err);
  CHECK(run.status == 0);
  CHECK(occurrences(folder.read("state.json"), "\"steps\": 5,") == 1);
}

TEST_CASE("options that would be without effect are refused") {
  const TemporaryFolder folder;
  const auto check_refused = [&](std::vector<std::string> arguments, const std::string& part) {
    arguments.insert(arguments.begin(), {"simulate", "two-edges"});
    const Run run = run_program(arguments);
    CAPTURE(arguments, run.err);
    CHECK(run.status == 2);
    CHECK(occurrences(run.err, part) == 1);
    CHECK(folder.names().empty());
  };
  const std::string x = folder.path("x");
  check_refused({"--explain", "--scene-out", x}, "excludes");
  for (const char* option : {"--out", "--proof", "--energies", "--queries", "--checkpoint"}) {
    check_refused({"--explain", option, x}, "excludes");
    check_refused({"--scene-out", folder.path("y"), option, x}, "excludes");
    check_refused({option, ""}, std::string(option) + ": the name is empty");
  }
  check_refused({"--explain", "--steps", "3"}, "excludes");
  check_refused({"--frame-every", "3"}, "--frame-every requires --out");
}

TEST_CASE("energies that are wanted elsewhere are in the folder as well") {
  const TemporaryFolder folder;
  const Run run = run_program({"simulate", "two-edges", "--steps", "4", "--out", folder.path("out"), "--energies",
                               folder.path("energies.csv")});
  CHECK(run.status == 0);
  CHECK(occurrences(folder.read("energies.csv"), "\n") == 6);
  CHECK(folder.read("out/energies.csv") == folder.read("energies.csv"));
  CHECK(occurrences(folder.read("out/energies.svg"), "class=\"line") == 18);  // 6 energies, 3 counts, and their legend
}

TEST_CASE("a file that cannot be written is not there, and keeps none of the others from being there") {
  const TemporaryFolder folder;
  const auto full = folder.full_device();
  if (!full) {
    skip("no device that is full can be made here: that needs root");
    return;
  }
  const auto check_rest = [&](const Run& run, const std::string& steps) {
    CAPTURE(run.err, run.out);
    CHECK(run.status == 2);
    CHECK(occurrences(run.err, "full: cannot be written: No space left on device\n") == 1);
    CHECK(occurrences(folder.read("state.json"), "\"steps\": " + steps + ",") == 1);
    CHECK(last_line(folder.read("energies.csv")).rfind(steps + ",", 0) == 0);
    CHECK(run_program({"simulate", "--resume", folder.path("state.json"), "--steps", "1"}).status == 0);
  };
  const std::vector<std::string> files = {
      "--energies", folder.path("energies.csv"), "--checkpoint", folder.path("state.json"), "--proof", *full};
  std::vector<std::string> arguments = {"simulate", "two-edges", "--steps", "20"};
  arguments.insert(arguments.end(), files.begin(), files.end());
  const Run at_the_end = run_program(arguments);
  check_rest(at_the_end, "20");
  CHECK(first_line(at_the_end.out) == "20 steps, 0 crossings");

  // In the middle of the run: the table is longer than the part of it that stays in memory.
  arguments[3] = "5000";
  const Run before_it = run_program(arguments);
  CHECK(before_it.out == "");
  const std::string last = last_line(folder.read("energies.csv"));
  const std::string steps = last.substr(0, last.find(','));
  CHECK(std::stoi(steps) > 100);
  CHECK(std::stoi(steps) < 5000);
  check_rest(before_it, steps);
}

TEST_CASE("memory that runs out while JSON is read ends with status 2, wherever it does", "[slow]") {
#if TOUCHSTONE_SANITIZED
  skip("sanitizers map terabytes: limits on memory are not tested");
#else
  const TemporaryFolder folder;
  std::string flat = "{\"touchstone_scene\": 1, \"particles\": [0", nested = flat.substr(0, flat.size() - 1);
  for (int i = 0; i < 1'000'000; ++i) flat += ",0";
  for (int i = 0; i < 200'000; ++i) nested += "{\"position\":[0,0,0]},";
  std::string deep = "{\"touchstone_scene\": 1, \"name\": " + std::string(1'000'000, '[');
  const std::string whole = deep + std::string(1'000'000, ']') + "}";
  int ran_out = 0;
  std::size_t run_number = 0;
  for (const std::string& text : {flat + "]}", nested + "0]}", deep, whole}) {
    for (const bool checkpoint : {false, true}) {
      const std::string file = folder.write("in.json", checkpoint ? io::sealed_json(text) : text);
      for (std::uint64_t mebibytes = 24; mebibytes <= 160; mebibytes += 16) {
        if (!runs_case(run_number++)) continue;
        RunOptions options;
        options.address_space = mebibytes << 20;
        std::vector<std::string> arguments = {"simulate", "--scene-out", folder.path("out.json")};
        if (checkpoint) arguments.push_back("--resume");
        arguments.push_back(file);
        const Run run = run_program(arguments, options);
        CAPTURE(text.substr(0, 50), checkpoint, mebibytes, run.err);
        if (run.status == 127) continue;  // too little for the loader to start the program
        CHECK(run.status == 2);
        CHECK(occurrences(run.err, "\n") == 1);
        ran_out += run.err == "touchstone: out of memory\n" || occurrences(run.err, "there is no memory for its ") == 1;
      }
    }
  }
  CHECK(ran_out > 0);
  if (whole_effort("that memory runs out in each phase of reading")) CHECK(ran_out >= 10);
#endif
}

TEST_CASE("a damaged checkpoint is refused by file and digest") {
  const TemporaryFolder folder;
  REQUIRE(run_program({"simulate", "two-edges", "--steps", "3", "--checkpoint", folder.path("a.json")}).status == 0);
  std::string text = folder.read("a.json");
  const std::size_t velocity = text.find("\"v\": [") + 14;
  text[velocity] = static_cast<char>(text[velocity] ^ 1);
  const Run run = run_program({"simulate", "--resume", folder.write("b.json", text), "--out", folder.path("out")});
  CAPTURE(run.err);
  CHECK(run.status == 2);
  CHECK(occurrences(run.err, "b.json: the checkpoint's digest does not match its content") == 1);
  CHECK(occurrences(run.err, "\n") == 1);
  CHECK(folder.names() == std::set<std::string>{"a.json", "b.json"});
}

TEST_CASE("a checkpoint that does not fit its scene is refused by file and key") {
  const TemporaryFolder folder;
  REQUIRE(run_program({"simulate", "two-edges", "--steps", "3", "--checkpoint", folder.path("a.json")}).status == 0);
  std::string text = folder.read("a.json");
  text.replace(text.find("\"steps\": 3"), 10, "\"steps\": 4");
  const std::string bad = folder.write("b.json", io::sealed_json("{" + text.substr(text.find('\n') + 1)));
  const Run run = run_program({"simulate", "--resume", bad, "--out", folder.path("out")});
  CAPTURE(run.err);
  CHECK(run.status == 2);
  CHECK(occurrences(run.err, "b.json: time: after 4 steps of ") == 1);
  CHECK(occurrences(run.err, "\n") == 1);
  CHECK(folder.names() == std::set<std::string>{"a.json", "b.json"});
}
