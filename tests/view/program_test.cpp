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
