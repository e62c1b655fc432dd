// touchstone mesh: what it says and writes about a needle that falls through a cloth, and input that it refuses.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/mesh_runs.hpp"
#include "io/sealed_json.hpp"
#include "io/times.hpp"
#include "sequence/needle.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

constexpr const char* kPlanted =
    "f-2.obj -> f-3.obj: first contact at t = 0x1p-1 (0.5), 1 pair\n"
    "  vertex 26 of needle and face 11 (7-8-12) of cloth: crossing, v against f\n"
    "  f-3.obj then has 2 intersections\n"
    "    edge 26-27 of needle pierces face 11 (7-8-12) of cloth\n"
    "    edge 26-28 of needle pierces face 11 (7-8-12) of cloth\n";

}  // namespace

TEST_CASE("a sequence that is free: a line for each step, and status 0") {
  const TemporaryFolder folder;
  write_needles(folder, "r", 4, 3, rising_tip);
  const Run run = mesh({folder.path("r-*.obj")});
  CAPTURE(run.err);
  CHECK(run.status == 0);
  CHECK(run.err == "");
  CHECK(run.out.starts_with("r-0.obj: no intersection\nr-0.obj -> r-1.obj: free\nr-1.obj -> r-2.obj: free\n2 steps, "));
  CHECK(verdict(run) == "2 steps, all free (19 vertices, 36 edges, 19 faces)");
}

TEST_CASE("a planted crossing is named by frame, pair and exact time, in every file") {
  const TemporaryFolder folder;
  const auto files = write_needles(folder, "f", 5, 6, falling_tip);
  const Run run = mesh(with({"--report", folder.path("r.json"), "--pairs", folder.path("p.csv")}, files));
  CAPTURE(run.err);
  CHECK(run.status == 1);
  CHECK(run.err == "");
  CHECK(occurrences(run.out, kPlanted) == 1);
  // A step without contact from a frame in which the needle is through the cloth is told apart.
  CHECK(occurrences(run.out, "f-4.obj -> f-5.obj: free of contact; its first frame intersects itself\n5 steps: ") == 1);
  CHECK(verdict(run).starts_with("5 steps: 4 free, 1 not free (28 vertices, "));
  CHECK(verdict(run).ends_with("); 2 free steps start from a frame that intersects itself"));

  const std::string report = folder.read("r.json");
  CHECK(io::seal_holds(report));
  const auto json = nlohmann::json::parse(report);
  CHECK(json["counts"]["not_free"] == 1);
  CHECK(json["counts"]["free_from_intersecting_frame"] == 2);
  CHECK(json["frames"][3]["name"] == "f-3.obj");
  const auto& step = json["results"][3];
  CHECK(step["from"] == 2);
  CHECK(step["toi"] == "0x1p-1");
  CHECK(step["toi_upper"] == "0x1p-1");
  CHECK(step["first"].size() == 1);
  CHECK(step["first"][0]["first"]["vertices"] == nlohmann::json({26}));
  CHECK(step["first"][0]["second"]["vertices"] == nlohmann::json({7, 8, 12}));
  CHECK(step["first"][0]["second"]["number"] == 11);
  CHECK(step["first"][0]["second"]["part"] == "cloth");
  CHECK(step["intersections"].size() == 2);
  CHECK(occurrences(folder.read("p.csv"),
                    "\nf-2.obj,f-3.obj,first,vertex-face,vertex,26,,needle,face,7 8 12,11,cloth,0.5,0.5,"
                    "crossing,v,f,\n") == 1);
  CHECK(folder.names().count("r.json.progress") == 0);
}

TEST_CASE("the option --report - writes the report in place of the summary") {
  const TemporaryFolder folder;
  const auto files = write_needles(folder, "f", 4, 4, falling_tip);
  const Run to_file = mesh(with({"--report", folder.path("r.json")}, files));
  const Run run = mesh(with({"--report", "-"}, files));
  CHECK(run.status == 1);
  CHECK(run.out == folder.read("r.json"));
}

TEST_CASE("the option --json writes a line for each result with decimals, and the verdict beside them") {
  const TemporaryFolder folder;
  const auto files = write_needles(folder, "f", 4, 4, falling_tip);
  const Run run = mesh(with({"--json", "--clearance", "--pairs", folder.path("p.csv"), "--numbers", "hex"}, files));
  CHECK(run.status == 1);
  CHECK(run.err == verdict(mesh(with({"--clearance"}, files))) + "\n");
  const auto lines = lines_of(run.out);
  REQUIRE(lines.size() == 4);
  const auto first = nlohmann::json::parse(lines[0]), step = nlohmann::json::parse(lines[3]);
  CHECK(first["frame"] == "f-0.obj");
  CHECK(first["free"] == true);
  CHECK(step["from"] == "f-2.obj");
  CHECK(step["to"] == "f-3.obj");
  CHECK(step["toi"] == 0.5);
  CHECK(step["first"].size() == 1);
  CHECK(nlohmann::json::parse(lines[1])["clearance"]["distance"].is_number());
  CHECK(occurrences(folder.read("p.csv"), ",cloth,0x1p-1,0x1p-1,crossing,v,f,\n") == 1);
  check_refused(mesh(with({"--json", "--report", "-"}, files)), "--report: standard output has the lines of --json");
}

TEST_CASE("the number of threads changes nothing, and neither does the order of the arguments") {
  const TemporaryFolder folder;
  auto files = write_needles(folder, "f", 12, 12, falling_tip);
  std::string report, out;
  for (const char* threads : {"1", "2", "4"}) {
    std::vector<std::string> order(files.rbegin(), files.rend());
    std::swap(order[2], order[7]);
    const Run run = mesh(with({"--threads", threads, "--report", folder.path("r.json")}, order));
    CHECK(run.status == 1);
    if (report.empty()) {
      report = folder.read("r.json");
      out = run.out;
    }
    CHECK(folder.read("r.json") == report);
    CHECK(run.out == out);
  }
  CHECK(occurrences(out, "f-9.obj -> f-10.obj: ") == 1);
  CHECK(out.starts_with("f-0.obj: "));
}

TEST_CASE("the option --queries writes the pairs for certify and explain") {
  const TemporaryFolder folder;
  const auto files = write_needles(folder, "f", 5, 5, falling_tip);
  const Run run = mesh(with({"--queries", folder.path("q")}, files));
  CHECK(run.status == 1);
  const std::string queries = folder.path("q/vertex-face/contacts.csv");
  CHECK(occurrences(run.out, "    touchstone explain --query 0 " + queries + "\n") == 1);
  CHECK(run_program({"certify", queries}).status == 0);
  const Run explained = run_program({"explain", "--query", "0", queries});
  CHECK(explained.status == 0);
  CHECK(occurrences(explained.out, "answer: crossing contact, first at t = 0x1p-1 (0.5)") == 1);

  // A later run without contact leaves no file that would pass for its own.
  const auto other = folder.write("q/vertex-face/mine.csv", "");
  CHECK(mesh({"--queries", folder.path("q"), files[0], files[1]}).status == 0);
  CHECK_FALSE(std::filesystem::exists(queries));
  CHECK(std::filesystem::exists(other));
}

TEST_CASE("with a separation the contact is earlier, and pairs that start within it are told apart") {
  const TemporaryFolder folder;
  const auto files = write_needles(folder, "f", 5, 4, falling_tip);
  const std::vector<std::string> separation = {"--separation", "0.25", "--queries", folder.path("q")};
  const Run run = mesh(with(separation, files));
  CAPTURE(run.out);
  CHECK(run.status == 1);
  // The tip is at 0.25 at t = 0.5 of the step 1 -> 2; step 2 -> 3 starts within the separation.
  CHECK(occurrences(run.out,
                    "f-1.obj -> f-2.obj: first contact at t = 0x1p-1 (0.5), 1 pair\n"
                    "  vertex 26 of needle and face 11 (7-8-12) of cloth: entering, v against f\n") == 1);
  CHECK(occurrences(run.out, "f-2.obj -> f-3.obj: ") == 1);
  CHECK(occurrences(run.out, "1 pair is in contact at the start") == 1);
  CHECK(verdict(run).starts_with("3 steps: 1 free, 2 not free (28 vertices, "));
  // An edge is always near its neighbours. Faces have 3 * 33 corners; vertices of the degree d have d (d - 1) / 2 pairs
  // of edges: those of the cloth 2 * 1 + 2 * 3 + 12 * 6 + 9 * 15, and those of the needle 3 * 1.
  CHECK(verdict(run).ends_with(
      "; 317 pairs with a common vertex asked about folding alone; separation 0x1p-2 (0.25), euclidean)"));
  const std::string queries = folder.path("q/vertex-face/contacts.csv");
  CHECK(folder.read("q/vertex-face/contacts.csv").starts_with("# separation 0x1p-2 euclidean\n"));
  CHECK(run_program({"certify", queries}).status == 0);
}

TEST_CASE("a file may hold several frames, whose elements are in another file") {
  const TemporaryFolder folder;
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < 5; ++i) texts.push_back(needle_frame(5, falling_tip(i)));
  const std::string topology = folder.write("topology.obj", texts[0]), run = folder.write("run.npy", npy_of(texts, 28));
  const Run whole = mesh({"--topology", topology, "--report", folder.path("whole.json"), run});
  CAPTURE(whole.err, whole.out);
  CHECK(whole.status == 1);
  CHECK(occurrences(whole.out, "run.npy[2] -> run.npy[3]: first contact at t = 0x1p-1 (0.5), 1 pair\n") == 1);
  CHECK(verdict(whole).starts_with("4 steps: 3 free, 1 not free ("));
  for (const char* number : {"1", "2", "3"}) {
    CHECK(mesh({"--topology", topology, "--shard", std::string(number) + "/3", "--report",
                folder.path(std::string("part-") + number + ".json"), run})
              .status < 2);
  }
  CHECK(run_program({"merge", folder.path("part-1.json"), folder.path("part-2.json"), folder.path("part-3.json"),
                     "--out", folder.path("merged.json")})
            .status == 1);
  CHECK(folder.read("merged.json") == folder.read("whole.json"));

  const std::string twice = folder.write("twice.obj", texts[0] + "f 7 8 12\n");
  check_refused(mesh({"--topology", twice, run}), "twice.obj: face ");
}

TEST_CASE("a step ends where velocities lead, and the verdict says so") {
  const TemporaryFolder folder;
  const std::string text = "v -9 -9 0\nv 9 -9 0\nv 0 9 0\nv 0 0 1\nf 1 2 3\np 4\n";
  const std::string frame = folder.write("a.obj", text);
  const std::string velocity = folder.write("v.npy", npy_of({"v 0 0 0\nv 0 0 0\nv 0 0 0\nv 0 0 -2\n"}, 4));
  const Run run = mesh({frame, "--velocity", velocity, "--dt", "1", "--report", folder.path("r.json")});
  CHECK(run.status == 1);
  CHECK(occurrences(run.out, "a.obj -> a.obj + 1 v.npy: first contact at t = 0x1p-1 (0.5), 1 pair") == 1);
  CHECK(verdict(run).ends_with("; the step ends at the positions and 1 times the velocities, rounded to doubles"));
  CHECK(occurrences(folder.read("r.json"), "\n \"dt\": \"0x1p+0\",\n") == 1);
  const Run resumed = mesh({frame, "--velocity", velocity, "--dt", "1", "--report", folder.path("r.json"), "--resume"});
  CHECK(resumed.status == 1);
  CHECK(mesh({frame, "--velocity", velocity, "--dt", "0.25"}).status == 0);
  check_refused(mesh({frame, "--velocity", velocity, "--dt", "2", "--report", folder.path("r.json"), "--resume"}),
                "is about velocities and dt = 1, and this run about velocities and dt = 2");
  check_refused(mesh({frame, "--velocity", velocity}), "--velocity requires --dt");
  check_refused(mesh({frame, "--velocity", velocity, "--dt", "x"}),
                "--dt: x is no finite number; right is, for example");
  // A fraction is the double that is nearest to it, and velocities may be text.
  const auto dt_of = [&](const std::string& file, const std::string& dt) {
    CHECK(mesh({frame, "--velocity", file, "--dt", dt, "--report", folder.path("dt.json")}).status < 2);
    const std::string report = folder.read("dt.json");
    const std::size_t at = report.find("\"dt\"");
    return report.substr(at, report.find('\n', at) - at);
  };
  CHECK(dt_of(velocity, "1/60") == "\"dt\": \"" + io::hexfloat(1.0 / 60) + "\",");
  CHECK(dt_of(velocity, "0.5/0x1p2") == "\"dt\": \"0x1p-3\",");
  check_refused(mesh({frame, "--velocity", velocity, "--dt", "1/0"}), "--dt: 1/0 is no finite number");
  check_refused(mesh({frame, "--velocity", velocity, "--dt", "1/59.94"}),
                "--dt: 1/59.94 has '59.94', which is no double");
  check_refused(mesh({frame, "--velocity", velocity, "--dt", "1/60/2"}), "--dt: 1/60/2 has '60/2', which is no double");
  for (const auto& [name, content] : std::vector<std::pair<std::string, std::string>>{
           {"v.csv", "vx,vy,vz\n0,0,0\n0,0,0\n0,0,0\n0,0,-2\n"},
           {"w.csv", "x;y;z\r\n0;0;0\r\n0;0;0\r\n0;0;0\r\n0;0;-2\r\n"},
           {"v.txt", "# numpy.savetxt\n0.0e+00 0.0e+00 0\n0 0 0\n\n0 0 0\n0 0 -2.000000000000000000e+00\n"}}) {
    const std::string text_file = folder.write(name, content);
    const Run of_text = mesh({frame, "--velocity", text_file, "--dt", "1", "--report", folder.path("text.json")});
    CAPTURE(of_text.out, of_text.err);
    CHECK(of_text.status == 1);
    CHECK(occurrences(of_text.out, "first contact at t = 0x1p-1 (0.5), 1 pair") == 1);
  }
  for (const auto& [content, message] : std::vector<std::pair<std::string, std::string>>{
           {"", "x.csv: holds no row x,y,z"},
           {"0,0,0\n0,0\n", "x.csv:2: 2 columns; each row is x,y,z of a vertex, or x,y in the plane"},
           {"0,0,x\n", "x.csv:1: z is 'x', which is no finite number"},
           {"0;0,5;1\n", "x.csv:1: column 2 is '0,5'; a number has a point, such as 0.5, and no comma"},
           {"z,y,x\n0,0,0\n", "x.csv:1: column 1 is called 'z'; the columns are x, y and z"},
           {"vz,vy,vx\n0,0,0\n", "x.csv:1: column 1 is called 'vz'; the columns are x, y and z"},
           {"0,0,0\n0,0,-6", "x.csv:2: the last row does not end with an end of line: the file may be cut off here"},
           {"0,0,0\n", "x.csv: has 1 velocities of 3 coordinates; the frame has 4 vertices of 3"}}) {
    const Run refused = mesh({frame, "--velocity", folder.write("x.csv", content), "--dt", "1"});
    CHECK(refused.status == 2);
    CHECK(refused.err.ends_with(message + "\n"));
  }
  check_refused(mesh({frame, "--velocity", velocity, "--dt", "1", "--check"}), "--check");
  check_refused(mesh({frame, folder.write("b.obj", text), "--in-order", "--velocity", velocity, "--dt", "1"}),
                "goes from one frame, and there are 2");
  // Vertices that are welded stay together.
  const std::string split =
      folder.write("s.obj", "v 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nf 1 2 3\nf 4 5 6\n");
  const std::string apart =
      folder.write("t.npy", npy_of({"v 0 0 0\nv 0 0 0\nv 0 0 0\nv 0 0 -4\nv 0 0 0\nv 0 0 0\n"}, 6));
  CHECK(occurrences(mesh({split, "--velocity", apart, "--dt", "1", "--weld"}).err, "vertices 2 and 4 are apart in") ==
        1);
  check_refused(mesh({frame, "--velocity", frame, "--dt", "1"}), "is a mesh, whose positions are no velocities");
  const std::string twice = folder.write("u.npy", npy_of({"v 0 0 0\n", "v 0 0 0\n"}, 1));
  check_refused(mesh({frame, "--velocity", twice, "--dt", "1"}), "has 2 frames; velocities are those of one step");
  const std::string other = folder.write("w.npy", npy_of({"v 0 0 0\n"}, 1));
  CHECK(mesh({frame, "--velocity", other, "--dt", "1"}).err.find("has 1 velocities of 3 coordinates") !=
        std::string::npos);
}

TEST_CASE("the option --check asks about frames at rest, whatever their elements and numbers are") {
  const TemporaryFolder folder;
  const auto files = write_needles(folder, "f", 5, 5, falling_tip);
  const std::string other = folder.write("g-9.obj", needle_frame(4, 1));
  const Run run = mesh({"--check", "--in-order", files[4], other, files[0], "--report", folder.path("r.json")});
  CAPTURE(run.err);
  CHECK(run.status == 1);
  CHECK(run.out.starts_with(
      "f-4.obj: 2 intersections\n"
      "  edge 26-27 of needle pierces face 11 (7-8-12) of cloth\n"
      "  edge 26-28 of needle pierces face 11 (7-8-12) of cloth\n"
      "g-9.obj: no intersection\nf-0.obj: no intersection\n3 frames, each by itself: 2 without intersections, 1 with "
      "2 intersections (75 vertices, 154 edges, 85 faces in all"));
  CHECK(nlohmann::json::parse(folder.read("r.json"))["results"][0]["intersections"].size() == 2);
  const Run free = mesh({"--check", files[1]});
  CHECK(free.status == 0);
  CHECK(free.out.starts_with("f-1.obj: no intersection\n1 frame, no intersection (28 vertices, 59 edges, 33 faces"));
  check_refused(mesh({"--check", "--separation", "1", files[0]}), "excludes");
}

TEST_CASE("a first frame that intersects itself is not free") {
  const TemporaryFolder folder;
  const std::string one = folder.write("x-1.obj", needle_frame(5, -1)),
                    two = folder.write("x-2.obj", needle_frame(5, -2));
  const Run run = mesh({one, two});
  CHECK(run.status == 1);
  CHECK(run.out.starts_with("x-1.obj: 2 intersections\n"));
  CHECK(occurrences(run.out, "x-1.obj -> x-2.obj: free of contact; its first frame intersects itself\n1 step, ") == 1);
  CHECK(verdict(run).starts_with("1 step, all free; the first frame has 2 intersections (28 vertices, "));
  CHECK(verdict(run).ends_with("); 1 free step starts from a frame that intersects itself"));
}

TEST_CASE("long lists are cut on the console, and not in the report") {
  const TemporaryFolder folder;
  // Nine spikes of one height fall on a large triangle: nine pairs come first.
  std::vector<std::string> files;
  for (int frame = 0; frame < 2; ++frame) {
    std::string text = "v -99 -99 0\nv 99 -99 0\nv 0 99 0\n", faces = "f 1 2 3\n";
    const int z = 1 - 2 * frame, top = 91 - 2 * frame;
    for (int i = 0; i < 9; ++i) {
      char lines[200];
      const int x = 3 * i, corner = 3 * i + 4;
      std::snprintf(lines, sizeof lines, "v %d 0 %d\nv %d 1 %d\nv %d 0 %d\n", x, z, x, top, x + 1, top);
      text += lines;
      std::snprintf(lines, sizeof lines, "f %d %d %d\n", corner, corner + 1, corner + 2);
      faces += lines;
    }
    files.push_back(folder.write(frame == 0 ? "s0.obj" : "s1.obj", text + faces));
  }
  const Run run = mesh(with({"--report", folder.path("r.json")}, files));
  CHECK(run.status == 1);
  CHECK(occurrences(run.out, "first contact at t = 0x1p-1 (0.5), 9 pairs\n") == 1);
  CHECK(occurrences(run.out, "crossing, v against f") == 5);
  CHECK(occurrences(run.out, "  and 4 more\n") == 1);
  const auto json = nlohmann::json::parse(folder.read("r.json"));
  CHECK(json["results"][1]["first"].size() == 9);
  CHECK(json["results"][1]["intersections"].size() == 18);
}

TEST_CASE("frames that do not make a sequence are refused, and nothing is written") {
  const TemporaryFolder folder;
  const auto files = write_needles(folder, "f", 4, 5, rising_tip);
  const std::string report = folder.path("r.json");
  const auto refused = [&](std::vector<std::string> arguments, const std::string& part) {
    check_refused(mesh(with({"--report", report}, arguments)), part);
    CHECK_FALSE(std::filesystem::exists(report));
    CHECK_FALSE(std::filesystem::exists(report + ".progress"));
  };
  refused({files[0], files[1], files[3]},
          "f-3.obj: frame 2 is missing between f-1.obj and f-3.obj; other frames of the sequence are 1 apart. "
          "--in-order takes the files");
  refused({files[0], files[1], folder.write("f-01.obj", "")}, "has the same number as f-1.obj");
  refused({files[0]}, "a step needs two frames, and there is only 1; --check asks about frames at rest");
  refused({folder.path("none-*.obj")}, "none-*.obj: is no file, and no file matches this pattern");
  refused({"--in-order", files[0], folder.path("none.obj")}, "none.obj: cannot be opened: No such file or directory");
  refused({files[0], files[1], "--shard", "2/2"},
          "--shard 2/2: there is only 1 step, which at most 1 shard can divide");
  for (const char* shard : {"0/2", "3/2", "1", "1/", "/2", "1/0", "-1/2", "a/b", "1/2/3"}) {
    refused({files[0], files[1], "--shard", shard}, "must be two whole numbers, such as 2/4");
  }
  std::string flat = needle_frame(4, 1);
  flat.replace(flat.find("f 2 6 5\n"), 8, "f 2 6 2\n");
  refused({"--in-order", folder.write("flat.obj", flat), files[0]}, "flat.obj: face 2 names vertex 2 twice");
  refused({"--in-order", folder.write("x.obj", "v 1 2\n"), files[0]}, "x.obj:1: ");
}

TEST_CASE("the parts of one scene in several files do not pass for its frames") {
  const TemporaryFolder folder;
  // Two tetrahedra that pierce each other, each in a file of its own.
  const std::string faces = "f 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n",
                    rod = folder.write("rod.obj", "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\n" + faces),
                    ring = folder.write("ring.obj", "v 1 1 -1\nv 5 1 -1\nv 1 5 -1\nv 1 1 3\n" + faces);
  const std::string which =
      "ring.obj: the name differs from rod.obj in more than numbers. --in-order takes the files as the frames of one "
      "animation in the order given, and --check --in-order asks about each by itself; --parts asks about the parts of "
      "one scene together, and with --check at rest\n";
  check_refused(mesh({rod, ring}), which);
  check_refused(mesh({"--check", rod, ring}), which);
  CHECK(mesh({"--in-order", "--check", ring, rod}).out.starts_with("ring.obj: no intersection\nrod.obj: no "));
  const Run frames = mesh({"--in-order", ring, rod});
  CHECK(frames.status == 0);
  CHECK(occurrences(frames.out, "ring.obj -> rod.obj: free\n") == 1);

  // Numbered names with other elements are no frames either.
  const std::string one = folder.write("part-1.obj", "v 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\n"),
                    two = folder.write("part-2.obj", "v 1 1 -1\nv 1 1 1\nl 1 2\n");
  const Run parts = mesh({"--check", one, two});
  CHECK(parts.status == 2);
  CHECK(occurrences(parts.err, "part-2.obj: part-2.obj differs from part-1.obj: 2 vertices, not 3; all frames") == 1);
  CHECK(occurrences(parts.err, "--check --in-order about each file by itself\n") == 1);
  CHECK(mesh({"--check", "--in-order", one, two}).status == 0);
}

TEST_CASE("with --in-order numbers do not sort the files that are given, but those of a pattern") {
  const TemporaryFolder folder;
  const auto files = write_needles(folder, "f", 4, 11, rising_tip);
  const Run given = mesh({"--in-order", files[10], files[2], files[2]});
  CHECK(given.status == 0);
  CHECK(given.out.starts_with("f-10.obj: no intersection\nf-10.obj -> f-2.obj: free\nf-2.obj -> f-2.obj: free\n"));
  const Run pattern = mesh({"--in-order", folder.path("f-*.obj")});
  CHECK(pattern.status == 0);
  CHECK(occurrences(pattern.out, "f-2.obj -> f-3.obj: free\n") == 1);
}

TEST_CASE("a file that is given twice is a mistake, except where an animation may hold a frame or return to it") {
  const TemporaryFolder folder;
  const std::string text = needle_frame(4, 1), one = folder.write("f-1.obj", text), two = folder.write("f-2.obj", text),
                    other = folder.path("./f-1.obj"), words = "; its frames would count twice: name it once\n";
  std::filesystem::create_symlink(one, folder.path("f-3.obj"));
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{}, {"--check"}, {"--in-order"}, {"--in-order", "--check"}}) {
    check_refused(mesh(with(options, {one, one})), one + ": is given twice" + words);
    check_refused(mesh(with(options, {one, other})), other + ": is the same file as " + one + words);
    CHECK(mesh(with(options, {one, two, folder.path("f-3.obj")})).status == 0);
  }
  check_refused(mesh({one, two, one}), one + ": is given twice" + words);
  check_refused(mesh({"--check", "--in-order", one, two, one}), one + ": is given twice" + words);
  CHECK(occurrences(mesh({"--in-order", one, two, one}).out, "f-2.obj -> f-1.obj: free\n2 steps, all free") == 1);
  // Several frames of one file are several frames.
  const std::string array = folder.write("run.npy", npy_of({text, text}, 19));
  CHECK(mesh({"--in-order", array, array}).status == 0);
  check_refused(mesh({"--check", "--in-order", array, array}), array + ": is given twice");
}

TEST_CASE("a frame with other elements ends the run, and both frames are named") {
  const TemporaryFolder folder;
  const auto files = write_needles(folder, "f", 4, 2, rising_tip);
  std::string turned = needle_frame(4, 1);
  turned.replace(turned.find("f 2 6 5\n"), 8, "f 2 5 6\n");
  std::string named = needle_frame(4, rising_tip(1));
  named.replace(named.find("o needle"), 8, "o other");
  const auto check = [&](const std::string& text, const std::string& part) {
    const Run run = mesh({"--threads", "1", "--in-order", files[0], folder.write("other.obj", text)});
    CAPTURE(run.err);
    CHECK(run.status == 2);
    CHECK(run.out == "f-0.obj: no intersection\n");
    CHECK(occurrences(run.err, "\n") == 1);
    CHECK(occurrences(run.err, "/other.obj: other.obj differs from f-0.obj: " + part) == 1);
  };
  check(needle_frame(5, 1), "28 vertices, not 19; all frames of a sequence must have the same vertices and elements. ");
  check(turned, "face 2 has the vertices 2 5 6, not 2 6 5; ");
  check(needle_frame(4, 1) + "l 1 2\n", "1 edges, not 0; ");
  CHECK(mesh({"--in-order", files[0], folder.write("other.obj", named)}).status == 0);  // only a name is another one
}

TEST_CASE("files that would take each other's place are refused") {
  const TemporaryFolder folder;
  const auto files = write_needles(folder, "f", 4, 2, rising_tip);
  const std::string before = folder.read("f-0.obj");
  check_refused(mesh(with({"--report", files[0]}, files)), "what is written is JSON");
  check_refused(mesh(with({"--pairs", files[1]}, files)), "what is written is CSV");
  const std::string out = folder.path("out");
  check_refused(mesh(with({"--report", out, "--pairs", out}, files)), "which another option names too");
  check_refused(mesh(with({"--report", out, "--pairs", out + ".progress"}, files)), "which another option names too");
  check_refused(mesh(with({"--pairs", "-"}, files)), "--pairs: name a file to write");
  check_refused(mesh(with({"--resume", "--report", "-"}, files)), "--resume: name the report's file");
  check_refused(mesh(with({"--resume"}, files)), "--report");
  CHECK(folder.read("f-0.obj") == before);
  CHECK(folder.names() == std::set<std::string>{"f-0.obj", "f-1.obj"});
}

TEST_CASE("names from files cannot write control characters to the console or break the report") {
  const TemporaryFolder folder;
  std::vector<std::string> files;
  for (const double tip : {0.125, -0.125}) {
    std::string text = needle_frame(4, tip);
    text.replace(text.find("o needle"), 8, "o \x1b[31mred\xff\"'");
    files.push_back(folder.write(tip > 0 ? "a.obj" : "b\xff\n.obj", text));
  }
  const Run run = mesh(with({"--report", folder.path("r.json"), "--pairs", folder.path("p.csv"), "--in-order"}, files));
  CAPTURE(run.err);
  CHECK(run.status == 1);
  CHECK(run.out.find('\x1b') == std::string::npos);
  CHECK(occurrences(run.out, "of \\x1b[31mred\\xff\"'") >= 1);
  CHECK(occurrences(run.out, "a.obj -> b\\xff\\n.obj: first contact") == 1);
  CHECK(nlohmann::json::parse(folder.read("r.json"))["frames"][1]["name"] == "b\\xff\\n.obj");
}
