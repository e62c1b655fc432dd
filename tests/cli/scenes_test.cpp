// touchstone scenes: steps of scenes as the public data set has them, against a truth that is known here; and the
// public scenes themselves, where they are.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"
#include "support/slow_build.hpp"

using namespace touchstone::tests;

namespace {

/// A triangle, and another one above it that is turned and falls by `fall`. The edges by the data set's numbers are
/// 6: 01, 7: 02, 8: 12, 9: 34, 10: 35, 11: 45, and the faces are 12 and 13.
std::string two_triangles(double fall) {
  std::string text = "v 0 0 0\nv 4 0 0\nv 0 4 0\n";
  const std::string height = std::to_string(1 - fall);
  text += "v 1 1 " + height + "\nv 5 1 " + height + "\nv 1 5 " + height + "\n";
  return text + "f 1 2 3\nf 4 5 6\n";
}

/// Vertex 3 falls on face 12, and edges 8 and 9, 8 and 10 cross.
std::unique_ptr<TemporaryFolder> scene(const std::string& edges = "[[8,9],[10,8],[6,9]]",
                                       const std::string& truth = "[true,true,false]") {
  auto folder = std::make_unique<TemporaryFolder>();
  for (const char* name : {"set/fall/frames", "set/fall/boxes", "set/fall/mma_bool"}) {
    std::filesystem::create_directories(folder->path(name));
  }
  folder->write("set/fall/frames/fall7.obj", two_triangles(0));
  folder->write("set/fall/frames/fall8.obj", two_triangles(2));
  folder->write("set/fall/boxes/7ee.json", edges);
  folder->write("set/fall/mma_bool/7ee_mma_bool.json", truth);
  folder->write("set/fall/boxes/7vf.json", "[[3,12],[4,12]]");
  folder->write("set/fall/mma_bool/7vf_mma_bool.json", "[true,false]");
  return folder;
}

void check_scenes_refused(const std::unique_ptr<TemporaryFolder>& folder, const std::string& words) {
  const Run run = run_program({"scenes", folder->path("set")});
  CAPTURE(run.err);
  CHECK(run.status == 2);
  CHECK(occurrences(run.err, words) == 1);
  CHECK(occurrences(run.err, "\n") == 1);
}

}  // namespace

TEST_CASE("scenes compares the contacts of a step with their truth") {
  const auto folder = scene();
  const std::string table = folder->path("table.csv");
  const Run run = run_program({"scenes", "--csv", table, folder->path("set")});
  CAPTURE(run.out, run.err);
  CHECK(run.status == 0);
  const std::vector<std::string> lines = lines_of(run.out);
  REQUIRE(lines.size() == 7);
  CHECK(lines[0] == "fall 7: 6 vertices, 2 faces");
  CHECK(lines[2].rfind("  first contact  0x1p-1 (0.5) in ", 0) == 0);
  CHECK(lines[3].rfind("  all contacts   3 in ", 0) == 0);
  CHECK(lines[4] == "  truth          5 pairs: all as said; 0 contacts besides");
  CHECK(lines[5] == "  digest         ef7c15eb4a66c36828ee03ea70e9ae48efb4710dc93d23d5fe4f429bbe9072d2");
  CHECK(lines[6] == "1 step, 5 pairs: all as said; 0 contacts besides");
  const std::vector<std::string> rows = lines_of(folder->read("table.csv"));
  REQUIRE(rows.size() == 2);
  CHECK(rows[1].rfind("fall 7,6,2,", 0) == 0);
  CHECK(occurrences(rows[0], ",") == occurrences(rows[1], ","));
  const Run again = run_program({"scenes", "--threads", "2", folder->path("set/fall/")});
  CHECK(lines_of(again.out)[5] == lines[5]);  // the digest
}

TEST_CASE("scenes says which verdicts differ, which contacts have no truth, and which steps have none") {
  const Run wrong = run_program({"scenes", scene("[[8,9],[10,8],[6,9]]", "[true,true,true]")->path("set")});
  CHECK(wrong.status == 1);
  CHECK(lines_of(wrong.out).back() == "1 step, 5 pairs: 1 verdict differs; 0 contacts besides");
  const Run besides = run_program({"scenes", scene("[[8,9],[6,9]]", "[true,false]")->path("set")});
  CHECK(besides.status == 1);
  CHECK(occurrences(besides.out, "4 pairs: all as said; 1 contact besides\n") == 2);
  const auto without = scene();
  std::filesystem::remove_all(without->path("set/fall/boxes"));
  std::filesystem::remove_all(without->path("set/fall/mma_bool"));
  const Run none = run_program({"scenes", without->path("set")});
  CHECK(none.status == 1);
  CHECK(lines_of(none.out).back() == "1 step, nothing was compared; 1 step without a truth");
  const auto no_pairs = scene("[]", "[]");
  no_pairs->write("set/fall/boxes/7vf.json", "[]");
  no_pairs->write("set/fall/mma_bool/7vf_mma_bool.json", "[]");
  const Run empty = run_program({"scenes", no_pairs->path("set")});
  CHECK(empty.status == 1);
  CHECK(lines_of(empty.out).back() == "1 step, 0 pairs: all as said; 3 contacts besides");
}

TEST_CASE("scenes refuses files that do not fit, and says what is wrong") {
  check_scenes_refused(scene("[[8,9]]"), "has 3 truths, and ");
  check_scenes_refused(scene("[[8,9,10],[10,8],[6,9]]"), "7ee.json: [0]: has 3 numbers; a pair has 2");
  check_scenes_refused(scene("[[8,12],[10,8],[6,9]]"), "12 is no edge, which have the numbers 6 to 11");
  check_scenes_refused(scene("[[8,9],[10,8],[6,9]]", "[true,2,false]"),
                       "7ee_mma_bool.json: [1]: must be true or false");
  check_scenes_refused(scene("[[8,9]"), "7ee.json: ");
  check_scenes_refused(scene("[[8,8],[10,8],[6,9]]"), "7ee.json: [0]: is an edge and itself");
  check_scenes_refused(scene("[[8,9],[10,8],[9,8]]"), "7ee.json: [2]: is a pair that the list has already");
  const auto half = scene();
  std::filesystem::remove(half->path("set/fall/mma_bool/7ee_mma_bool.json"));
  check_scenes_refused(half, "7ee.json: has no other half in ");
  const auto one = scene();
  std::filesystem::remove(one->path("set/fall/frames/fall8.obj"));
  check_scenes_refused(one, "holds no two mesh files");
  const auto other = scene();
  other->write("set/fall/boxes/9ee.json", "[]");
  check_scenes_refused(other, "9ee.json: belongs to no step");
  const auto unnumbered = scene();
  for (const char* number : {"7", "8"}) {
    std::filesystem::rename(unnumbered->path(std::string("set/fall/frames/fall") + number + ".obj"),
                            unnumbered->path(std::string("set/fall/frames/") + number + "fall.obj"));
  }
  check_scenes_refused(unnumbered, "has a name that ends in no number");
  const auto overwritten = scene();
  std::filesystem::create_symlink(overwritten->path("set/fall/boxes/7ee.json"), overwritten->path("7ee.csv"));
  const Run run = run_program({"scenes", "--csv", overwritten->path("7ee.csv"), overwritten->path("set")});
  CHECK(run.status == 2);
  CHECK(overwritten->read("set/fall/boxes/7ee.json") == "[[8,9],[10,8],[6,9]]");
  CHECK(run_program({"scenes", overwritten->path("nothing")}).status == 2);
  const auto empty = std::make_unique<TemporaryFolder>();
  std::filesystem::create_directories(empty->path("set"));
  check_scenes_refused(empty, "holds no scene");
}

TEST_CASE("the public scenes have exactly the contacts that their truth says", "[slow]") {
  const std::string data = TOUCHSTONE_QUERY_DATA;
  if (data.empty() || !std::filesystem::exists(data + "/scenes")) {
    skip("TOUCHSTONE_QUERY_DATA names no folder with the public scenes");
    return;
  }
  if (TOUCHSTONE_SLOW_BUILD) {
    std::printf("not checked in this build: the public scenes but cloth-funnel\n");
    const Run one = run_program({"scenes", data + "/scenes/cloth-funnel"});
    CAPTURE(one.out, one.err);
    CHECK(one.status == 0);
    CHECK(occurrences(one.out, ": all as said; 0 contacts besides\n") == 2);
    return;
  }
  const Run run = run_program({"scenes", data + "/scenes"});
  CAPTURE(run.out, run.err);
  CHECK(run.status == 0);
  CHECK(lines_of(run.out).back() == "4 steps, 143,350 pairs: all as said; 0 contacts besides");
  CHECK(occurrences(run.out, "  all contacts   ") == 4);
  if (std::filesystem::exists("/proc/self/statm")) CHECK(occurrences(run.out, " MB\n") == 4);
  for (const char* contacts : {"23,958", "113,854", "134", "4,944"}) {
    CHECK(occurrences(run.out, std::string("  all contacts   ") + contacts + " in ") == 1);
  }
}
