// `touchstone generate`: files that certify, the same every time, and nothing after an error.
// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "support/catch.hpp"

using namespace touchstone::tests;

namespace {

std::vector<std::string> generate(const std::string& out, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments = {"generate", "--size", "1000", "--steps", "4", "--count", "250", "--out", out};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

const std::vector<std::string> kFiles = {"cloth/edge-edge/seed-1.csv", "cloth/vertex-face/seed-1.csv",
                                         "sheets/edge-edge/seed-1.csv", "sheets/vertex-face/seed-1.csv",
                                         "cables/edge-edge/seed-1.csv"};

}  // namespace

TEST_CASE("generated files hold what was asked for, and their truth columns are true") {
  const TemporaryFolder folder;
  const Run run = run_program(generate(folder.path("q")));
  CAPTURE(run.err);
  CHECK(run.status == 0);
  CHECK(run.err == "");
  std::vector<std::string> certify = {"certify"};
  std::string text;
  for (const auto& name : kFiles) {
    CAPTURE(name);
    CHECK(occurrences(run.out, folder.path("q/" + name) + ": 250 queries, ") == 1);
    text = folder.read("q/" + name);
    CHECK(occurrences(text, "\n") == 8 * 250);
    certify.push_back(folder.path("q/" + name));
  }
  CHECK(folder.names() == std::set<std::string>{"q"});
  const Run certified = run_program(certify);
  CHECK(certified.status == 0);
  CHECK(occurrences(certified.out, "all 1,250 claims hold") == 1);

  SECTION("the same options write the same bytes, another seed other ones") {
    CHECK(run_program(generate(folder.path("again"))).status == 0);
    for (const auto& name : kFiles) CHECK(folder.read("q/" + name) == folder.read("again/" + name));
    CHECK(run_program(generate(folder.path("q"), {"--seed", "2", "--scene", "cables"})).status == 0);
    CHECK(folder.read("q/cables/edge-edge/seed-2.csv") != text);
    CHECK(folder.read("q/cables/edge-edge/seed-1.csv") == text);
  }
}

TEST_CASE("curved families are files of curved queries, and their truth columns are true") {
  const TemporaryFolder folder;
  const Run run = run_program({"generate", "--family", "gears", "--family", "spline", "--count", "40", "--seed", "3",
                               "--out", folder.path("q")});
  CAPTURE(run.out, run.err);
  CHECK(run.status == 0);
  std::vector<std::string> certify = {"certify"};
  for (const char* family : {"gears", "spline"}) {
    for (const char* kind : {"edge-edge", "vertex-face", "point-edge", "point-point"}) {
      const std::string name = std::string("q/") + family + "/" + kind + "/seed-3.csv";
      CHECK(occurrences(run.out, folder.path(name) + ": 40 queries, ") == 1);
      CHECK(folder.read(name).starts_with("touchstone-curved,1\n"));
      certify.push_back(folder.path(name));
    }
  }
  const Run certified = run_program(certify);
  CHECK(certified.status == 0);
  CHECK(occurrences(certified.out, "all 320 claims hold") == 1);

  const std::vector<std::string> near = {"generate",    "--curved",     "--count", "2",     "--kind",
                                         "point-point", "--separation", "0.5",     "--out", folder.path("near")};
  CHECK(run_program(near).status == 0);
  CHECK(folder.read("near/coin/point-point/seed-1.csv").starts_with("# separation 0x1p-1 euclidean\n"));
  CHECK_FALSE(std::filesystem::exists(folder.path("near/coin/edge-edge")));
}

TEST_CASE("scene and kind leave out the others") {
  const TemporaryFolder folder;
  const Run run = run_program(generate(folder.path("q"), {"--scene", "sheets", "--kind", "vertex-face"}));
  CHECK(run.status == 0);
  CHECK(folder.read("q/sheets/vertex-face/seed-1.csv") != "");
  CHECK_FALSE(std::filesystem::exists(folder.path("q/sheets/edge-edge")));
  CHECK_FALSE(std::filesystem::exists(folder.path("q/cloth")));
  const Run all = run_program(generate(folder.path("all"), {"--kind", "vertex-face"}));
  CHECK(all.status == 0);
  CHECK_FALSE(std::filesystem::exists(folder.path("all/cables")));
}

TEST_CASE("every candidate, and pairs that share a corner") {
  const TemporaryFolder folder;
  const std::vector<std::string> more = {"--scene", "cables", "--count", "0"};
  auto arguments = generate(folder.path("q"), more);
  arguments.erase(arguments.begin() + 5, arguments.begin() + 7);  // the other --count
  CHECK(run_program(arguments).status == 0);
  const std::string without = folder.read("q/cables/edge-edge/seed-1.csv");
  arguments.emplace_back("--shared-corners");
  CHECK(run_program(arguments).status == 0);
  CHECK(folder.read("q/cables/edge-edge/seed-1.csv").size() > without.size());
  CHECK(run_program({"certify", folder.path("q/cables/edge-edge/seed-1.csv")}).status == 0);
}

TEST_CASE("bad options end with status 2, one line, and nothing written") {
  const TemporaryFolder folder;
  const auto check_refused = [&](const std::vector<std::string>& arguments, const std::string& part) {
    const Run run = run_program(arguments);
    CAPTURE(arguments, run.err);
    CHECK(run.status == 2);
    CHECK(run.out == "");
    CHECK(occurrences(run.err, "\n") == 1);
    CHECK(occurrences(run.err, part) > 0);
    CHECK(folder.names().empty());
  };
  const std::string out = folder.path("a/b");
  check_refused({"generate"}, "--out");
  check_refused({"generate", "--out", out, "--scene", "kitchen"},
                "kitchen is no scene; it must be cloth, sheets, cables, drape, boxes");
  check_refused({"generate", "--out", out, "--kind", "point-edge"}, "--kind point-edge: the scenes have edge-edge and");
  check_refused({"generate", "--out", out, "--kind", "edge"}, "--kind");
  check_refused({"generate", "--out", out, "--curved", "--scene", "cloth"}, "--scene excludes --curved");
  check_refused({"generate", "--out", out, "--curved", "--family", "gears"}, "--curved excludes --family");
  check_refused({"generate", "--out", out, "--curved", "--count", "0"}, "a number from 1 would be right");
  check_refused({"generate", "--out", out, "--family", "sliding"}, "sliding is no curved family");
  check_refused({"generate", "--out", out, "--scene", "cables", "--kind", "vertex-face"}, "scene cables has no faces");
  check_refused({"generate", "--out", out, "--size", "99"}, "99 must be a whole number from 100");
  check_refused({"generate", "--out", out, "--steps", "0"}, "--steps");
  check_refused({"generate", "--out", out, "--count", "-1"}, "--count");
  check_refused({"generate", "--out", out, "--seed", "x"}, "--seed");
  check_refused({"generate", "--out", out, "--seed", "99999999999999999999"}, "--seed");
  check_refused({"generate", "--out", out, "--speed", "-1"}, "--speed");
  check_refused({"generate", "--out", out, "--speed", "fast"}, "--speed");
  check_refused({"generate", "--out", out, "--speed", "nan"}, "--speed");
  check_refused({"generate", "--out", out, "--meshes", "--kind", "edge-edge"}, "--kind excludes --meshes");
  check_refused({"generate", "--out", out, "--meshes", "--count", "10"}, "--count excludes --meshes");
  check_refused({"generate", "--out", out, "--meshes", "--shared-corners"}, "--shared-corners");
  check_refused({"generate", "--out", out, "--meshes", "--separation", "0.1"}, "--separation excludes --meshes");
  check_refused({"generate", "--out", out, "--crossing", "3"}, "--crossing requires --meshes");
  check_refused({"generate", "--out", out, "--meshes", "--crossing", "0"}, "--crossing");
  check_refused({"generate", "--out", out, "--meshes", "--crossing", "20"}, "a number from 1 to 19 would be right");
  check_refused({"generate", "--out", out, "--meshes", "--steps", "1", "--crossing", "1"}, "more steps would be right");
  check_refused({"generate", "--out", out, "--meshes", "--scene", "cloth", "--crossing", "3"}, "for the scene drape");
  check_refused({"generate", "--out", out, "--meshes", "--scene", "drape", "--scene", "cloth", "--crossing", "3"},
                "for the scene drape");
}

TEST_CASE("a place where nothing can be written ends with status 2, and what was there stays") {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "mine");
  const Run run = run_program(generate(file));
  CHECK(run.status == 2);
  CHECK(occurrences(run.err, "no folder can be made here") == 1);
  CHECK(folder.read("file") == "mine");
  CHECK(folder.names() == std::set<std::string>{"file"});

  folder.write("q/cables/edge-edge/seed-1.csv/in the way", "");
  CHECK(run_program(generate(folder.path("q"))).status == 2);
  CHECK_FALSE(std::filesystem::exists(folder.path("q/cloth")));
  CHECK_FALSE(std::filesystem::exists(folder.path("q/sheets")));
}

TEST_CASE("an interrupt leaves nothing behind") {
  const TemporaryFolder folder;
  RunOptions options;
  options.interrupt_after = 0.5;
  std::vector<std::string> arguments = {"generate", "--size", "20000", "--steps", "100000", "--out", folder.path("q")};
  const std::vector<std::string> more =
      GENERATE(std::vector<std::string>{"--count", "0"}, std::vector<std::string>{"--meshes"});
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Run run = run_program(arguments, options);
  CHECK(run.status == 128 + 2);
  CHECK(folder.names().empty());
}
