// `touchstone bench`: its output and its files. Speed is not tested.
// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/sample_files.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace touchstone::tests;

namespace {

std::vector<std::string> bench(const std::vector<std::string>& more) {
  std::vector<std::string> arguments = {"bench", "--min-time", "0.0001", "--repetitions", "2", "--count", "60"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

}  // namespace

TEST_CASE("bench prints every method beside the floor") {
  const TemporaryFolder folder;
  const Run run = run_program(
      bench({"--filter", "^simulation/edge-edge/all", "--csv", folder.path("b.csv"), "--json", folder.path("b.json")}));
  CAPTURE(run.out, run.err);
  CHECK(run.status == 0);
  CHECK(run.err == "");
  CHECK(occurrences(run.out, "simulation/edge-edge/all: 180 queries, ") == 1);  // 60 of each scene
  for (const char* method :
       {"  floor ", "  touchstone ", "  touchstone_contact ", "  touchstone_time ", "  touchstone_batch ",
        "  touchstone_columns ", "  touchstone_cgal ", "  exact ", "  oracle (20 of them) ", "  prove "}) {
    CHECK(occurrences(run.out, method) == 1);
  }
  CHECK(occurrences(run.out, "simulation/vertex-face") == 0);

  const std::string csv = folder.read("b.csv");
  CHECK(csv.starts_with("set,method,queries,set_queries,set_contacts,median_ns,least_ns,greatest_ns,ratio_to_floor,"));
  CHECK(occurrences(csv, "\n") == 11);
  CHECK(occurrences(csv, "simulation/edge-edge/all,floor,180,180,") == 1);
  const auto json = nlohmann::json::parse(folder.read("b.json"));
  REQUIRE(json["results"].size() == 10);
  for (const auto& result : json["results"]) {
    CHECK(result["repetitions_ns"].size() == 2);
    CHECK(result["median_ns"] > 0);
    CHECK(result["ratio_to_floor"] > 0);
    if (result["method"] == "floor") {
      CHECK(result["ratio_to_floor"] == 1);
    } else {
      const auto& levels = result["levels"];
      const int decided = levels["filter"].get<int>() + levels["bracket"].get<int>() + levels["exact"].get<int>() +
                          levels["oracle"].get<int>();
      CHECK(decided == result["queries"]);
    }
  }
}

TEST_CASE("the filter leaves out all but what it finds and its floor") {
  const Run run = run_program(bench({"--filter", "bundled/point-edge/.*/touchstone$"}));
  CHECK(run.status == 0);
  CHECK(occurrences(run.out, "  floor ") == 3);  // all, hits and misses
  CHECK(occurrences(run.out, "  touchstone ") == 3);
  CHECK(occurrences(run.out, "exact ") == 0);
}

TEST_CASE("given files are a source of their own") {
  const TemporaryFolder folder;
  const std::string file = folder.write("point-point/a.csv", two_point_queries());
  const Run run = run_program(bench({"--filter", "^files", file}));
  CHECK(run.status == 0);
  CHECK(occurrences(run.out, "files/point-point/all: 2 queries, 50.0 % with contact") == 1);
  CHECK(occurrences(run.out, "files/point-point/hits: 1 query, 100.0 % with contact") == 1);
  const std::string same = folder.read("point-point/a.csv");
  CHECK(run_program(bench({"--filter", "^files", "--csv", file, file})).status == 2);
  CHECK(folder.read("point-point/a.csv") == same);
}

TEST_CASE("curved sets are measured beside the same pairs moving straight") {
  const TemporaryFolder folder;
  const Run run = run_program(
      bench({"--filter", "^(nut-and-bolt|bundled-curved)/edge-edge/(all|hits)", "--csv", folder.path("b.csv")}));
  CAPTURE(run.out, run.err);
  CHECK(run.status == 0);
  for (const char* set : {"nut-and-bolt/edge-edge/all: ", "nut-and-bolt/edge-edge/hits: ",
                          "bundled-curved/edge-edge/all: ", "bundled-curved/edge-edge/hits: "}) {
    CHECK(occurrences(run.out, set) == 1);
  }
  CHECK(occurrences(run.out, "  x straight  ") == 4);
  for (const char* method : {"  floor ", "  straight ", "  touchstone ", "  touchstone_batch ", "  touchstone_cgal "}) {
    CHECK(occurrences(run.out, method) == 4);
  }
  CHECK(occurrences(run.out, "touchstone_columns") == 0);
  const std::string csv = folder.read("b.csv");
  CHECK(occurrences(csv, ",ratio_to_straight\n") == 1);
  CHECK(occurrences(csv, ",1.0000\n") == 4);  // the straight pairs are the measure
}

TEST_CASE("bad options of bench end with status 2 and one line") {
  const TemporaryFolder folder;
  const auto check_refused = [](const std::vector<std::string>& more, const std::string& part) {
    const Run run = run_program(bench(more));
    CAPTURE(more, run.err);
    CHECK(run.status == 2);
    CHECK(run.out == "");
    CHECK(occurrences(run.err, "\n") == 1);
    CHECK(occurrences(run.err, part) == 1);
  };
  check_refused({"--filter", "["}, "[ is no regular expression");
  check_refused({"--filter", "no such thing"}, "no such thing");
  check_refused({folder.path("edge-edge/missing.csv")}, "cannot be opened");
  check_refused({"--csv", folder.path("no/b.csv")}, "cannot be written");
  CHECK(run_program({"bench", "--repetitions", "0"}).status == 2);
  for (const char* time : {"0", "nan", "inf", "101"}) {
    CAPTURE(time);
    CHECK(run_program({"bench", "--min-time", time}).status == 2);
  }
  CHECK(run_program({"bench", "--count", "0"}).status == 2);
  CHECK(folder.names().empty());
}

TEST_CASE("bench with a separation measures the baselines that take one, in the Euclidean metric") {
  const TemporaryFolder folder;
  const std::vector<std::string> asked = {"--filter", "^simulation/edge-edge/all", "--separation", "0.01"};
  std::vector<std::string> arguments = asked;
  arguments.insert(arguments.end(), {"--json", folder.path("b.json")});
  const Run run = run_program(bench(arguments));
  CAPTURE(run.out, run.err);
  CHECK(run.status == 0);
  CHECK(run.out.starts_with(
      "separation 0x1.47ae147ae147bp-7 (0.01), euclidean\n\nsimulation/edge-edge/all: 180 queries, "));
  for (const char* method : {"  floor ", "  touchstone ", "  touchstone_columns ", "  oracle (20 of them) ", "  prove ",
                             "  thick_polynomial ", "  thick_advancement "}) {
    CHECK(occurrences(run.out, method) == 1);
  }
  const auto json = nlohmann::json::parse(folder.read("b.json"));
  CHECK(json["separation"] == "0x1.47ae147ae147bp-7");
  CHECK(json["metric"] == "euclidean");
  CHECK(json["results"].size() == 12);
}
