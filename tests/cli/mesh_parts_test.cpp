// touchstone mesh: parts that are asked about, and the least distance.
// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "cli/mesh_runs.hpp"
#include "cli/run_checker.hpp"

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
                    "free; least distance 0.5: vertex 4 of base and face 5 (5-6-7) of top, from t = 0x1p+0 (1)\n") ==
        1);
  CHECK(occurrences(run.out, "first contact at t = 0x1p-1 (0.5), 1 pair") == 1);
  CHECK(occurrences(run.out, "least distance") == 2 + 1);  // that of the step with a contact is not said twice
  CHECK(occurrences(verdict(run), "; least distance 0 in t-2.obj -> t-3.obj (") == 1);
  CHECK(verdict(run).ends_with("; nothing but these parts was asked about: base and top"));
  const auto report = nlohmann::json::parse(folder.read("r.json"));
  CHECK(report["parts"].dump() == R"({"only":[["base","top"]],"within":false})");
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

TEST_CASE("proofs are about the parts that are asked about, and the checker says which are not") {
  const TemporaryFolder folder;
  const std::string wire = "v 0.1 0.1 -1\nv 0.1 0.1 -2\nl 9 10\n";
  const std::string one = folder.write("t-1.obj", two_tetrahedra(1) + wire),
                    two = folder.write("t-2.obj", two_tetrahedra(-0.5) + wire);
  int runs = 0;
  const auto prove = [&](std::vector<std::string> options, int status, const std::string& words) {
    const std::string proved = folder.path("p" + std::to_string(++runs));
    options.insert(options.end(), {"--separation", "0.75", "--prove", proved, one, two});
    const Run run = mesh(options);
    CAPTURE(run.out, run.err);
    CHECK(run.status == status);
    const Run checked = run_checker({"--allow-empty", proved + "/proofs.txt"}, {proved + "/motion.txt"});
    CAPTURE(checked.out, checked.err);
    CHECK(checked.status == 0);
    CHECK(occurrences(checked.out, words) == 1);
    const std::size_t without = occurrences(checked.out, " 0 contacts, ") + occurrences(checked.out, "\n0 queries ");
    CHECK(without == (status == 0 ? 1 : 0));
  };
  prove({}, 1, ": 2 frames, 10 vertices, 10 points, 13 edges, 8 faces\n");
  prove({"--between-parts"}, 1,
        "8 faces, 2 groups of vertices, 2 pairs of groups not asked about: 0-0 1-1, where 0 has vertices 0 to 3, 1 has "
        "vertices 4 to 7\n");
  prove({"--between-parts", "--ignore", "base,top"}, 0,
        "1 group of vertices, 1 pair of groups not asked about: 0-0, where 0 has vertices 0 to 7; no two elements ");
  prove({"--ignore", "base,top"}, 1,
        "2 groups of vertices, 1 pair of groups not asked about: 0-1, where 0 has vertices 0 to 3, 1 has vertices ");
  prove({"--only-between", "base,top"}, 1,
        "3 groups of vertices, 5 pairs of groups not asked about: 0-0 0-2 1-1 1-2 2-2, where ");
  prove({"--only-between", "top,top"}, 1, "2 groups of vertices, 2 pairs of groups not asked about: 0-0 0-1, where ");
  // A motion without the line that leaves a pair out asks for more proofs.
  std::string motion = folder.read("p2/motion.txt");
  motion.erase(motion.find("ignore 0 0\n"), 11);
  std::string proofs = folder.read("p2/proofs.txt");
  proofs.replace(proofs.find("file mesh ") + 10, 64, "-");
  const Run refused = run_checker({folder.write("proofs.txt", proofs)}, {folder.write("motion.txt", motion)});
  CHECK(refused.status == 1);
  CHECK(occurrences(refused.err, "rejected: ") == 1);
}

TEST_CASE("elements in no part are asked about between parts, too") {
  const TemporaryFolder folder;
  const std::string wires = "v 0 0 9\nv 1 1 9\nl 9 10\nv 0 1 9\nv 1 0 9\nl 11 12\n";
  const std::string one = folder.write("w.obj", two_tetrahedra(1) + wires);
  const Run run = mesh({"--check", "--between-parts", one});
  CHECK(run.status == 1);
  CHECK(occurrences(run.out, "edge 9-10 touches edge 11-12") + occurrences(run.out, "edge 9-10 pierces") == 1);
  CHECK(mesh({"--check", "--only-between", "base,top", one}).status == 0);
}

TEST_CASE("two different texts name no part with itself, and a name is no pattern where a part has it") {
  const TemporaryFolder folder;
  // base intersects itself: a triangle through another one.
  const std::string crossing = "o base\nv 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\nv 1 1 -1\nv 1 1 1\nv 1.5 1 1\nf 4 5 6\n";
  const std::string far = "\nv 0 0 9\nv 1 0 9\nv 0 1 9\nf 7 8 9\n", more = "\nv 5 5 5\nv 6 5 5\nv 5 6 5\nf 10 11 12\n";
  const std::string one = folder.write("c.obj", crossing + "o b[a]" + far + "o ba" + more);
  const auto asked = [&](const std::string& parts) {
    const Run run = mesh({"--check", "--only-between", parts, one});
    CAPTURE(parts, run.err);
    CHECK(run.status != 2);
    return verdict(run).substr(verdict(run).find("asked about: "));
  };
  CHECK(asked("*,base") == "asked about: base and b[a], base and ba");
  CHECK(asked("b[a],base") == "asked about: base and b[a]");
  CHECK(asked("base,base") == "asked about: base and base");
  CHECK(mesh({"--check", "--only-between", "base,base", one}).status == 1);
  CHECK(mesh({"--check", "--only-between", "bas?,base", one}).err.find("names no two parts") != std::string::npos);
  const std::string plain = folder.write("plain.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  CHECK(mesh({"--check", "--only-between", "a,b", plain}).err.find("--parts takes the name of each from them") !=
        std::string::npos);
}

TEST_CASE("the least distance is told in the metric, and where there is a contact within the separation") {
  const TemporaryFolder folder;
  const std::string corner = "o a\nv 0 0 0\nv -1 0 0\nv 0 -1 0\nf 1 2 3\no b\nv 3 4 0\nv 4 4 0\nv 3 5 0\nf 4 5 6\n";
  const std::string one = folder.write("m-1.obj", corner);
  CHECK(occurrences(mesh({"--check", "--clearance", one}).out, "; least distance 5: ") == 1);
  const Run most = mesh({"--check", "--clearance", "--metric", "max", one});
  CHECK(occurrences(most.out, "; least distance 4 in the max metric: ") == 1);
  CHECK(occurrences(verdict(most), "; least distance 4 in the max metric (") == 1);
  CHECK(mesh({"--check", "--metric", "max", one}).err.find("--metric requires --separation or --clearance") !=
        std::string::npos);
  std::string nearer = corner;
  nearer.replace(nearer.find("v 3 4 0"), 7, "v 0 1 0");
  const std::string two = folder.write("m-2.obj", nearer);
  const Run within = mesh({"--clearance", "--separation", "2", one, two});
  CHECK(within.status == 1);
  CHECK(occurrences(within.out, "\n  least distance 1: vertex 1 of a and vertex 4 of b, from t = ") +
            occurrences(within.out, "\n  least distance 1: ") >=
        1);
  CHECK(occurrences(verdict(within), "; least distance 1 in m-1.obj -> m-2.obj (") == 1);
}

TEST_CASE("a step from a frame that intersects itself has no distance, in a shard, too") {
  const TemporaryFolder folder;
  std::vector<std::string> files;
  for (int i = 0; i < 4; ++i) files.push_back(folder.write("s-" + std::to_string(i) + ".obj", two_tetrahedra(-0.5)));
  for (const std::string shard : {"1/2", "2/2"}) {
    std::vector<std::string> arguments = {"--clearance", "--shard", shard, "--report",
                                          folder.path(shard.substr(0, 1) + ".json")};
    arguments.insert(arguments.end(), files.begin(), files.end());
    const Run run = mesh(arguments);
    CAPTURE(run.out, run.err);
    CHECK(occurrences(run.out, "free of contact; its first frame intersects itself\n") == (shard == "1/2" ? 2 : 1));
    CHECK(occurrences(run.out, "no two elements") == 0);
  }
}

TEST_CASE("the buffers of a glTF file are not overwritten, and the verdict says what is not in the scene") {
  const TemporaryFolder folder;
  const std::string file = folder.write(
      "a.gltf", R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"translation":[0.5,0,0]},)"
                R"({"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,)"
                R"("componentType":5126,"count":3,"type":"VEC3"}],"bufferViews":[{"buffer":0,"byteLength":36}],)"
                R"("buffers":[{"byteLength":36,"uri":"a.bin"}]})");
  const std::string bytes("\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80\x3f\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80\x3f\0\0\0\0", 36);
  const std::string buffer = folder.write("a.bin", bytes);
  const Run run = mesh({"--check", "--report", buffer, file});
  CHECK(run.status == 2);
  CHECK(folder.read("a.bin") == bytes);
  const Run good = mesh({"--check", "--report", folder.path("r.json"), file});
  CHECK(good.status == 0);
  CHECK(
      verdict(good).find("; 1 mesh of the file is not in its scene, and was not read; the file moves 3 vertices, whose "
                         "positions are rounded to doubles") != std::string::npos);
  CHECK(mesh({"--check", "--report", folder.path("r.json"), "--resume", file}).status == 0);
}

TEST_CASE("files are the parts of one scene, with the numbers and names of each") {
  const TemporaryFolder folder;
  const std::string low = folder.write("low.obj", "o x\nv 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\n"),
                    high = folder.write("high.off", "OFF 3 1 0\n1 1 1\n2 1 2\n1 2 2\n3 0 1 2\n"),
                    wire = folder.write("wire.obj", "v 9 9 9\nv 0.5 0.5 -1\nv 0.5 0.5 0.25\nl 2 3\n"),
                    flat = folder.write("flat.npy", npy_of({"v 0 0\n"}, 1, 2));
  const std::string text_of_three = "v 0 0 0\nv 4 0 0\nv 0 4 0\n";
  const Run run = mesh({"--check", "--parts", "--clearance", "--between-parts", low, high});
  CHECK(run.status == 0);
  CHECK(run.out.starts_with(
      "low.obj + high.off: no intersection; least distance 1: vertex 0 of high and face 1 (1-2-3) of low\n"));
  const Run all = mesh({"--check", "--parts", "--between-parts", low, high, wire, "--report", folder.path("r.json")});
  CHECK(all.status == 1);
  CHECK(occurrences(all.out, "edge 2-3 of wire pierces face 1 (1-2-3) of low") == 1);
  const auto report = nlohmann::json::parse(folder.read("r.json"));
  CHECK(report["frames"][0]["name"] == "low.obj + high.off + wire.obj");
  CHECK(report["results"][0]["intersections"][0]["first"]["part"] == "wire");
  CHECK(mesh({"--check", "--parts", "--only-between", "low,high", low, high, wire}).status == 0);
  CHECK(mesh({"--check", "--parts", "--ignore", "low,wire", low, high, wire}).status == 0);
  folder.write("b/low.obj", two_tetrahedra(5));
  const Run same = mesh({"--check", "--parts", "--only-between", "*,nothing", low, folder.path("b/low.obj")});
  CHECK(occurrences(same.err, "/b/low.obj") == 1);
  const auto refused = [](const std::vector<std::string>& arguments, const std::string& words) {
    const Run bad = mesh(arguments);
    CAPTURE(bad.err, words);
    CHECK(bad.status == 2);
    CHECK(occurrences(bad.err, words) == 1);
  };
  refused({"--check", "--parts", low, low}, "is given twice");
  refused({"--check", "--parts", low, folder.write("bad.obj", "v 0 0 0\nv 1 0 0\nf 1 2 2\n")},
          "bad.obj: face 1 names vertex 2 twice");
  refused({"--check", "--parts", "--topology", low, folder.write("x.npy", npy_of({text_of_three, text_of_three}, 3)),
           folder.write("y.npy", npy_of({text_of_three}, 3))},
          "has 2 frames; it must be one mesh at rest");
  refused({"--check", "--parts", low, flat}, "is a mesh in the plane");
}

TEST_CASE("frames of other parts are refused where parts are asked about") {
  const TemporaryFolder folder;
  const std::string one = folder.write("p-1.obj", two_tetrahedra(1));
  std::string other = two_tetrahedra(2);
  other.replace(other.find("o top"), 5, "o tip");
  const std::string two = folder.write("p-2.obj", other);
  CHECK(mesh({one, two}).status == 0);
  for (const bool check : {false, true}) {
    std::vector<std::string> arguments = {"--only-between", "base,top", one, two};
    if (check) arguments.insert(arguments.begin(), "--check");
    const Run run = mesh(arguments);
    CHECK(run.status == 2);
    CHECK(occurrences(run.err, "the parts have other names") == 1);
  }
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
  refused({"--ignore", "base"}, "must be two names, such as A,B");
  refused({"--ignore", "base,tip"}, "t-1.obj: 'base,tip' names no two parts");
  refused({"--ignore", "*,*"}, "has no two parts that are left to ask about");
  refused({"--ignore", "base,top", "--only-between", "base,top"}, "--only-between excludes --ignore");
  refused({"--between-parts", "--check", "--in-order"}, "parts are those of one mesh");
}

TEST_CASE("the option --weld closes parts, and hides no contact of two of them") {
  const TemporaryFolder folder;
  // Two tetrahedra at one place, each face with vertices of its own.
  const auto tetrahedron = [](const std::string& name, int before) {
    std::string text = "o " + name + "\n";
    for (const char* const face :
         {"0 0 0|0 1 0|1 0 0", "0 0 0|1 0 0|0 0 1", "0 0 0|0 0 1|0 1 0", "1 0 0|0 1 0|0 0 1"}) {
      std::istringstream corners(face);
      for (std::string corner; std::getline(corners, corner, '|');) text += "v " + corner + "\n";
    }
    for (int f = 0; f < 4; ++f) {
      text += "f";
      for (int k = 1; k <= 3; ++k) text += " " + std::to_string(before + 3 * f + k);
      text += "\n";
    }
    return text;
  };
  const std::string same = folder.write("same.obj", tetrahedron("a", 0) + tetrahedron("b", 12));
  const Run welded = mesh({"--check", "--weld", "--drop-degenerate", "--classes", same});
  CAPTURE(welded.out, welded.err);
  CHECK(welded.status == 1);
  CHECK(occurrences(welded.out, "  a and b: same\n") == 1);
  CHECK(occurrences(welded.out, "16 vertices were welded to others at the same positions") == 1);
  CHECK(occurrences(welded.out, "left out") == 0);
  const Run split = mesh({"--check", "--classes", same});
  CHECK(occurrences(split.out, "2 parts are no solid and have no inside") == 1);
}
