// touchstone fuzz with curved queries: files of findings, queries of files, separations.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "fuzz/printed.hpp"
#include "support/catch.hpp"

using namespace touchstone::tests;

namespace {

/// The query files below a folder, in order.
std::vector<std::string> files_in(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

Run fuzz(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "fuzz");
  return run_program(arguments);
}

Run with_files(std::vector<std::string> arguments, const std::vector<std::string>& files) {
  arguments.insert(arguments.end(), files.begin(), files.end());
  return run_program(arguments);
}

void check_refused(const std::vector<std::string>& arguments, const std::string& part) {
  const Run run = fuzz(arguments);
  CAPTURE(arguments, run.out, run.err);
  CHECK(run.status == 2);
  CHECK(run.out == "");
  CHECK(occurrences(run.err, "\n") == 1);
  CHECK(occurrences(run.err, part) == 1);
}

/// Two turning tips beside a wall: one meets it at t = 1/2, the other's wall is behind it.
const std::string kTips =
    "touchstone-curved,1\n"
    "query,1\nmotion,0,1,0,0,0,1,0,0,1,0,0,0,0,0,0\nbody,0,5,0,0\ncurve,2,4,0\ncurve,4,4,-1\ncurve,4,4,1\n"
    "query,0\nmotion,2,1,0,0,0,1,0,0,1,0,0,0,0,0,0\nbody,2,5,0,0\ncurve,-2,-4,0\ncurve,-4,-4,-1\ncurve,-4,-4,1\n";

}  // namespace

TEST_CASE("findings about curved queries are files that certify, explain and fuzz read", "[slow]") {
  const auto solver = GENERATE("redon", "curved_advancement");
  CAPTURE(solver);
  const TemporaryFolder folder;
  const std::string out = folder.path("out");
  const Run run = fuzz({"--curved", "--solver", solver, "--cases", "700", "--findings", "5", "--threads", "1", "--out",
                        out, "--html", folder.path("page.html")});
  CAPTURE(run.out, run.err);
  REQUIRE(run.status == 1);
  CHECK(run.err == "");
  const std::vector<std::string> files = files_in(out);
  REQUIRE(!files.empty());
  std::size_t queries = 0;
  for (const std::string& file : files) {
    CHECK(std::filesystem::path(file).filename().string().rfind("curved_", 0) == 0);
    queries += occurrences(folder.read(std::filesystem::relative(file, folder.path("")).string()), "\nquery,");
  }
  CHECK(queries == lines_with(run.out, "   claim: ").size());

  const Run certified = with_files({"certify"}, files);
  CAPTURE(certified.out);
  CHECK(certified.status == 0);
  CHECK(occurrences(certified.out, "all " + std::to_string(queries) + " claim") == 1);
  const auto explanations = lines_with(run.out, "touchstone explain ");
  CHECK(explanations.size() == queries);
  for (const auto& command : explanations) CHECK(run_program(arguments_of(command)).status == 0);
  const auto cases = lines_with(run.out, "touchstone fuzz --solver");
  CHECK(cases.size() == queries);
  for (const auto& command : cases) CHECK(run_program(arguments_of(command)).status == 1);

  CHECK(with_files({"fuzz", "--solver", "touchstone", "--climb", "3", "--from"}, files).status == 0);
  const Run again = with_files({"fuzz", "--solver", solver, "--threads", "1", "--findings", "2", "--from"}, files);
  CAPTURE(again.out);
  CHECK(again.status == 1);
  for (const auto& command : lines_with(again.out, "--case 'given ")) {
    CHECK(run_program(arguments_of(command)).status == 1);
  }
  check_refused({"--solver", solver, "--from", files.front(), "--out", out}, "give --out another folder");
}

TEST_CASE("curved and straight queries of files are asked together") {
  const TemporaryFolder folder;
  const std::string tips = folder.write("vertex-face/tips.csv", kTips);
  const Run both = fuzz({"--from", tips, "bundled/point-point/misses.csv", "--climb", "2", "--threads", "1"});
  CAPTURE(both.out, both.err);
  CHECK(both.status == 0);
  CHECK(occurrences(both.out, "\nnothing found\n") == 1);
  const Run alone = fuzz({"--from", tips, "--solver", "batch", "--judge", "oracle", "--threads", "1"});
  CHECK(alone.status == 0);
  CHECK(occurrences(alone.out, "seed 1: 2 queries in ") == 1);
}

TEST_CASE("curved queries are asked about separations: of families, each of its own, and of files", "[slow]") {
  const TemporaryFolder folder;
  const std::string tips = folder.write("vertex-face/tips.csv", kTips);
  const auto check_right = [](const std::vector<std::string>& arguments, const std::string& about) {
    const Run run = fuzz(arguments);
    CAPTURE(run.out, run.err);
    CHECK(run.status == 0);
    CHECK(occurrences(run.out, about) == 1);
  };
  check_right({"--curved", "--cases", "88", "--separation", "0.25"}, "separation 0x1p-2 (0.25), euclidean");
  check_right({"--curved", "--cases", "44", "--separation", "each", "--metric", "max", "--climb", "1"},
              "each with a separation of its own, max");
  check_right({"--from", tips, "--separation", "2", "--climb", "5"}, "separation 0x1p+1 (2), euclidean");
  const std::string a_case = "gears edge-edge 1 4";
  check_right({"--separation", "each", "--case", a_case}, a_case + ": touchstone is right\n");
}

TEST_CASE("solvers and options that do not go with curved queries are refused") {
  const TemporaryFolder folder;
  const std::string tips = folder.write("vertex-face/tips.csv", kTips);
  check_refused({"--curved", "--solver", "newton", "--cases", "10"}, "newton takes no curved queries");
  check_refused({"--from", tips, "--solver", "newton"}, "newton takes no curved queries");
  check_refused({"--from", "bundled/edge-edge/misses.csv", "--solver", "redon"}, "redon takes curved queries only");
  check_refused({"--curved", "--solver", "redon", "--separation", "1"}, "'redon' is no solver for separation ");
  check_refused({"--curved", "--from", tips}, "--from");
  check_refused({"--from", tips, "--separation", "each"}, "not with --from");
}
