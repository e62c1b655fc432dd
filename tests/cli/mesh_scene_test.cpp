// touchstone mesh --parts: parts with frames of their own; separations within a part, and classes of parts.
// SPDX-License-Identifier: MIT
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/mesh_runs.hpp"
#include "cli/run_checker.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

const std::string kPlate = "v 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\n";
constexpr double kHeights[] = {2.5, 1.5, 0.5, -0.5};  // of the lid's lowest corner

std::string lid(double z, int first) {
  const auto corner = [&](int n) { return std::to_string(first + n); };
  return "v 1 1 " + std::to_string(z) + "\nv 2 1 3\nv 1 2 3\nf " + corner(0) + " " + corner(1) + " " + corner(2) + "\n";
}

/// A plate at rest, a lid of four files that falls through it, and an array whose points rise beside both, with numbers
/// from 0.
struct Scene {
  TemporaryFolder folder;
  std::string plate, lids, grains;

  Scene() {
    plate = folder.write("plate.obj", kPlate);
    for (int i = 0; i < 4; ++i) folder.write("lid-" + std::to_string(i + 8) + ".obj", lid(kHeights[i], 1));
    lids = folder.path("lid-*.obj");
    std::vector<std::string> frames;
    for (const char* z : {"1", "2", "3", "4"}) {
      frames.push_back(std::string("v 9 9 ") + z + "\nv 8 8 " + z + "\n");
    }
    grains = folder.write("grains.npy", npy_of(frames, 2));
  }

  std::vector<std::string> arguments(const std::vector<std::string>& more) const {
    return with({"--parts", plate, lids, grains}, more);
  }
};

}  // namespace

TEST_CASE("parts have frames of their own, and the answers are those of one file with the same elements") {
  const Scene scene;
  const Run run = mesh(
      scene.arguments({"--report", scene.folder.path("r.json"), "--clearance", "--pairs", scene.folder.path("p.csv")}));
  CAPTURE(run.out, run.err);
  CHECK(run.status == 1);
  CHECK(occurrences(run.out,
                    "frame 2 -> frame 3: first contact at t = 0x1p-1 (0.5), 1 pair\n"
                    "  vertex 1 of lid and face 1 (1-2-3) of plate: crossing, v against f\n"
                    "  frame 3 then has 2 intersections\n"
                    "    edge 1-2 of lid pierces face 1 (1-2-3) of plate\n") == 1);
  CHECK(verdict(run).ends_with("8 vertices, 6 edges, 2 faces, 2 loose points); 1 of 3 parts is at rest in all frames"));
  CHECK(occurrences(scene.folder.read("p.csv"),
                    "frame 2,frame 3,first,vertex-face,vertex,1,,lid,face,1 2 3,1,plate,") == 1);
  const auto report = nlohmann::json::parse(scene.folder.read("r.json"));
  CHECK(report["scene"].dump() == R"({"at_rest":1,"numbered":0,"parts":3})");
  CHECK(report["frames"][3]["name"] == "frame 3");

  std::vector<std::string> files = {"--report", scene.folder.path("one.json"), "--clearance"};
  for (int i = 0; i < 4; ++i) {
    const std::string z = std::to_string(i + 1);
    files.push_back(scene.folder.write("one-" + z + ".obj",
                                       kPlate + lid(kHeights[i], 4) + "v 9 9 " + z + "\nv 8 8 " + z + "\np 7\np 8\n"));
  }
  CHECK(mesh(files).status == 1);
  const auto one = nlohmann::json::parse(scene.folder.read("one.json"));
  CHECK(one["mesh"] == report["mesh"]);
  CHECK(one["counts"] == report["counts"]);
  REQUIRE(one["results"].size() == report["results"].size());
  for (std::size_t i = 0; i < one["results"].size(); ++i) {
    const auto &a = one["results"][i], &b = report["results"][i];
    CHECK(a["free"] == b["free"]);
    CHECK(a["clearance"]["distance"] == b["clearance"]["distance"]);
    if (!a["free"]) CHECK(a["toi"] == b["toi"]);
  }
}

TEST_CASE("with one part that moves, frames have its names, and a folder is a part") {
  const Scene scene;
  std::filesystem::create_directory(scene.folder.path("arm"));
  for (int i = 0; i < 3; ++i) {
    scene.folder.write("arm/pose-" + std::to_string(i) + ".obj", lid(kHeights[i], 1));
  }
  const Run run = mesh({"--parts", scene.plate, scene.folder.path("arm/")});
  CHECK(run.status == 0);
  CHECK(run.out.starts_with("pose-0.obj: no intersection\npose-0.obj -> pose-1.obj: free\n"));
  const Run named = mesh({"--parts", "--only-between", "arm,plate", scene.plate, scene.folder.path("arm")});
  CHECK(
      verdict(named).ends_with("; nothing but these parts was asked about: plate and arm; 1 of 2 parts is at rest in "
                               "all frames"));
}

TEST_CASE("a scene of moving parts has query files, a page and proofs") {
  const Scene scene;
  const Run run = mesh(scene.arguments({"--queries", scene.folder.path("q"), "--html", scene.folder.path("p.html"),
                                        "--prove", scene.folder.path("proved")}));
  CAPTURE(run.out, run.err);
  CHECK(run.status == 1);
  // The numbers of each file are those of its own vertices.
  CHECK(scene.folder.read("q/vertex-face/contacts.csv") ==
        "# step frame 2 -> frame 3: vertex 1 of lid and face 1 (1-2-3) of plate\n"
        "1,1,1,1,1,2,1\n0,1,0,1,0,1,1\n4,1,0,1,0,1,1\n0,1,4,1,0,1,1\n"
        "1,1,1,1,-1,2,1\n0,1,0,1,0,1,1\n4,1,0,1,0,1,1\n0,1,4,1,0,1,1\n");
  CHECK(run_program({"certify", scene.folder.path("q/vertex-face/contacts.csv")}).status == 0);
  const std::string page = scene.folder.read("p.html");
  CHECK(occurrences(page, "vertex 1 of lid and face 1 (1-2-3) of plate") >= 1);
  CHECK(occurrences(page, R"({"edges":3,"faces":1,"firstNumber":1,"name":"lid","vertices":3})") == 1);
  CHECK(occurrences(page, R"({"edges":0,"faces":0,"firstNumber":0,"name":"grains","vertices":2})") == 1);
  const Run checked = run_checker(scene.folder.path("proved/proofs.txt"), {scene.folder.path("proved/motion.txt")});
  CAPTURE(checked.out, checked.err);
  CHECK(checked.status == 0);
  CHECK(occurrences(checked.out, "1 contact") == 1);
  // The checker compares the frames of each part, in their order, bit by bit; a part at rest has one file.
  REQUIRE(mesh({"--parts", scene.plate, scene.lids, "--prove", scene.folder.path("two")}).status == 1);
  const auto compared = [&](const std::vector<std::string>& patterns) {
    std::vector<std::string> words;
    for (const std::string& pattern : patterns) words.insert(words.end(), {"--frames", pattern});
    words.push_back(scene.folder.path("two/proofs.txt"));
    return run_checker(words, {scene.folder.path("two/motion.txt")});
  };
  const Run same = compared({scene.plate, scene.lids});
  CAPTURE(same.out, same.err);
  CHECK(same.status == 0);
  CHECK(occurrences(same.out, ", whose frames are those of the 5 files: ") == 1);
  CHECK(occurrences(same.out, " at rest (vertices 0 to ") == 1);
  const auto refused = [&](const std::vector<std::string>& patterns, const std::string& words) {
    const Run other = compared(patterns);
    CAPTURE(words, other.err);
    CHECK(other.status == 1);
    CHECK(other.out.empty());
    CHECK(occurrences(other.err, words) == 1);
  };
  const std::string early = scene.folder.path("lid-?.obj");
  refused({scene.lids, scene.plate}, "lid-8.obj and frame 0: the coordinates of vertex 0, counted from 0, differ");
  refused({scene.plate}, "plate.obj and frame 0: 3 vertices, and 6");
  refused({scene.plate, scene.plate}, "plate.obj and frame 0: the coordinates of vertex 0, counted from 0, differ");
  refused({scene.plate, scene.lids, scene.plate}, "plate.obj and frame 0: 3 vertices, and 0");
  refused({scene.plate, early}, "the motion has more frames than --frames names files");
  scene.folder.write("lid-10.obj", "v 1 1 0.5\nv 2 1 3\nv 1 2 3\nf 1 3 2\nf 1 2 3\n");
  CHECK(compared({scene.plate, scene.lids}).status == 0);
  scene.folder.write("lid-10.obj", lid(kHeights[2], 1));
  const Run rest = mesh(
      {"--check", "--parts", scene.plate, scene.folder.path("lid-11.obj"), "--html", scene.folder.path("rest.html")});
  CHECK(rest.status == 1);
  CHECK(occurrences(scene.folder.read("rest.html"), "edge 1-2 of lid-11 pierces face 1 (1-2-3) of plate") >= 1);
}

TEST_CASE("a scene of moving parts is resumed, and made of shards") {
  const Scene scene;
  const std::string whole = scene.folder.path("whole.json");
  const std::vector<std::string> outputs = {"--report", whole};
  CHECK(mesh(scene.arguments(outputs)).status == 1);
  for (const std::string shard : {"1", "2"}) {
    mesh(scene.arguments({"--shard", shard + "/2", "--report", scene.folder.path(shard + ".json")}));
  }
  CHECK(run_program(
            {"merge", "--out", scene.folder.path("m.json"), scene.folder.path("1.json"), scene.folder.path("2.json")})
            .status == 1);
  CHECK(scene.folder.read("m.json") == scene.folder.read("whole.json"));

  CHECK(mesh(scene.arguments(with(outputs, {"--resume"}))).status == 1);
  // A page of results that an earlier run found.
  CHECK(mesh(scene.arguments(with(outputs, {"--resume", "--html", scene.folder.path("again.html")}))).status == 1);
  CHECK(occurrences(scene.folder.read("again.html"), "vertex 1 of lid and face 1 (1-2-3) of plate") >= 1);
  const Run other = mesh({"--parts", "--report", whole, "--resume", scene.plate, scene.grains});
  CHECK(other.status == 2);
  CHECK(occurrences(other.err,
                    "is about a scene of 3 parts with 1 of them at rest, and this run about a scene of 2 "
                    "parts with 1 of them at rest") == 1);
  scene.folder.write("plate.obj", "v 0 0 0\nv 5 0 0\nv 0 4 0\nf 1 2 3\n");
  const Run changed = mesh(scene.arguments(with(outputs, {"--resume"})));
  CHECK(changed.status == 2);
  CHECK(occurrences(changed.err, "frame 0: a file of this frame has changed since") == 1);
}

TEST_CASE("what is no scene of parts that move is refused, and what may be a mistake is in the verdict") {
  const Scene scene;
  const TemporaryFolder& folder = scene.folder;
  const auto refused = [](const std::vector<std::string>& arguments, const std::string& words) {
    check_refused(mesh(with({"--parts"}, arguments)), words);
  };
  std::vector<std::string> each;  // as a shell names them without quotes
  for (int i = 8; i < 12; ++i) each.push_back(folder.path("lid-" + std::to_string(i) + ".obj"));
  refused(with({scene.plate}, each),
          "no part has more than 1; --check --parts asks about parts at rest; the names of 4 parts differ in numbers "
          "only: a pattern in quotes");
  CHECK(verdict(mesh(with({"--parts", scene.grains, scene.plate}, {each[0], each[1]})))
            .ends_with("; 3 of 4 parts are at rest in all frames, and the names of 2 differ in numbers only: frames of "
                       "one part are a pattern in quotes"));
  const std::string three = folder.write("three.npy", npy_of({"v 0 0 7\n", "v 0 0 8\n", "v 0 0 9\n"}, 1));
  refused({scene.plate, three, scene.grains}, "the part grains has 4 frames, and three has 3");
  refused({scene.plate, scene.lids, scene.plate}, "is given twice");
  refused({scene.plate, folder.path("none-*.obj")}, "no file matches this pattern");
  folder.write("gap-1.obj", kPlate), folder.write("gap-2.obj", kPlate), folder.write("gap-4.obj", kPlate);
  refused({scene.plate, folder.path("gap-*.obj")}, "frame 3 is missing");
  folder.write("new-1.obj", kPlate), folder.write("new-2.obj", kPlate + "v 9 9 9\n");
  refused({scene.grains, folder.path("new-*.obj")}, "the part new has 2 frames, and grains has 4");
  const Run other = mesh({"--parts", scene.plate, folder.path("new-*.obj")});  // after the first frame
  CHECK(other.status == 2);
  CHECK(occurrences(other.err, "new-2.obj differs from new-1.obj: 4 vertices, not 3") == 1);
  std::string bad = npy_of({"v 0 0 7\n", "v 0 0 8\n"}, 1);
  const double infinity = std::numeric_limits<double>::infinity();
  bad.replace(bad.size() - 32, 8, reinterpret_cast<const char*>(&infinity), 8);
  refused({scene.plate, folder.write("bad.npy", bad)},
          "bad.npy: vertex 0 of frame 0 has a coordinate that is not finite");
  refused({folder.write("flat.npy", npy_of({"v 0 0\n", "v 0 1\n"}, 1, 2))}, "is a mesh in the plane");
  refused(with(scene.arguments({}), {"--report", scene.plate}), "plate.obj");
  refused(with(scene.arguments({}), {"--in-order"}), "--in-order excludes --parts");
  refused({scene.plate, "--velocity", scene.grains, "--dt", "1"}, "--parts excludes --velocity");
}

TEST_CASE("a separation within a part leaves out its own neighbours, counts them, and finds its folds") {
  // A strip of five squares that is bent, so that its last square comes down to its first one.
  const TemporaryFolder folder;
  const auto strip = [](double height) {
    const std::string z = std::to_string(height);
    std::string text;
    for (const char* y : {"0", "1"}) {
      for (const std::string& xz : {std::string("0 Y 0"), std::string("1 Y 0"), std::string("2 Y 0"),
                                    std::string("2 Y 1"), "1 Y " + z, "0 Y " + z}) {
        text += "v " + xz.substr(0, 2) + y + xz.substr(3) + "\n";
      }
    }
    for (int i = 1; i < 6; ++i) {
      const auto n = [&](int k) { return " " + std::to_string(i + k); };
      text += "f" + n(0) + n(1) + n(7) + n(6) + "\n";
    }
    return text;
  };
  std::vector<std::string> files;
  for (const double height : {2.0, 1.0, 0.5}) {
    files.push_back(folder.write("s-" + std::to_string(files.size()) + ".obj", strip(height)));
  }
  const auto wide = [&](const std::vector<std::string>& more) {
    return mesh(with({"--triangulate", "--separation", "1"}, with(more, files)));
  };
  const Run all = wide({});
  CHECK(all.status == 1);
  CHECK(occurrences(all.out, "pairs are in contact at the start") == 2);
  const std::string hint =
      "are connected by one edge: a surface is always so near itself; --self LENGTH asks such neighbours about "
      "touching "
      "alone, and --between-parts asks about none within a part";
  CHECK(occurrences(all.out, hint + "\n2 steps: ") == 1);
  const Run self = wide({"--self", "1.5", "--report", folder.path("r.json")});
  CAPTURE(self.out, self.err);
  CHECK(occurrences(self.out, "connected by one edge") == 0);
  CHECK(self.status == 1);
  // The neighbours are left out, and the ends of the strip come within the separation in the first step.
  CHECK(occurrences(self.out, "s-0.obj -> s-1.obj: first contact at t = ") == 1);
  const auto report = nlohmann::json::parse(folder.read("r.json"));
  CHECK(report["self"]["length"] == "0x1.8p+0");
  CHECK(report["self"]["frame_sha256"] == report["frames"][0]["sha256"]);
  const std::string count = std::to_string(report["self"]["pairs"].get<int>());
  CHECK(verdict(self).ends_with("; " + count +
                                " pairs that start within the separation and are connected by edges of "
                                "less than 1.5 were asked about touching alone"));
  // A chain that is as long as the strip connects nothing that is not near at the start.
  CHECK(occurrences(wide({"--self", "1000"}).out, "s-0.obj -> s-1.obj: first contact at t = ") == 1);

  CHECK(wide({"--self", "1.5", "--report", folder.path("r.json"), "--resume"}).status == 1);
  const Run other = wide({"--self", "1.25", "--report", folder.path("r.json"), "--resume"});
  CHECK(other.status == 2);
  CHECK(occurrences(other.err,
                    "is about separations within a surface beyond edges of 1.5, and this run about "
                    "separations within a surface beyond edges of 1.25") == 1);
  // The second shard has the pairs of the first frame of all.
  for (const std::string shard : {"1", "2"}) {
    wide({"--self", "1.5", "--shard", shard + "/2", "--report", folder.path(shard + ".json")});
  }
  CHECK(run_program({"merge", "--out", folder.path("m.json"), folder.path("1.json"), folder.path("2.json")}).status ==
        1);
  CHECK(folder.read("m.json") == folder.read("r.json"));

  // The proofs are about the same pairs, and the checker says how many only touch.
  const Run proved = wide({"--self", "1.5", "--prove", folder.path("proved")});
  const Run checked = run_checker(folder.path("proved/proofs.txt"), {folder.path("proved/motion.txt")});
  CAPTURE(proved.out, proved.err, checked.out, checked.err);
  CHECK(proved.status == 1);
  CHECK(checked.status == 0);
  CHECK(count == std::to_string(occurrences(folder.read("proved/motion.txt"), "\ntouching ")));
  CHECK(occurrences(checked.out, ", " + count + " pairs asked about touching alone\n") == 1);
  CHECK(occurrences(proved.out, "itself; asked about touching alone: " + count + " pairs\n") == 1);

  check_refused(mesh(with({"--self", "1"}, files)), "--self requires --separation");
  check_refused(wide({"--self", "0"}), "must be greater than 0");
  check_refused(wide({"--self", "nan"}), "--self: ");
  check_refused(wide({"--self", "1", "--between-parts"}), "--between-parts excludes --self");
}

namespace {

std::string cube(const std::vector<double>& low, const std::vector<double>& high, int first = 1) {
  std::string text;
  for (unsigned v = 0; v < 8; ++v) {
    text += "v";
    for (unsigned k = 0; k < 3; ++k) text += " " + std::to_string((v >> k & 1) != 0 ? high[k] : low[k]);
    text += "\n";
  }
  for (const std::vector<int>& side :
       {std::vector{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}) {
    text += "f";
    for (const int corner : side) text += " " + std::to_string(corner + first);
    text += "\n";
  }
  return text;
}

}  // namespace

TEST_CASE("classes of parts are on the console, in the verdict and in the report") {
  const TemporaryFolder folder;
  const std::vector<std::string> files = {
      folder.write("slab.obj", cube({0, 0, -1}, {4, 4, 0})), folder.write("wall.obj", cube({0, 0, 0}, {4, 0.5, 3})),
      folder.write("pipe.obj", cube({1, -1, 1}, {2, 2, 2})), folder.write("bolt.obj", cube({3, 0, 1}, {3.5, 0.25, 2})),
      folder.write("copy.obj", cube({1, -1, 1}, {2, 2, 2})), folder.write("far.obj", cube({9, 9, 9}, {10, 10, 10}))};
  const std::vector<std::string> question = {"--check", "--parts", "--classes", "--triangulate"};
  const Run run = mesh(with(question, with({"--report", folder.path("r.json")}, files)));
  CAPTURE(run.out, run.err);
  CHECK(run.status == 1);
  CHECK(occurrences(run.out,
                    "\n  slab and wall: touching\n  wall and pipe: overlapping\n  bolt is inside wall\n"
                    "  wall and copy: overlapping\n  pipe and copy: same\n") == 1);
  CHECK(occurrences(verdict(run),
                    "; 5 pairs of parts not clear of each other: 1 touching, 2 overlapping, 1 inside, 1 "
                    "same (48 vertices, ") == 1);
  const auto report = nlohmann::json::parse(folder.read("r.json"));
  CHECK(report["classes"] == true);
  CHECK(report["counts"]["classes"].dump() == R"({"crossing":0,"inside":1,"overlapping":2,"same":1,"touching":1})");
  CHECK(report["results"][0]["classes"][2].dump() == R"({"class":"inside","first":"bolt","second":"wall"})");

  // The report is read again, and is another one without the classes.
  CHECK(mesh(with(question, with({"--report", folder.path("r.json"), "--resume"}, files))).out == run.out);
  const Run other =
      mesh(with({"--check", "--parts", "--triangulate", "--report", folder.path("r.json"), "--resume"}, files));
  CHECK(other.status == 2);
  CHECK(occurrences(other.err, "is about classes of parts, too, and this run about intersections alone") == 1);

  // The rules of parts count, and the exit status is that of the intersections.
  const Run only = mesh(with(question, with({"--only-between", "wall,*"}, files)));
  CHECK(occurrences(only.out, "pipe and copy: same") == 0);
  CHECK(occurrences(only.out, "slab and wall: touching") == 1);
  const Run clear = mesh(with(question, {files[0], files[5]}));
  CHECK(clear.status == 0);
  CHECK(occurrences(verdict(clear), "1 frame, no intersection; all parts are clear of each other (") == 1);

  // Objects of one file are parts, in each of several frames.
  const std::string first = "o a\n" + cube({0, 0, 0}, {1, 1, 1}) + "o b\n";
  const std::vector<std::string> frames = {folder.write("f-1.obj", first + cube({1, 0, 0}, {2, 1, 1}, 9)),
                                           folder.write("f-2.obj", first + cube({2, 0, 0}, {3, 1, 1}, 9))};
  const Run objects = mesh(with({"--check", "--classes", "--triangulate"}, frames));
  CHECK(occurrences(objects.out, "\n  a and b: touching\n") == 1);
  CHECK(occurrences(verdict(objects), "; 1 pair of parts not clear of each other: 1 touching (") == 1);

  check_refused(mesh(with({"--classes", "--triangulate"}, frames)), "--classes requires --check");
  check_refused(mesh({"--check", "--classes", "--triangulate", files[0]}), "slab.obj: has no two parts for --classes");
  const std::string shared =
      folder.write("shared.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\no a\nf 1 2 3\no b\nf 2 4 3\n");
  check_refused(mesh({"--check", "--classes", shared}), "vertex 2 is in the parts a and b");
  check_refused(mesh(with({"--check", "--in-order", "--classes", "--triangulate"}, frames)), "--in-order: ");
}
