// The pages that the program writes, and what it says of wrong input.
// SPDX-License-Identifier: MIT
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "support/catch.hpp"

using namespace touchstone::tests;

namespace {

constexpr const char* kQuery =
    "-1,1,0,1,0,1,1\n1,1,0,1,0,1,1\n0,1,-1,1,1,1,1\n0,1,1,1,1,1,1\n"
    "-1,1,0,1,0,1,1\n1,1,0,1,0,1,1\n0,1,-1,1,-2,1,1\n0,1,1,1,-2,1,1\n";

std::string text_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void check_refused(const std::vector<std::string>& arguments, const std::string& reason) {
  const Run run = run_program(arguments);
  CAPTURE(run.out, run.err, reason);
  CHECK(run.status == 2);
  CHECK(run.out == "");
  CHECK(occurrences(run.err, reason) == 1);
  CHECK(occurrences(run.err, "\n") == 1);
}

}  // namespace

TEST_CASE("view and explain write the same page, and standard output takes it too") {
  const TemporaryFolder folder;
  const std::string file = folder.write("edge-edge/a.csv", kQuery);
  const std::string page = folder.path("page.html"), other = folder.path("other.html");
  const Run view = run_program({"view", "--query", "0", "--out", page, file});
  CHECK(view.status == 0);
  CHECK(view.err == "");
  CHECK(occurrences(view.out, " in " + page + ", ") == 1);
  const Run explain = run_program({"explain", "--query", "0", "--html", other, file});
  CHECK(explain.status == 0);
  CHECK(explain.out == run_program({"explain", "--query", "0", file}).out);
  const std::string text = text_of(page);
  CHECK(text.size() > 10000);
  CHECK(text == text_of(other));
  CHECK(text == run_program({"view", "--query", "0", "--out", "-", file}).out);
  CHECK(occurrences(text, "they touch") == 1);
}

TEST_CASE("what view cannot show is refused, and leaves no file") {
  const TemporaryFolder folder;
  const std::string file = folder.write("edge-edge/a.csv", kQuery), empty = folder.write("edge-edge/empty.csv", "");
  const std::string page = folder.path("page.html");
  check_refused({"view", "--query", "1", "--out", page, file}, "has no query 1; it has 1 query, counted from 0");
  check_refused({"view", "--query", "0", "--out", page, empty}, "empty.csv: holds no query");
  check_refused({"view", "--query", "0", "--out", folder.path("none/page.html"), file}, "none/page.html");
  check_refused({"view", "--query", "0", "--out", file, file}, "a.csv");
  check_refused({"view", "--query", "0", file}, "--out");
  check_refused({"view", "--query", "0", "--out", "", file}, "--out");
  check_refused({"explain", "--query", "0", "--html", "-", file}, "--html");
  check_refused({"fuzz", "--solver", "paper", "--cases", "10", "--html", folder.path("none/p.html")}, "none/p.html");
  CHECK(!std::filesystem::exists(page));
  CHECK(text_of(file) == kQuery);
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path("."))) {
    if (entry.is_regular_file()) ++files;
  }
  CHECK(files == 2);  // no temporary file stays
}

TEST_CASE("simulate writes its page whole, also when a run ends early, and refuses names that do not fit") {
  const TemporaryFolder folder;
  const std::string page = folder.path("page.html");
  const Run run = run_program({"simulate", "two-edges", "--steps", "40", "--html", page});
  CHECK(run.status == 0);
  const std::string text = text_of(page);
  CHECK(occurrences(run.out, "animation in " + page + ", ") == 1);
  CHECK(occurrences(text, "id=\"frame-40\"") == 1);
  CHECK(occurrences(text, "id=\"frame-41\"") == 0);
  CHECK(occurrences(text, "40 steps, 0 crossings") == 1);
  for (const char* threads : {"1", "4"}) {
    CHECK(run_program({"simulate", "two-edges", "--steps", "40", "--threads", threads, "--html", page}).status == 0);
    CHECK((text_of(page) == text));
  }
  CHECK(occurrences(text, "</html>") == 1);
  check_refused({"simulate", "two-edges", "--html", "-"}, "--html");
  check_refused({"simulate", "two-edges", "--html", ""}, "--html");
  const std::string both = folder.path("both");
  check_refused({"simulate", "two-edges", "--html", both, "--energies", both}, "--html");
  check_refused({"simulate", "two-edges", "--html", folder.path("none/p.html")}, "none/p.html");
  CHECK(text_of(page) == text);

  // Held particles that are driven into each other: no step is possible any more.
  const std::string stuck = folder.write("stuck.json", R"({"touchstone_scene": 1, "particles": [
      {"position": [-1, 0, 0], "pinned": true}, {"position": [1, 0, 0], "pinned": true},
      {"position": [0, -1, 1], "path": [{"time": 0, "position": [0, -1, 1]}, {"time": 1, "position": [0, -1, -1]}]},
      {"position": [0, 1, 1], "path": [{"time": 0, "position": [0, 1, 1]}, {"time": 1, "position": [0, 1, -1]}]}],
      "wires": [[0, 1], [2, 3]], "settings": {"time_step": 0.1}})");
  const Run early = run_program({"simulate", stuck, "--html", page});
  CHECK(early.status == 2);
  CHECK(occurrences(text_of(page), "The run ended early, after step ") == 1);
  CHECK(occurrences(text_of(page), "id=\"frame-1\"") == 1);
}
