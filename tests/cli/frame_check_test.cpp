// The checker of proofs compares the frames' own files with the motion that was proved.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstring>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "cli/motion_proof_runs.hpp"
#include "sequence/needle.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

/// An OBJ file as a binary PLY file, with a byte after each x.
std::string ply_of(const std::string& obj, const std::string& type, bool big_endian) {
  std::string vertices, faces;
  std::size_t counts[2] = {};
  const auto add = [big_endian](std::string& to, auto number) {
    char bytes[sizeof number];
    std::memcpy(bytes, &number, sizeof number);
    if (big_endian) std::reverse(bytes, bytes + sizeof number);
    to.append(bytes, sizeof number);
  };
  for (const std::string& line : lines_of(obj)) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    for (int k = 0; word == "v" && k < 3; ++k) {
      double x = 0;
      words >> x;
      type == "double" ? add(vertices, x) : add(vertices, static_cast<float>(x));
      if (k == 0) vertices += 'q';
    }
    if (word == "f") faces += static_cast<char>(std::count(line.begin(), line.end(), ' '));
    for (std::string v; word == "f" && words >> v;) add(faces, std::stoi(v) - 1);
    counts[0] += word == "v" ? 1 : 0;
    counts[1] += word == "f" ? 1 : 0;
  }
  return std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
         "_endian 1.0\ncomment x\nelement vertex " + std::to_string(counts[0]) + "\nproperty " + type +
         " x\nproperty uchar q\nproperty " + type + " y\nproperty " + type + " z\nelement face " +
         std::to_string(counts[1]) + "\nproperty list uchar int vertex_indices\nend_header\n" + vertices + faces;
}

}  // namespace

TEST_CASE("mesh: a checker cuts the polygons of frames as --triangulate does") {
  const TemporaryFolder folder;
  const auto frame = [](int i, const std::string& polygon = "f 1 2 3 4 5\n") {
    return "v 0 0 0\nv 4 0 0\nv 6 2 0\nv 4 4 0\nv 0 4 0\n" + polygon + "v 1 1 " + std::to_string(3 - i) +
           "\nv 2 1 9\nv 2 2 9\nv 1 2 9\nf 6 7 8 9\n";
  };
  std::vector<std::string> files;
  for (int i = 0; i < 3; ++i) files.push_back(folder.write("f-" + std::to_string(i) + ".obj", frame(i)));
  REQUIRE(run({"mesh", "--triangulate", "--prove", folder.path("out")}, files).status == 0);
  const auto compared = [&](const std::string& pattern) {
    return check(folder, "out", {"--allow-empty", "--frames", folder.path(pattern)});
  };
  const Run same = compared("f-*.obj");
  CAPTURE(same.out, same.err);
  CHECK(same.status == 0);
  CHECK(occurrences(same.out, "5 faces, whose frames are those of the 3 files: ") == 1);
  for (const bool big_endian : {false, true}) {
    for (int i = 0; i < 3; ++i) folder.write("p-" + std::to_string(i) + ".ply", ply_of(frame(i), "float", big_endian));
    CHECK(compared("p-*.ply").status == 0);
  }
  // Cut from another corner, the polygon is other triangles.
  for (const std::string polygon : {"f 2 3 4 5 1\n", "f 5 4 3 2 1\n", "f 1 3 2 4 5\n"}) {
    folder.write("f-1.obj", frame(1, polygon));
    folder.write("p-1.ply", ply_of(frame(1, polygon), "float", false));
    for (const std::string pattern : {"f-*.obj", "p-*.ply"}) {
      const Run other = compared(pattern);
      CHECK(other.status == 1);
      CHECK(occurrences(other.err, "of the file, counted from 0, is none of the motion") == 1);
    }
  }
  folder.write("p-1.ply", ply_of(frame(1, "f 1 2\n"), "float", false));
  CHECK(occurrences(compared("p-*.ply").err, "p-1.ply: a face has three vertices, or more") == 1);
}

TEST_CASE("mesh: a checker compares a motion with the frames, bit by bit") {
  const TemporaryFolder folder;
  // Coordinates that are floats, and frames of which the tenth comes after the second in the order of characters.
  const auto frame = [](int i, const std::string& more = "f 4 5 6\n") {
    return "# x\n\tv 0 0 0\nv  4 0 0\nv 0 4 0\nf 1/1 2/2 3/3\nv 1 1 " + std::to_string(12 - i) +
           ".5\nv 2 1 14\nv 1 2 14\n" + more;
  };
  std::vector<std::string> files;
  for (int i = 0; i < 12; ++i) files.push_back(folder.write("f-" + std::to_string(i) + ".obj", frame(i)));
  REQUIRE(run({"mesh", "--prove", folder.path("out")}, files).status == 0);
  const auto compared = [&](const std::string& pattern, const std::vector<std::string>& options = {"--allow-empty"}) {
    std::vector<std::string> all = options;
    all.insert(all.end(), {"--frames", folder.path(pattern)});
    return check(folder, "out", all);
  };
  const Run same = compared("f-*.obj");
  CAPTURE(same.out, same.err);
  CHECK(same.status == 0);
  CHECK(occurrences(same.out, "2 faces, whose frames are those of the 12 files: " + folder.path("f-0.obj") + " to " +
                                  folder.path("f-11.obj") + " (vertices 0 to 5); no two elements ") == 1);
  for (const std::string type : {"float", "double"}) {
    for (const bool big_endian : {false, true}) {
      for (int i = 0; i < 12; ++i) folder.write("p-" + std::to_string(i) + ".ply", ply_of(frame(i), type, big_endian));
      CHECK(compared("p-*.ply").status == 0);
    }
  }
  const auto refused = [&](int status, const std::string& message, const std::string& pattern = "f-*.obj") {
    const Run now = compared(pattern);
    CAPTURE(message, now.out, now.err);
    CHECK(now.status == status);
    CHECK(now.out == "");
    CHECK(occurrences(now.err, message) == 1);
  };
  const std::string seventh = frame(7);
  const auto with_seventh = [&](const std::string& text, int status, const std::string& message) {
    folder.write("f-7.obj", text);
    refused(status, message);
    folder.write("f-7.obj", seventh);
  };
  with_seventh(frame(8), 1, "f-7.obj and frame 7: the coordinates of vertex 3, counted from 0, differ");
  with_seventh(seventh + "v 0 0 0\n", 1, "f-7.obj: 7 vertices, and ");
  with_seventh(seventh + "f 1 2 4\n", 1,
               "f-7.obj and frame 7: face 2 of the file, counted from 0, is none of the motion");
  with_seventh(seventh + "f 1 2 3 4\n", 1,  // the second triangle of the polygon
               "f-7.obj and frame 7: face 2 of the file, counted from 0, is none of the motion");
  with_seventh(seventh + "f 1 2\n", 2, "f-7.obj:10: a face has three vertices, or more");
  with_seventh(seventh + "f 1 2 7\n", 2, "f-7.obj:10: \"7\" is no vertex above this line");
  // What another reader may take for a face, a line or a point.
  with_seventh(seventh + "f\\\n 1 2 4\n", 2, "f-7.obj:10: --frames reads no backslash and no control character");
  with_seventh(seventh + "\ff 1 2 4\n", 2, "f-7.obj:10: --frames reads no backslash and no control character");
  with_seventh(seventh + "fo 1 2 4\n", 2, "f-7.obj:10: --frames reads no lines \"fo\"");
  with_seventh(seventh + "l 1 4\n", 1, "f-7.obj and frame 7: a line of the file is no edge of the motion");
  folder.write("f-7.obj", seventh + "l 1 2 3\np 4\n");
  CHECK(compared("f-*.obj").status == 0);
  folder.write("f-7.obj", frame(7, "f -3 -2 -1\n"));  // the same vertices
  CHECK(compared("f-*.obj").status == 0);
  refused(2, "no file has such a name", "g-*.obj");
  refused(1, "the motion has more frames than --frames names files", "f-?.obj");
  folder.write("f-12.obj", frame(12));
  refused(1, "--frames names more files than the motion has frames");
  std::string cut_off = ply_of(frame(3), "float", true);
  cut_off.pop_back();
  folder.write("p-3.ply", cut_off);
  refused(2, "p-3.ply: the file is cut off", "p-*.ply");
  folder.write("p-3.ply", ply_of(frame(3), "float", true) + "x");
  refused(2, "p-3.ply: there are bytes after the last element", "p-*.ply");
  const auto with_header = [&](const std::string& before, const std::string& after, const std::string& message) {
    std::string text = ply_of(frame(3), "float", true);
    folder.write("p-3.ply", text.replace(text.find(before), before.size(), after));
    refused(2, "p-3.ply: " + message, "p-*.ply");
  };
  with_header("element face", "element polygon", "--frames reads no element \"polygon\"");
  with_header("vertex_indices", "vertex_indexes", "faces have a list vertex_index or vertex_indices");
  with_header("uchar q", "uchar y", "the property \"y\" is there twice");
  folder.write("p-3.ply", "ply\nformat ascii 1.0\nend_header\n");
  refused(2, "p-3.ply: --frames reads binary PLY alone, and OBJ", "p-*.ply");
  // A motion that leaves out a side, or a corner, or has an element more, under a digest of its own.
  std::remove(folder.path("f-12.obj").c_str());
  const std::string motion = folder.read("out/motion.txt"), proofs = folder.read("out/proofs.txt");
  const auto with_motion = [&](const std::string& line, const std::string& instead, const std::string& message) {
    std::string other = motion, with_digest = proofs;
    other.replace(other.find(line), line.size(), instead);
    folder.write("out/motion.txt", other);
    with_digest.replace(with_digest.find("file mesh ") + 10, 64, io::sha256(other));
    folder.write("out/proofs.txt", with_digest);
    refused(1, message);
  };
  with_motion("edge 0 1\n", "", "1 side is no edge");
  with_motion("point 1\n", "", "1 corner is no point");
  with_motion("frame\n", "edge 0 3\nframe\n", "edge 6 of the motion is no line of the files and no side");
  with_motion("frame\n", "face 0 1 3\nedge 0 3\nedge 1 3\nframe\n", "face 2 of the motion is none of the files");
}

TEST_CASE("mesh: a checker wants the loose points of each part, and as many vertices in each frame") {
  const TemporaryFolder folder;
  for (int i = 0; i < 2; ++i) {
    const std::string end = std::to_string(i) + ".obj", z = std::to_string(3 - i);
    folder.write("a-" + end, "v 0 0 " + z + "\nv 1 0 " + z + "\n");
    folder.write("b-" + end, "v 0 0 0\nv 9 0 0\nv 0 9 0\nf 1 2 3\n");
    folder.write("c-" + end, std::string(i == 0 ? "" : "v 5 5 5\n") + "v 0 0 " + z + "\n");
    folder.write("d-" + end, std::string(i == 0 ? "v 5 5 5\n" : "") + "v 9 0 0\nv 9 9 0\nv 0 9 0\n");
  }
  const std::string a = folder.path("a-*.obj"), b = folder.path("b-*.obj");
  REQUIRE(run({"mesh", "--parts", "--prove", folder.path("out")}, {a, b}).status == 0);
  const auto compared = [&](const std::string& first, const std::string& second) {
    return check(folder, "out", {"--allow-empty", "--frames", first, "--frames", second});
  };
  const auto refused = [&](const Run& now, int status, const std::string& reason) {
    CAPTURE(now.out, now.err, reason);
    CHECK(now.status == status);
    CHECK(occurrences(now.err, reason) == 1);
  };
  CHECK(compared(a, b).status == 0);
  refused(compared(folder.path("a-[[:digit:]].obj"), b), 2, "--frames takes sets such as [0-9] alone");
  std::string motion = folder.read("out/motion.txt"), proofs = folder.read("out/proofs.txt");
  motion.erase(motion.find("point 1\n"), 8);
  proofs.replace(proofs.find("file mesh ") + 10, 64, io::sha256(motion));
  folder.write("out/motion.txt", motion);
  folder.write("out/proofs.txt", proofs);
  refused(compared(a, b), 1, "a point of the file is none of the motion");
  const Run unnamed = check(folder, "out", {"--allow-empty"});
  CHECK(occurrences(unnamed.out, ", 1 vertex is in no element") == 1);
  // Frames whose vertices move from one part to the other.
  motion = "touchstone-motion 1\nvertices 5\n";
  for (int v = 0; v < 5; ++v) motion += "point " + std::to_string(v) + "\n";
  motion += "frame\n0 0 3\n5 5 5\n9 0 0\n9 9 0\n0 9 0\nframe\n5 5 5\n0 0 2\n9 0 0\n9 9 0\n0 9 0\n";
  folder.write("out/motion.txt", motion);
  folder.write("out/proofs.txt", "touchstone-proofs 1\nfile mesh - m\nstep 0\nend 0 0\n");
  refused(compared(folder.path("c-*.obj"), folder.path("d-*.obj")), 1, "c-1.obj: 2 vertices, and ");
}
