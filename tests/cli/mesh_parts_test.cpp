// touchstone mesh: parts that are asked about, and the least distance.
// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>
#include <string>

#include "cli/mesh_runs.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

/// A tetrahedron, and another one so far above its top.
std::string two_tetrahedra(double gap) {
  const std::string low = std::to_string(1 + gap), high = std::to_string(2 + gap);
  return "o base\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0.1 0.1 1\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\no top\nv 0 0 " + low +
         "\nv 1 0 " + low + "\nv 0 1 " + low + "\nv 0 0 " + high + "\nf 5 6 7\nf 5 8 6\nf 6 8 7\nf 7 8 5\n";
}

}  // namespace

TEST_CASE("the least distance of parts is found at rest and in a step, and written into the report") {
  const TemporaryFolder folder;
  const std::string one = folder.write("t-1.obj", two_tetrahedra(1)),
                    two = folder.write("t-2.obj", two_tetrahedra(0.5)),
                    three = folder.write("t-3.obj", two_tetrahedra(-0.5));
  const Run rest = mesh({"--check", "--clearance", "--between-parts", one});
  CHECK(rest.status == 0);
  CHECK(
      rest.out.starts_with("t-1.obj: no intersection; least distance 1: vertex 4 of base and face 5 (5-6-7) of top\n"));
  CHECK(verdict(rest) ==
        "1 frame, no intersection; least distance 1 (8 vertices, 12 edges, 8 faces); pairs within one part were left "
        "out");
  CHECK(occurrences(mesh({"--check", "--clearance", one}).out, "of top and face 7 (6-8-7) of top") == 1);

  const Run run =
      mesh({"--clearance", "--only-between", "t*,base", one, two, three, "--report", folder.path("r.json")});
  CHECK(run.status == 1);
  CHECK(occurrences(run.out,
                    "free; least distance 0.5: vertex 4 of base and face 5 (5-6-7) of top, t = 0x1p+0 (1)\n") == 1);
  CHECK(occurrences(run.out, "first contact at t = 0x1p-1 (0.5), 1 pair") == 1);
  CHECK(occurrences(verdict(run), "; least distance 0 (") == 1);
  CHECK(verdict(run).ends_with("; nothing but these parts was asked about: base and top"));
  const auto report = nlohmann::json::parse(folder.read("r.json"));
  CHECK(report["parts"].dump() == R"({"only":[["base","top"]],"within":true})");
  CHECK(report["counts"]["least_distance"] == "0x0p+0");
  CHECK(report["results"][1]["clearance"]["distance"] == "0x1p-1");
  CHECK(report["results"][1]["clearance"]["pair"]["kind"] == "vertex-face");
  CHECK(report["results"][2]["clearance"]["toi"] == "0x1p-1");

  // Another question has another report.
  const Run other = mesh({"--only-between", "t*,base", one, two, three, "--report", folder.path("r.json"), "--resume"});
  CHECK(other.status == 2);
  CHECK(occurrences(other.err, "is about the least distance, too, and this run about contacts alone") == 1);
  const Run parts = mesh({"--clearance", one, two, three, "--report", folder.path("r.json"), "--resume"});
  CHECK(occurrences(parts.err, "is about nothing but these parts was asked about") == 1);
}

TEST_CASE("parts that are ignored may pass through each other, and the verdict says so") {
  const TemporaryFolder folder;
  const std::string one = folder.write("t-1.obj", two_tetrahedra(1)),
                    two = folder.write("t-2.obj", two_tetrahedra(-0.5));
  CHECK(mesh({one, two}).status == 1);
  const Run run = mesh({"--ignore", "base,top", "--clearance", one, two});
  CHECK(run.status == 0);
  CHECK(verdict(run).ends_with("; these parts were not asked about: base and top"));
  CHECK(mesh({"--separation", "0.75", "--between-parts", one, two}).status == 1);
}

TEST_CASE("options about parts that mean nothing are refused") {
  const TemporaryFolder folder;
  const std::string one = folder.write("t-1.obj", two_tetrahedra(1)), two = folder.write("t-2.obj", two_tetrahedra(2));
  const auto refused = [&](const std::vector<std::string>& arguments, const std::string& words) {
    std::vector<std::string> all = arguments;
    for (const std::string& file : {one, two}) all.push_back(file);
    const Run run = mesh(all);
    CAPTURE(run.err, words);
    CHECK(run.status == 2);
    CHECK(occurrences(run.err, words) == 1);
  };
  refused({"--ignore", "base"}, "must be two names of parts, such as A,B");
  refused({"--ignore", "base,tip"}, "t-1.obj: 'base,tip' names no two parts");
  refused({"--ignore", "*,*"}, "has no two parts that are left to ask about");
  refused({"--ignore", "base,top", "--only-between", "base,top"}, "--only-between excludes --ignore");
  refused({"--between-parts", "--prove", folder.path("p")}, "--between-parts excludes --prove");
  refused({"--between-parts", "--check", "--in-order"}, "parts are those of one mesh");
}
