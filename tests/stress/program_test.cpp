// `touchstone stress`: a complete folder with errors of the other methods and none of touchstone, or a clear error.
// SPDX-License-Identifier: MIT
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "stress/stress.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

/// Cells by column name; no cell that is looked at holds a comma, and quoted ones come before them.
std::map<std::string, std::string> cells(const std::string& header, std::string row) {
  for (std::size_t quote = row.find('"'); quote != std::string::npos; quote = row.find('"')) {
    row.erase(quote, row.find('"', quote + 1) + 1 - quote);
  }
  std::map<std::string, std::string> result;
  std::istringstream names(header), values(row);
  for (std::string name, value; std::getline(names, name, ',');) {
    value.clear();
    std::getline(values, value, ',');
    result[name] = value;
  }
  return result;
}

}  // namespace

TEST_CASE("the stability table is whole: touchstone shows zeros throughout, and every inexact method breaks",
          "[slow]") {
  const TemporaryFolder folder;
  const std::string out = folder.path("a/stress");
  const Run run = run_program({"stress", "--count", "12", "--out", out});
  CAPTURE(run.err);
  REQUIRE(run.status == 0);
  CHECK(run.out == out + "/stress.md\n");

  const auto lines = lines_of(folder.read("a/stress/stress.csv"));
  REQUIRE(lines.size() > 1);
  std::map<std::string, std::size_t> rows, wrong;  // by method
  std::set<std::string> settings;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    auto row = cells(lines[0], lines[i]);
    CAPTURE(lines[i]);
    const std::string& method = row["method"];
    ++rows[method];
    settings.insert(row["set"] + " " + row["dial_exponent"]);
    for (const char* fault : {"missed", "phantom", "late"}) {
      wrong[method] += std::strtoul(row[fault].c_str(), nullptr, 10);
    }
    if (method != "touchstone" && method != "exact_only") continue;
    CHECK(row["queries"] == "12");
    CHECK((row["times_compared"] == "0" || row["ulps_greatest_magnitude"] == "0"));
    CHECK(std::stod(row["mean_us"]) > 0);
  }
  std::size_t expected = 0;
  for (const auto& dial : stress::dials()) expected += 2 * dial.settings.size();
  CHECK(settings.size() == expected);
  CHECK(rows.size() == 7);
  for (const auto& [method, count] : rows) {
    CAPTURE(method);
    CHECK(count == expected);
    const bool exact = method == "touchstone" || method == "exact_only";
    CHECK((wrong[method] == 0) == exact);
  }

  const std::string text = folder.read("a/stress/stress.md");
  CHECK(occurrences(text, "`touchstone` is wrong on 0 of ") == 1);
  CHECK(occurrences(text, "differs from the judge on 0.") == 1);
  CHECK(occurrences(text, " us a query at 2^") == 2 * stress::dials().size());
  CHECK(occurrences(text, "\n## ") == 2 * stress::dials().size());

  for (const auto& dial : stress::dials()) {
    for (const char* kind : {"-edge-edge", "-vertex-face"}) {
      const std::string svg = folder.read("a/stress/plots/" + std::string(dial.name) + kind + ".svg");
      CHECK(occurrences(svg, "<g transform") == 2);  // two charts, and each method by name
      for (const auto& [method, count] : rows) CHECK(occurrences(svg, ">" + method) == 1);
    }
  }
}

TEST_CASE("one dial alone, named twice, is turned once") {
  const TemporaryFolder folder;
  const Run run = run_program(
      {"stress", "--count", "3", "--seed", "9", "--dial", "sliver", "--dial", "sliver", "--out", folder.path("s")});
  CAPTURE(run.err);
  REQUIRE(run.status == 0);
  const std::string text = folder.read("s/stress.md");
  CHECK(occurrences(text, "\n## ") == 2);
  CHECK(occurrences(text, "--seed 9 --count 3 --dial sliver`") == 1);
}

TEST_CASE("an interrupted stress ends by the signal") {
  const TemporaryFolder folder;
  RunOptions options;
  options.own_group = true;
  options.interrupt_after = 0.5;
  const Run measuring = run_program({"stress", "--count", "100000", "--out", folder.path("a")}, options);
  CHECK(measuring.status == 128 + SIGINT);
  CHECK(folder.names().empty());
}

TEST_CASE("a table that cannot be made ends with status 2, and leaves nothing behind") {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "mine");
  CHECK(run_program({"stress"}).status == 2);
  CHECK(run_program({"stress", "--out", file}).status == 2);
  CHECK(folder.read("file") == "mine");
  const Run unknown = run_program({"stress", "--dial", "volume", "--out", folder.path("s")});
  CHECK(unknown.status == 2);
  CHECK(occurrences(unknown.err, "volume is no dial; they are scale, offset") == 1);
  CHECK(run_program({"stress", "--count", "0", "--out", folder.path("s")}).status == 2);
  CHECK(run_program({"stress", "--seed", "x", "--out", folder.path("s")}).status == 2);
  CHECK(folder.names() == std::set<std::string>{"file"});
}
