// `touchstone report --quick`: a complete folder whose numbers fit together, or a clear error.
// SPDX-License-Identifier: MIT
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "baselines/baseline.hpp"
#include "baselines/body_baseline.hpp"
#include "baselines/curved_baseline.hpp"
#include "cli/run_program.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

using Row = std::map<std::string, std::string>;

/// The rows of a CSV text, by column name. Quotes guard commas; the report writes no line ends into fields.
std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  return fields;
}

std::vector<Row> rows_of(const std::string& text) {
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  const auto names = fields_of(line);
  std::vector<Row> rows;
  while (std::getline(lines, line)) {
    const auto fields = fields_of(line);
    CAPTURE(line);
    REQUIRE(fields.size() == names.size());
    Row row;
    for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = fields[i];
    rows.push_back(row);
  }
  return rows;
}

long number(const Row& row, const std::string& column) { return std::strtol(row.at(column).c_str(), nullptr, 10); }

/// Whether a set has curved motion: others are asked than for straight motion.
bool is_curved(const std::string& set) {
  for (const char* source : {"curved/", "bundled-curved/", "files-curved/", "link-chain/", "nut-and-bolt/"}) {
    if (set.rfind(source, 0) == 0) return true;
  }
  return false;
}

void check_rows(const std::vector<Row>& rows, const std::set<std::string>& expected_sets) {
  std::set<std::string> of_some_kinds = {"paper"};  // the methods that do not take every kind
  for (const auto& method : baselines::curved_methods()) of_some_kinds.emplace(method.name);
  std::map<std::string, std::size_t> sizes;  // by set and scale
  std::map<std::string, long> wrong;         // by method
  long by_cgal = 0;                          // queries of touchstone_cgal that CGAL decided
  std::set<std::string> sets;
  for (const Row& row : rows) {
    CAPTURE(row.at("set"), row.at("scale_exponent"), row.at("method"), row.at("tolerance"));
    ++sizes[row.at("set") + " " + row.at("scale_exponent")];
    sets.insert(row.at("set"));
    CHECK_FALSE(row.at("version").empty());
    CHECK_FALSE(row.at("machine").empty());
    CHECK_FALSE(row.at("compiler").empty());
    const long queries = number(row, "queries");
    CHECK(queries <= number(row, "set_queries"));
    if (queries == 0) {
      CHECK(of_some_kinds.count(row.at("method")) == 1);
      CHECK(row.at("mean_us").empty());
      continue;
    }
    const long errors = number(row, "missed") + number(row, "phantom") + number(row, "late");
    CHECK(errors <= queries);
    CHECK(std::stod(row.at("mean_us")) > 0);
    CHECK(std::stod(row.at("p50_us")) <= std::stod(row.at("slowest_us")));
    wrong[row.at("method")] += errors;
    const bool with_cgal = row.at("method") == "touchstone_cgal";
    if (row.at("method") != "touchstone" && !with_cgal) continue;
    CHECK(errors == 0);
    const long decided = number(row, with_cgal ? "level_oracle" : "level_exact");
    CHECK(number(row, "level_filter") + number(row, "level_bracket") + decided == queries);
    if (with_cgal) by_cgal += decided;
    if (number(row, "times_compared") > 0) CHECK(row.at("ulps_greatest_magnitude") == "0");
  }
  CHECK(sets == expected_sets);
  const std::size_t per_curved_set = 3 + 3 * baselines::curved_methods().size();
  for (const auto& method : baselines::curved_methods()) {
    CAPTURE(method.name);
    CHECK(wrong[std::string(method.name)] > 0);
  }
  std::size_t per_body_set = 1;
  for (const auto& method : baselines::body_methods()) per_body_set += method.tolerances.size();
  std::size_t per_set = 3, per_scale = 3;  // exact_only, touchstone_cgal and touchstone
  for (const auto& method : baselines::methods()) {
    per_set += method.has_tolerance() ? 3 : 1;
    ++per_scale;
    CAPTURE(method.name);
    CHECK(wrong[std::string(method.name)] > 0);
  }
  CHECK(wrong["exact_only"] == 0);
  CHECK(wrong["touchstone_cgal"] == 0);
  CHECK(by_cgal > 0);
  for (const auto& [name, size] : sizes) {
    CAPTURE(name);
    CHECK(size == (is_curved(name)                 ? per_curved_set
                   : name.rfind("bodies/", 0) == 0 ? per_body_set
                   : name.rfind("scale/", 0) == 0  ? per_scale
                                                   : per_set));
  }
}

// Address sanitizer keeps memory that is freed, and shadows all of it: the process then tells nothing of the program.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool kSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif
#else
constexpr bool kSanitized = false;
#endif

void check_scene_runs(const std::vector<Row>& rows) {
  if (kSanitized) WARN("the greatest memory of a simulation is not checked: address sanitizer keeps what is freed");
  std::map<std::string, long> edges, runs;  // by scene
  for (const Row& row : rows) {
    const std::string& scene = row.at("scene");
    CAPTURE(scene, row.at("size"));
    ++runs[scene];
    // The first steps of `twist` have none: it is there for what the forces and the proof of cloth cost.
    if (scene != "twist") CHECK(number(row, "contacts") > 0);
    CHECK(row.at("crossings") == "0");
    CHECK(std::stod(row.at("seconds")) > 0);
    CHECK(std::stod(row.at("collision_share")) > 0);
    CHECK(std::stod(row.at("collision_share")) < 1);
    // A particle and the memory of its step are more than fifty doubles. No scene here takes gigabytes.
    if (!row.at("memory_bytes").empty()) CHECK(number(row, "memory_bytes") > 400 * number(row, "edges"));
    if (!row.at("memory_bytes").empty() && !kSanitized) CHECK(number(row, "memory_bytes") < 100'000'000);
    CHECK(number(row, "edges") > edges[scene]);
    edges[scene] = number(row, "edges");
  }
  CHECK(runs ==
        std::map<std::string, long>{{"cable-drop", 2}, {"hoop", 1}, {"link-chain", 2}, {"twist", 2}, {"whip", 2}});
}

/// A file of queries that never touch: a set without any time to compare.
std::string own_queries(const TemporaryFolder& folder) {
  return folder.write("point-point/own.csv", "0,1,0,1,0,1,0\n0,1,0,1,1,1,0\n0,1,0,1,0,1,0\n0,1,0,1,2,1,0\n");
}

/// The sets of a quick report on `own_queries`.
std::set<std::string> set_names() {
  std::set<std::string> sets = {"files/point-point",
                                "scale/edge-edge",
                                "bundled/point-edge",
                                "bundled/point-point",
                                "link-chain/edge-edge",
                                "nut-and-bolt/edge-edge",
                                "nut-and-bolt/vertex-face",
                                "bodies/random",
                                "bodies/touching",
                                "bodies/gears",
                                "bodies/links"};
  for (const char* kind : {"edge-edge", "vertex-face", "point-edge", "point-point"}) {
    for (const char* source : {"curved", "bundled-curved"}) sets.insert(std::string(source) + "/" + kind);
  }
  for (const char* kind : {"edge-edge", "vertex-face"}) {
    for (const char* family : {"simulation", "bundled", "aligned", "aligned-turned", "random", "near"})
      sets.insert(std::string(family) + "/" + kind);
  }
  return sets;
}

std::set<std::string> plot_names(const std::set<std::string>& sets) {
  std::set<std::string> plots = {"error-against-time", "scale"};
  for (std::string name : sets) {
    name[name.find('/')] = '-';
    if (name == "scale-edge-edge") continue;
    plots.insert("error-" + name);
    plots.insert("percentiles-" + name);
  }
  return plots;
}

std::size_t count_files(const std::string& folder) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files += entry.is_regular_file();
  return files;
}

}  // namespace

TEST_CASE("a quick report is a whole folder, and touchstone is never wrong in it", "[slow]") {
  const TemporaryFolder folder;
  const std::string out = folder.path("a/report");
  const Run run = run_program({"report", "--quick", "--out", out, own_queries(folder)});
  CAPTURE(run.err);
  REQUIRE(run.status == 0);
  CHECK(run.out == out + "/report.md\n");
  CHECK(run.err == "");

  const std::set<std::string> sets = set_names();
  check_rows(rows_of(folder.read("a/report/report.csv")), sets);
  check_scene_runs(rows_of(folder.read("a/report/simulation.csv")));

  const std::string text = folder.read("a/report/report.md");
  CHECK(occurrences(text, "On the front") == sets.size() - 1);  // every set, but not the scales
  CHECK(occurrences(text, "`touchstone` is wrong on 0 of ") == 1);
  CHECK(occurrences(text, "coordinates are fractions") == 1);
  CHECK(occurrences(text, ".svg)") == 2 * (sets.size() - 1) + 2);

  const std::set<std::string> plots = plot_names(sets);
  CHECK(count_files(out + "/plots") == plots.size());
  for (const auto& name : plots) {
    CAPTURE(name);
    const std::string svg = folder.read("a/report/plots/" + name + ".svg");
    CHECK(occurrences(text, "(plots/" + name + ".svg)") == 1);
    CHECK(occurrences(svg, "</svg>") == 1);
    CHECK(occurrences(svg, ">touchstone</text>") == 1);
  }
}

TEST_CASE("an interrupted report ends by the signal and leaves nothing behind") {
  for (const bool whole_group : {false, true}) {  // true: the process of the simulated scene gets the signal too
    const TemporaryFolder folder;
    RunOptions options;
    options.interrupt_after = 0.5;
    options.own_group = whole_group;
    const Run run = run_program({"report", "--quick", "--out", folder.path("report")}, options);
    CAPTURE(whole_group, run.err);
    CHECK(run.status == 128 + SIGINT);
    CHECK(run.err == "");
    CHECK(folder.names().empty());
  }
}

TEST_CASE("a report that cannot be made ends with status 2, at once, and leaves nothing behind") {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "mine");
  for (const std::string& out : {file, file + "/below"}) {
    const Run run = run_program({"report", "--quick", "--out", out});
    CHECK(run.status == 2);
    CHECK(occurrences(run.err, "no folder can be made here") == 1);
  }
  CHECK(folder.read("file") == "mine");
  CHECK(run_program({"report"}).status == 2);
  CHECK(run_program({"report", "--quick", "--seed", "-1", "--out", folder.path("r")}).status == 2);
  const Run missing = run_program({"report", "--quick", "--out", folder.path("r"), folder.path("edge-edge/none.csv")});
  CHECK(missing.status == 2);
  CHECK(occurrences(missing.err, "none.csv") == 1);
  CHECK(folder.names() == std::set<std::string>{"file"});
}
