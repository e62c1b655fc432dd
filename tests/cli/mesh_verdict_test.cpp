// touchstone mesh: what a verdict was asked about and leaves out, folds, and surfaces inside others.
// SPDX-License-Identifier: MIT
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/mesh_runs.hpp"
#include "sequence/needle.hpp"

using namespace touchstone;
using namespace touchstone::tests;

TEST_CASE("vertices that collide with nothing are counted in the verdict and in the report") {
  const TemporaryFolder folder;
  const std::string one = folder.write("i-1.obj", needle_frame(4, 3) + "v 0 0 99\n"),
                    two = folder.write("i-2.obj", needle_frame(4, 2) + "v 0 0 -99\n");
  const Run run = mesh({one, two, "--report", folder.path("r.json")});
  CHECK(run.status == 0);
  CHECK(run.err == "");
  CHECK(verdict(run).starts_with("1 step, all free (20 vertices, 36 edges, 19 faces"));
  CHECK(verdict(run).ends_with("); 1 vertex in no element was left out"));
  const auto report = nlohmann::json::parse(folder.read("r.json"));
  CHECK(report["mesh"]["idle_vertices"] == 1);
  CHECK(report["warnings"] == nlohmann::json({"1 vertex in no element was left out"}));
}

TEST_CASE("positions without elements are loose points, and the verdict says that it is about nothing else") {
  const TemporaryFolder folder;
  // The needle goes through the cloth, and no vertex meets another one.
  const std::vector<std::string> texts = {needle_frame(5, 0.5), needle_frame(5, -0.5)};
  const std::string array = folder.write("run.npy", npy_of(texts, 28)), topology = folder.write("t.obj", texts[0]);
  const std::string alone = "asked about 28 loose points alone: no file names edges or faces (for arrays: --topology)";
  const Run run = mesh({array, "--report", folder.path("r.json")});
  CHECK(run.status == 0);
  CHECK(verdict(run) == "1 step, all free (28 vertices, 28 loose points); " + alone);
  CHECK(nlohmann::json::parse(folder.read("r.json"))["warnings"] == nlohmann::json({alone}));
  CHECK(verdict(mesh({"--check", array})) ==
        "2 frames, each by itself: no intersection (28 vertices, 28 loose points); " + alone);
  const Run page = mesh({array, "--html", folder.path("p.html")});
  CHECK(occurrences(folder.read("p.html"), "asked about 28 loose points alone") >= 1);
  const Run whole = mesh({"--topology", topology, array});
  CHECK(whole.status == 1);
  CHECK(occurrences(verdict(whole), "alone") == 0);

  std::vector<std::string> points;
  for (const char* name : {"p-1.obj", "p-2.obj"}) points.push_back(folder.write(name, "v 0 0 0\nv 1 0 0\nv 2 0 0\n"));
  CHECK(occurrences(verdict(mesh(points)), "asked about 3 loose points alone: no file names") == 1);
  // A frame of another mesh is counted apart.
  const Run both = mesh({"--check", "--in-order", points[0], topology, "--report", folder.path("b.json")});
  CHECK(
      verdict(both).starts_with("2 frames, each by itself: no intersection (31 vertices, 59 edges, 33 faces, 3 loose "
                                "points in all"));
  CHECK(occurrences(verdict(both), "asked about 3 loose points alone in 1 of 2 frames") == 1);
  CHECK(nlohmann::json::parse(folder.read("b.json"))["frames"][1]["mesh"]["faces"] == 33);
}

TEST_CASE("a mesh of which no two elements could meet is no proof of anything") {
  const TemporaryFolder folder;
  for (const char* text : {"v 0 0 0\n", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "v 0 0 0\nv 1 0 0\nl 1 2\n"}) {
    const Run run = mesh({folder.write("c-1.obj", text), folder.write("c-2.obj", text)});
    CAPTURE(text, run.out);
    CHECK(run.status == 0);
    CHECK(verdict(run).ends_with("); nothing was compared: there are no two elements that could meet"));
  }
}

TEST_CASE("a shard without the first frame says that it did not ask whether it starts free") {
  const TemporaryFolder folder;
  const auto files = write_needles(folder, "f", 5, 6, falling_tip);
  const std::string words = "whether the first frame of this shard intersects itself was not asked";
  CHECK(occurrences(mesh(with({"--shard", "1/2"}, files)).out, words) == 0);
  const Run second = mesh(with({"--shard", "2/2", "--report", folder.path("r.json")}, files));
  CHECK(second.status == 0);  // the needle went through in the first part
  CHECK(verdict(second).starts_with("shard 2/2: 2 steps, all free (28 vertices, "));
  CHECK(verdict(second).ends_with("); " + words));
  CHECK(nlohmann::json::parse(folder.read("r.json"))["warnings"] == nlohmann::json({words}));
  CHECK(occurrences(mesh(with({"--check", "--shard", "2/2"}, files)).out, words) == 0);
}

TEST_CASE("vertices that lie on others are counted where contacts are found, and named as a likely cause") {
  const TemporaryFolder folder;
  // A square of two triangles that are not joined: 0 and -0 are one place. A vertex in no element lies there too.
  const std::string split = "v 0 0 0\nv 1 0 -0\nv 0 1 0\nv 1 0 0\nv 1 1 0\nv -0 1 0\nv 0 1 0\nf 1 2 3\nf 4 5 6\n",
                    one = folder.write("s-1.obj", split), two = folder.write("s-2.obj", split);
  const std::string cause =
      "4 of 7 vertices lie exactly on others: elements that meet there count as contacts; --weld joins such "
      "vertices of one part";
  const Run run = mesh({one, two, "--report", folder.path("r.json")});
  CHECK(run.status == 1);
  CHECK(occurrences(run.out, "s-1.obj: 6 intersections\n  4 vertices lie exactly on others\n") == 1);
  CHECK(occurrences(run.out, "\n" + cause + "\n1 step: 0 free, 1 not free; the first frame has 6 ") == 1);
  const auto report = nlohmann::json::parse(folder.read("r.json"));
  CHECK(report["results"][0]["coinciding_vertices"] == 4);
  CHECK(report["results"][1]["coinciding_vertices"] == 4);
  CHECK(report["warnings"].back() == cause);
  CHECK(occurrences(mesh({"--check", two}).out, cause) == 1);
  const Run welded = mesh({"--weld", one, two, "--report", folder.path("w.json")});
  CHECK(welded.status == 0);
  CHECK(
      verdict(welded) ==
      "1 step, all free (7 vertices, 5 edges, 2 faces); 1 vertex in no element was left out; 2 vertices were welded to "
      "others at the same positions");
  CHECK(nlohmann::json::parse(folder.read("w.json"))["mesh"]["welded_vertices"] == 2);
  // Joined, it is free, and a contact of another cause has no such words.
  CHECK(mesh({"--check", folder.write("j.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n")}).status == 0);
  const auto files = write_needles(folder, "f", 5, 5, falling_tip);
  CHECK(occurrences(mesh(files).out, "exactly on others") == 0);
}

TEST_CASE("elements that fold onto each other are named and counted, at rest and in a step") {
  const TemporaryFolder folder;
  // Two faces over the edge 1-2, the second one within the first; an edge that lies in a face; a path folded back.
  const std::string face = "v 0 0 0\nv 4 0 0\nv 0 4 0\n",
                    onto = folder.write("onto.obj", face + "v 1 1 0\nf 1 2 3\nf 1 2 4\n"),
                    grown = folder.write("grown.obj", face + "v 1 2 0\nf 1 2 3\nl 1 4\n"),
                    path = folder.write("path.obj", "v 0 0 0\nv 4 0 0\nv 1 0 0\nl 1 2\nl 2 3\n");
  const Run two = mesh({"--check", onto, "--report", folder.path("r.json"), "--pairs", folder.path("p.csv")});
  CAPTURE(two.out);
  CHECK(two.status == 1);
  CHECK(two.out.starts_with("onto.obj: 2 intersections, 2 of them folds\n  edge 1-4 folds onto face 1 (1-2-3)\n"));
  CHECK(verdict(two).starts_with("1 frame: 0 without intersections, 1 with 2 intersections, 2 of them folds (4 vert"));
  const auto report = nlohmann::json::parse(folder.read("r.json"));
  CHECK(report["results"][0]["intersections"][0]["sort"] == "folds");
  CHECK(report["counts"]["folds"] == 2);
  CHECK(occurrences(two.out, "exactly on others") == 0);
  CHECK(occurrences(mesh({"--check", "--triangulate", onto}).out, "--triangulate cut") == 0);
  CHECK(occurrences(folder.read("p.csv"), "onto.obj,,folds,,edge,1 4,,,face,1 2 3,1,,,,,,,\n") == 1);
  CHECK(occurrences(mesh({"--check", grown}).out, "  edge 1-4 folds onto face 1 (1-2-3)\n") == 1);
  CHECK(occurrences(mesh({"--check", path}).out, "path.obj: 1 intersection, 1 of them a fold\n") == 1);

  // The end of a path swings through its own next segment.
  const std::string up = folder.write("s-1.obj", "v 0 0 0\nv 4 0 0\nv 1 0 2\nl 1 2\nl 2 3\n"),
                    down = folder.write("s-2.obj", "v 0 0 0\nv 4 0 0\nv 1 0 -2\nl 1 2\nl 2 3\n");
  const Run swing = mesh({up, down, "--queries", folder.path("q")});
  CAPTURE(swing.out, swing.err);
  CHECK(swing.status == 1);
  CHECK(occurrences(swing.out, "first contact at t = 0x1p-1 (0.5), 1 pair\n  vertex 3 and edge 1-2: ") == 1);
  CHECK(run_program({"certify", folder.path("q/point-edge/contacts.csv")}).status == 0);
  // Neighbours along a wire are asked about touching alone, whatever the separation is.
  CHECK(mesh({up, down, "--separation", "0.25", "--queries", folder.path("apart")}).status == 1);
  CHECK(run_program({"certify", folder.path("apart/point-edge/folds.csv")}).status == 0);
  CHECK_FALSE(std::filesystem::exists(folder.path("apart/point-edge/contacts.csv")));
  CHECK(mesh({up, down, "--separation", "0.25", "--html", folder.path("s.html")}).status == 1);
  CHECK(occurrences(folder.read("s.html"), "t = 0.5: vertex 3 and edge 1-2") >= 1);
  CHECK(mesh({"--check", onto, "--html", folder.path("o.html")}).status == 1);
  CHECK(occurrences(folder.read("o.html"), "edge 1-4 folds onto face 1 (1-2-3)") >= 1);
}

TEST_CASE("folds among triangles that were cut from one polygon are told apart from folds of the mesh") {
  const TemporaryFolder folder;
  // An arrowhead, whose triangles from its first corner cover each other, and a convex polygon.
  const std::string faces = "v 0 0 0\nv 4 4 0\nv 1 1.5 0\nv 1 4 0\nf 2 3 4 1\n",
                    more = "v 9 0 0\nv 9 1 0\nv 8 1 0\nv 8 0 0\nf 5 6 7 8\n",
                    words =
                        "; all folds are among triangles of one polygon, which --triangulate cut: cut the polygons in "
                        "the program that wrote the file, if they are not convex";
  const std::string flat = folder.write("flat-1.obj", faces + more), next = folder.write("flat-2.obj", faces + more);
  const Run run = mesh({"--check", "--triangulate", flat, "--html", folder.path("p.html")});
  CAPTURE(run.out);
  CHECK(run.status == 1);
  CHECK(occurrences(run.out, " folds onto face 1 (") > 0);
  CHECK(occurrences(run.out, words + "\n") == 1);
  CHECK(occurrences(folder.read("p.html"), "which --triangulate cut") >= 1);
  CHECK(verdict(mesh({"--triangulate", flat, next})).ends_with(words));
  // A fold of two polygons beside these.
  const Run both =
      mesh({"--check", "--triangulate", folder.write("both.obj", faces + more + "v 8.75 0.5 0\nf 5 6 9\n")});
  CAPTURE(both.out);
  CHECK(both.status == 1);
  CHECK(occurrences(both.out, "--triangulate cut") == 0);
}

TEST_CASE("a closed surface inside another one is named and counted") {
  const TemporaryFolder folder;
  const auto tetrahedron = [](const std::string& a, const std::string& b) {
    return "v " + a + " " + a + " " + a + "\nv " + b + " " + a + " " + a + "\nv " + a + " " + b + " " + a + "\nv " + a +
           " " + a + " " + b + "\n";
  };
  const std::string vertices = tetrahedron("0", "16") + tetrahedron("2", "4"),
                    outer = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n",
                    solid = folder.write("solid.obj", vertices + outer + "f 5 7 6\nf 5 6 8\nf 6 7 8\nf 7 5 8\n"),
                    cavity = folder.write("cavity.obj", vertices + outer + "f 5 6 7\nf 5 8 6\nf 6 8 7\nf 7 8 5\n");
  const Run run = mesh({"--check", solid, "--report", folder.path("r.json"), "--html", folder.path("i.html")});
  CAPTURE(run.out, run.err);
  CHECK(run.status == 1);
  CHECK(
      run.out.starts_with("solid.obj: 1 intersection, 1 of them a part inside a closed surface\n"
                          "  vertex 5 is inside the closed surface of face 1 (1-3-2)\n"));
  CHECK(nlohmann::json::parse(folder.read("r.json"))["counts"]["inside"] == 1);
  CHECK(occurrences(folder.read("i.html"), "vertex 5 is inside the closed surface of face 1") >= 1);
  CHECK(mesh({"--check", cavity}).status == 0);
}

TEST_CASE("parts wholly inside a closed surface are no contact, and the verdict counts them") {
  const TemporaryFolder folder;
  const std::string drum = "v 0 0 0\nv 16 0 0\nv 0 16 0\nv 0 0 16\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n",
                    cloth = "v 2 2 2\nv 4 2 2\nv 2 4 2\nf 5 6 7\n", wires = "v 1 1 2\nv 1 1 3\nv 1 1 4\nl 5 6 7\n",
                    words =
                        " wholly inside a closed surface, which is no contact (vertex 5 inside the surface of face 1)";
  const std::string full =
      folder.write("a-1.obj", drum + cloth + "v 1 1 2\nv 1 1 3\nl 8 9\nv 1 2 1\nv 1 3 1\np 10 11\n");
  const Run run = mesh({"--check", full, "--report", folder.path("r.json"), "--html", folder.path("i.html")});
  CAPTURE(run.out, run.err);
  const std::string all = "1 surface, 1 wire and 2 loose points are" + words;
  CHECK(run.status == 0);
  CHECK(occurrences(run.out, "); " + all + "\n") == 1);
  CHECK(occurrences(folder.read("i.html"), all) >= 1);
  const auto report = nlohmann::json::parse(folder.read("r.json"));
  CHECK(report["warnings"] == nlohmann::json({all}));
  CHECK(report["counts"]["enclosed_parts"] == 4);
  CHECK(report["results"][0]["enclosed_parts"]["vertex"]["vertices"] == nlohmann::json({5}));
  CHECK(verdict(mesh({"--check", folder.write("w.obj", drum + wires)})).ends_with("); 1 wire is" + words));
  // Of steps, the first frame is asked about; of several frames at rest, each.
  const std::string away = folder.write("a-2.obj",
                                        "v 90 0 0\nv 99 0 0\nv 90 9 0\nv 90 0 9\nf 1 3 2\nf 1 2 4\nf 2 3 4\n"
                                        "f 3 1 4\n" +
                                            cloth + "v 1 1 2\nv 1 1 3\nl 8 9\nv 1 2 1\nv 1 3 1\np 10 11\n");
  const Run steps = mesh({full, away, "--report", folder.path("s.json")});
  CHECK(occurrences(verdict(steps), "; " + all) == 1);
  CHECK(nlohmann::json::parse(folder.read("s.json"))["counts"]["enclosed_parts_of_first_frame"] == 4);
  CHECK(verdict(mesh({"--check", full, away}))
            .ends_with("); 1 surface, 1 wire and 2 loose points in 1 of 2 frames are" + words));
  // Outside nothing is said, and of a surface with a hole that it has no inside.
  CHECK(occurrences(mesh({"--check", away}).out, "inside") == 0);
  CHECK(verdict(mesh({"--check", folder.write("h.obj", drum.substr(0, drum.size() - 8) + cloth)}))
            .ends_with("); 1 part is in the box around an open surface, which has no inside"));

  // Shards, put together, are the report of the whole.
  const auto whole = mesh({"--check", full, away, "--report", folder.path("whole.json")});
  for (const char* const shard : {"1", "2"}) {
    mesh({"--check", full, away, "--shard", std::string(shard) + "/2", "--report",
          folder.path(std::string("part") + shard)});
  }
  const Run merged = run_program({"merge", folder.path("part1"), folder.path("part2"), "--out", folder.path("m.json")});
  CAPTURE(merged.out, merged.err);
  CHECK(folder.read("m.json") == folder.read("whole.json"));
}

TEST_CASE("a part in an open surface and a face that turns over are said, with frames of one name in two folders") {
  const TemporaryFolder folder;
  // Three faces of a tetrahedron, and a wire in it; then another face's corner goes through its other edge.
  const std::string shell = "v 0 0 0\nv 8 0 0\nv 0 8 0\nv 0 0 8\nf 1 3 2\nf 1 2 4\nf 2 3 4\n",
                    wire = "v 1 1 1\nv 2 1 1\nl 5 6\n", face = "v 20 0 0\nv 24 0 0\nv 21 1 0\nf 7 8 9\n";
  const std::string before = folder.write("d-1/x.obj", shell + wire + face),
                    after = folder.write("d-2/x.obj", shell + wire + "v 20 0 0\nv 24 0 0\nv 21 -1 0\nf 7 8 9\n");
  const Run run = mesh({before, after, "--report", folder.path("r.json")});
  CAPTURE(run.out, run.err);
  CHECK(run.status == 0);
  CHECK(occurrences(run.out, "d-1/x.obj -> d-2/x.obj: free\n") == 1);
  CHECK(
      verdict(run).ends_with("; 1 part is in the box around an open surface, which has no inside; 1 face may be flat "
                             "at a time of a step: no edges of one face are compared"));
  const auto report = nlohmann::json::parse(folder.read("r.json"));
  CHECK(report["results"][0]["parts_in_open_surfaces"] == 1);
  CHECK(report["results"][1]["turning_faces"] == 1);
  CHECK(mesh({before, after, "--report", folder.path("r.json"), "--resume"}).out == run.out);
  CHECK(occurrences(mesh({"--check", after}).out, "1 part is in the box around an open surface") == 1);
  CHECK(occurrences(mesh({"--check", folder.write("s.obj", shell)}).out, "open surface") == 0);
}

TEST_CASE("closed polygons in the plane are counted, as nothing asks what is inside them") {
  const TemporaryFolder folder;
  const std::string frame = folder.write("p.npy", npy_of({"v 0 0\nv 8 0\nv 0 8\nv 1 1\nv 2 1\nv 1 2\nv 9 9\n"}, 7, 2));
  const auto ending = [&](const std::string& lines) {
    std::string vertices;
    for (int v = 0; v < 7; ++v) vertices += "v 0 0 0\n";
    const std::string said = verdict(mesh({"--check", "--topology", folder.write("t.obj", vertices + lines), frame}));
    const std::size_t at = said.find("; whether anything");
    return at == std::string::npos ? "" : said.substr(at);
  };
  CHECK(ending("l 1 2 3 1\nl 4 5\n") == "; whether anything is inside a closed polygon was not asked");
  CHECK(ending("l 1 2 3 1\np 4\n") == "; whether anything is inside a closed polygon was not asked");
  CHECK(ending("l 1 2 3 1\nl 4 5 6 4\n") == "; whether anything is inside one of 2 closed polygons was not asked");
  CHECK(ending("l 1 2 3 1 4\nl 5 6\n") == "; whether anything is inside a closed polygon was not asked");  // a tail
  CHECK(ending("l 1 2 3 4 1 3\nl 5 6\n") == "; whether anything is inside a closed polygon was not asked");
  CHECK(ending("l 1 2 3 1\n").empty());
  CHECK(ending("l 1 2 3\nl 4 5 6\n").empty());
}

TEST_CASE("a verdict counts bodies inside out, surfaces that branch, corners of several solids and flat faces") {
  const TemporaryFolder folder;
  const std::string outer = "v 0 0 0\nv 16 0 0\nv 0 16 0\nv 0 0 16\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n",
                    corners = "v 1 1 1\nv 2 1 1\nv 1 2 1\nv 1 1 2\n", outwards = "f 5 7 6\nf 5 6 8\nf 6 7 8\nf 7 5 8\n",
                    inwards = "f 5 6 7\nf 5 8 6\nf 6 8 7\nf 7 8 5\n";
  const auto ending = [&](const std::string& name, const std::string& text, int status = 0) {
    const Run run = mesh({"--check", folder.write(name, text), "--report", folder.path("r.json")});
    CAPTURE(run.out, run.err);
    CHECK(run.status == status);
    const auto warnings = nlohmann::json::parse(folder.read("r.json"))["warnings"];
    const std::string said = verdict(run);
    for (const auto& warning : warnings) CHECK(occurrences(said, "; " + warning.get<std::string>()) == 1);
    const std::size_t at = said.find("); ");
    return at == std::string::npos ? std::string() : said.substr(at + 3);
  };
  CHECK(ending("solid.obj", outer + corners + outwards, 1).empty());
  CHECK(ending("inside-out.obj", outer + corners + inwards) ==
        "1 surface is wholly inside a closed surface, which is no contact (vertex 5 inside the surface of face 1)");
  // Face 1-2-5 hangs on an edge of the outer surface: outside, it leaves it closed.
  CHECK(ending("fin.obj", outer + "v 0 0 -9\n" + "f 1 2 5\n").empty());
  // A wall inside, from the edge 1-2 to the middle of the opposite one.
  const std::string walled =
      "v 0 0 0\nv 16 0 0\nv 0 16 0\nv 0 0 16\nv 0 8 8\nf 1 3 2\nf 1 2 4\nf 2 3 5\nf 2 5 4\n"
      "f 3 1 5\nf 5 1 4\nf 1 2 5\n";
  CHECK(ending("wall.obj", walled) ==
        "what is inside what is not known of 1 surface with an edge of three faces or more");
  CHECK(ending("flat.obj", outer + "v 50 0 0\nv 51 0 0\nv 53 0 0\nf 5 6 7\n") ==
        "1 face is flat: that edges of one face lie on each other is no intersection");

  const auto solid = [](const std::string& a, const std::string& b, const std::string& c, const std::string& d) {
    std::string text = "solid\n";
    for (const auto& [p, q, r] : {std::array{a, c, b}, {a, b, d}, {b, c, d}, {c, a, d}}) {
      text +=
          "facet normal 0 0 0\nouter loop\nvertex " + p + "\nvertex " + q + "\nvertex " + r + "\nendloop\nendfacet\n";
    }
    return text + "endsolid\n";
  };
  CHECK(ending("touch.stl", solid("0 0 0", "8 0 0", "0 8 0", "0 0 8") + solid("8 0 0", "9 0 0", "8 1 0", "8 0 1")) ==
        "whether solids touch at 1 vertex that several share was not asked: equal corners were joined");
  CHECK(ending("apart.stl", solid("0 0 0", "8 0 0", "0 8 0", "0 0 8") + solid("9 0 0", "10 0 0", "9 1 0", "9 0 1"))
            .empty());
  // The wedge shares the edge from 0 0 0 to 8 0 0 with the solid around it.
  CHECK(ending("wedge.stl", solid("0 0 0", "8 0 0", "0 8 0", "0 0 8") + solid("0 0 0", "8 0 0", "1 2 1", "1 1 2"), 1) ==
        "whether solids touch at 2 vertices that several share was not asked: equal corners were joined");
}
