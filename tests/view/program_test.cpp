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

/// The page without the command that made it, which the page shows.
std::string without_command(std::string page) {
  const std::string start = "<pre class=\"command\">", end = "</pre>\n";
  const std::size_t from = page.find(start), to = page.find(end, from);
  REQUIRE(from < to);
  REQUIRE(to != std::string::npos);
  return page.erase(from, to + end.size() - from);
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
  CHECK((without_command(text) == without_command(text_of(other))));
  CHECK((without_command(text) == without_command(run_program({"view", "--query", "0", "--out", "-", file}).out)));
  CHECK(occurrences(text, ">touchstone view --query 0 --out " + page + " " + file + "</pre>") == 1);
  CHECK(occurrences(text, "they touch") == 1);
}

TEST_CASE("a page has the command as it was typed, and a hostile name is text in it") {
  const TemporaryFolder folder;
  const std::string file = folder.write("edge-edge/a'b\"<!--\n$(x)<i>.csv", kQuery);
  const Run run = run_program({"view", "--query", "0", "--out", "-", file});
  CHECK(run.status == 0);
  CHECK(occurrences(run.out, "<!--") == 0);
  CHECK(occurrences(run.out, "<i>") == 0);
  CHECK(occurrences(run.out, "touchstone view --query 0 --out - $&#39;") == 1);
  CHECK(occurrences(run.out, "a\\&#39;b&quot;&lt;!--\\n$(x)&lt;i&gt;.csv&#39;</pre>") == 1);
}

TEST_CASE("view and explain write a moving picture alone, which says the answer") {
  const TemporaryFolder folder;
  const std::string file = folder.write("edge-edge/a.csv", kQuery), svg = folder.path("a.svg");
  const std::string page = folder.path("a.html"), other = folder.path("other.svg");
  const Run view = run_program({"view", "--query", "0", "--svg", svg, "--out", page, file});
  CHECK(view.status == 0);
  CHECK(occurrences(view.out, " bytes: open it in a browser\n") == 2);
  const std::string text = text_of(svg);
  CHECK(text.rfind("<svg xmlns=\"http://www.w3.org/2000/svg\"", 0) == 0);
  CHECK(occurrences(text, "<title>Edge a and edge b touch first at t just above 0.3") == 1);
  CHECK(occurrences(text, "<desc>query 0 of " + file) == 1);
  CHECK(occurrences(text, "<script") == 0);
  CHECK(occurrences(text, "class=\"f s\"") == 1);
  CHECK(occurrences(text, "class=\"meeting\"") == 1);
  CHECK(occurrences(text, "prefers-color-scheme: dark") == 1);
  CHECK(text == run_program({"view", "--query", "0", "--svg", "-", file}).out);
  CHECK(run_program({"explain", "--query", "0", "--svg", other, file}).status == 0);
  CHECK(text == text_of(other));
  check_refused({"view", "--query", "0", "--svg", "-", "--out", "-", file}, "--svg names standard output");
  check_refused({"view", "--query", "0", "--svg", svg, "--out", svg, file}, "--out");
  check_refused({"view", "--query", "0", "--svg", folder.path("a.png"), file}, "name it");
  check_refused({"view", "--query", "0", "--svg", file, file}, "--svg");
  check_refused({"explain", "--query", "0", "--svg", "-", file}, "--svg: name a file to write");
  CHECK(text == text_of(svg));
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
    CHECK((without_command(text_of(page)) == without_command(text)));
  }
  CHECK(occurrences(text, "</html>") == 1);
  check_refused({"simulate", "two-edges", "--html", "-"}, "--html");
  check_refused({"simulate", "two-edges", "--html", ""}, "--html");
  const std::string both = folder.path("both");
  check_refused({"simulate", "two-edges", "--html", both, "--energies", both}, "--html");
  check_refused({"simulate", "two-edges", "--html", folder.path("none/p.html")}, "none/p.html");
  CHECK((without_command(text_of(page)) == without_command(text)));

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
