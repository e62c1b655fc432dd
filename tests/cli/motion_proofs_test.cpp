// `touchstone mesh --prove` and `touchstone simulate --prove`: the checker accepts what they write, no byte depends on
// the number of threads, and a run that fails leaves nothing.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "cli/run_checker.hpp"
#include "io/sha256.hpp"
#include "sequence/needle.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

namespace fs = std::filesystem;

/// What touchstone-check says about a folder of --prove.
Run check(const TemporaryFolder& folder, const std::string& name, std::vector<std::string> options = {}) {
  options.push_back(folder.path(name + "/proofs.txt"));
  return run_checker(options, {folder.path(name + "/motion.txt")});
}

std::size_t count_of(const std::vector<std::string>& lines, const std::string& line) {
  return static_cast<std::size_t>(std::count(lines.begin(), lines.end(), line));
}

/// Frame `frame` of a motion: the lines of its vertices.
std::vector<std::string> frame_of(const std::vector<std::string>& motion, std::size_t frame) {
  auto line = motion.begin();
  for (std::size_t i = 0; i <= frame; ++i) line = std::find(line, motion.end(), "frame") + 1;
  return {line, std::find(line, motion.end(), "frame")};
}

Run run(std::vector<std::string> arguments, const std::vector<std::string>& more, const RunOptions& options = {}) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_program(arguments, options);
}

/// An .npy file of version 1.
template <class Number>
std::string npy(const std::string& type, const std::string& shape, const std::vector<Number>& numbers) {
  std::string header = "{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + ", }";
  header.append(118 - header.size() - 1, ' ').append("\n");
  std::string bytes = "\x93NUMPY";
  bytes.append({'\1', '\0', '\x76', '\0'}).append(header);
  return bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number));
}

/// A folder's proofs are accepted, are about its motion, and have as many steps.
void check_folder(const TemporaryFolder& folder, const std::string& name, std::size_t steps,
                  const std::vector<std::string>& options = {}) {
  const std::string motion_text = folder.read(name + "/motion.txt"), proofs_text = folder.read(name + "/proofs.txt");
  const auto motion = lines_of(motion_text), proofs = lines_of(proofs_text);
  CHECK(count_of(motion, "frame") == steps + 1);
  CHECK(occurrences(proofs_text, "file mesh " + io::sha256(motion_text) + " motion.txt\n") == 1);
  CHECK(occurrences(proofs_text, "\nstep ") == steps);
  const Run checked = check(folder, name, options);
  CAPTURE(checked.out, checked.err);
  CHECK(checked.status == 0);
}

constexpr std::size_t kSide = 5;  // of the cloth under the needle

const std::string kFirstFrame = "; not asked: whether the first frame intersects itself";

}  // namespace

TEST_CASE("mesh: proofs of a motion with a contact are accepted, and are the same for any number of threads") {
  const TemporaryFolder folder;
  const auto frames = write_needles(folder, "f", kSide, 5, falling_tip);
  for (const std::string metric : {"", "euclidean", "max"}) {
    std::string proofs, motion;
    for (const std::string threads : {"1", "2", "7"}) {
      const std::string name = "proved" + metric + threads;
      std::vector<std::string> arguments = {"mesh", "--threads", threads, "--prove", folder.path(name)};
      if (!metric.empty()) arguments.insert(arguments.end(), {"--separation", "0.1", "--metric", metric});
      const Run made = run(arguments, frames);
      CAPTURE(name, made.out, made.err);
      REQUIRE(made.status == 1);
      CHECK(made.err.empty());
      check_folder(folder, name, 4);
      if (proofs.empty()) {
        proofs = folder.read(name + "/proofs.txt");
        motion = folder.read(name + "/motion.txt");
        const auto lines = lines_of(proofs);
        std::istringstream end(lines.back());
        std::string word;
        std::size_t pairs = 0, contacts = 0;
        end >> word >> pairs >> contacts;
        CHECK(word == "end");
        CHECK(contacts > 0);
        CHECK(contacts < pairs);
        CHECK(made.out.find(std::to_string(pairs) + " pairs in 4 steps proved in " + folder.path(name) + ": " +
                            std::to_string(contacts) + " contact") != std::string::npos);
        CHECK(lines[1] == (metric.empty() ? lines[1] : "separation " + metric + " 0x1.999999999999ap-4"));
        CHECK(occurrences(proofs, "separation") == (metric.empty() ? 0 : 1));
        if (metric.empty()) CHECK(occurrences(proofs, " contact 0x1p-1 0x1p-1\n") == 1);
      }
      CHECK((folder.read(name + "/proofs.txt") == proofs));
      CHECK((folder.read(name + "/motion.txt") == motion));
    }
  }
  const auto motion = lines_of(folder.read("proved1/motion.txt"));
  CHECK(motion[1] == "vertices " + std::to_string(kSide * kSide + 3));
  CHECK(count_of(motion, "face 25 26 27") == 1);
  CHECK(count_of(motion, "edge 25 26") == 1);
  CHECK(count_of(motion, "point 25") == 1);
  CHECK(frame_of(motion, 1)[25] == "0x1.4p+0 0x1.4p+0 0x1.8p-2");  // 1.25 1.25 0.375

  // The checker does look: with another coordinate the meeting is none.
  std::string changed = folder.read("proved1/motion.txt");
  changed.replace(changed.rfind("0x1.4p+0 0x1.4p+0 -0x1p-3"), 8, "0x1.5p+0");
  folder.write("proved1/motion.txt", changed);
  CHECK(check(folder, "proved1").status != 0);
}

TEST_CASE("mesh: frames without contact, the plane, loose points, a part of the steps, a report beside the proofs") {
  const TemporaryFolder folder;
  const Run rising =
      run({"mesh", "--prove", folder.path("a/b/rising")}, write_needles(folder, "r", kSide, 3, rising_tip));
  CHECK(rising.status == 0);
  CHECK(occurrences(rising.out, " proved in " + folder.path("a/b/rising") + ": no contact" + kFirstFrame + "\n") == 1);
  check_folder(folder, "a/b/rising", 2);

  // Two loose points, a segment and a bystander; the first point passes through the segment.
  const auto points = [&](const std::string& name, const char* y) {
    return folder.write(name, std::string("v 0.5 ") + y + " 0\nv 0 0 0\nv 1 0 0\nv 0.5 9 0\nl 2 3\np 1\np 4\n");
  };
  const std::string before = points("p-0.obj", "-1"), between = points("p-1.obj", "-0.5"),
                    after = points("p-2.obj", "1");
  const std::string report = folder.path("report.json");
  const Run loose = run({"mesh", "--prove", folder.path("loose"), "--report", report}, {before, between, after});
  CAPTURE(loose.out, loose.err);
  CHECK(loose.status == 1);
  check_folder(folder, "loose", 2);
  CHECK(occurrences(folder.read("loose/proofs.txt"), "\nstep 0\nstep 1\n0 contact 0x1.5555555555555p-2 ") == 1);
  CHECK(lines_of(folder.read("loose/proofs.txt")).back() == "end 1 1");

  // In the plane: two segments, and the end of one passes through the other.
  const std::string plane =
      folder.write("plane.npy", npy<double>("<f8", "(2, 4, 2)", {0, 0, 2, 0, 1, 1, 1, 3, 0, 0, 2, 0, 1, -1, 1, 3}));
  const std::string segments = folder.write("segments.npy", npy<std::int32_t>("<i4", "(2, 2)", {0, 1, 2, 3}));
  const Run planar = run_program({"mesh", "--prove", folder.path("planar"), "--topology", segments, plane});
  CAPTURE(planar.out, planar.err);
  CHECK(planar.status == 1);
  check_folder(folder, "planar", 1);
  CHECK((frame_of(lines_of(folder.read("planar/motion.txt")), 1)[2] == "0x1p+0 -0x1p+0 0"));
  CHECK(occurrences(folder.read("planar/proofs.txt"), "\nstep 0\n0 contact 0x1p-1 0x1p-1\n") == 1);

  // A part of the steps has frames of its own, and --resume makes all proofs of its steps.
  const Run part = run({"mesh", "--prove", folder.path("part"), "--shard", "2/2"}, {before, between, after});
  CHECK(part.status == 1);
  check_folder(folder, "part", 1);
  CHECK(occurrences(folder.read("part/proofs.txt"), "\nstep 0\n0 contact ") == 1);
  const Run again =
      run({"mesh", "--prove", folder.path("again"), "--report", report, "--resume"}, {before, between, after});
  CHECK(again.status == 1);
  CHECK((folder.read("again/proofs.txt") == folder.read("loose/proofs.txt")));

  const Run to_output = run({"mesh", "--prove", folder.path("output"), "--report", "-"}, {before, between});
  CHECK(to_output.status == 0);
  CHECK(occurrences(to_output.out, "proved in") == 0);  // nothing but the report
  check_folder(folder, "output", 1, {"--allow-empty"});
}

TEST_CASE("mesh --prove: a rod that folds onto its next segment has a contact, one that bends has none") {
  const TemporaryFolder folder;
  const auto rod = [&](const std::string& name, const char* end) {
    return folder.write(name, std::string("v 0 0 0\nv 2 0 0\nv ") + end + "\nl 1 2\nl 2 3\n");
  };
  const std::string up = rod("r-0.obj", "1.5 1 0"), through = rod("r-1.obj", "1.5 -1 0"),
                    bent = rod("r-2.obj", "1 0.25 0");
  const Run folds = run_program({"mesh", "--prove", folder.path("folds"), up, through});
  CAPTURE(folds.out, folds.err);
  CHECK(folds.status == 1);
  CHECK(occurrences(folds.out,
                    "1 pair in 1 step proved in " + folder.path("folds") + ": 1 contact" + kFirstFrame + "\n") == 1);
  CHECK(occurrences(folder.read("folds/proofs.txt"), "\nstep 0\n0 contact 0x1p-1 0x1p-1\n") == 1);
  check_folder(folder, "folds", 1);
  // A separation does not count between neighbours along a wire.
  const Run bends = run_program({"mesh", "--separation", "0.5", "--prove", folder.path("bends"), up, bent});
  CAPTURE(bends.out, bends.err);
  CHECK(bends.status == 0);
  CHECK(occurrences(bends.out, " proved in " + folder.path("bends") + ": no contact" + kFirstFrame + "\n") == 1);
  CHECK(occurrences(folder.read("bends/proofs.txt"), "\nstep 0\n0 none\n") == 1);
  check_folder(folder, "bends", 1);
  // Without the pair the checker does not accept them.
  std::string forged = folder.read("folds/proofs.txt");
  forged = forged.substr(0, forged.find("0 contact")) + "end 0 0\n";
  folder.write("folds/proofs.txt", forged);
  const Run checked = check(folder, "folds");
  CHECK(checked.status == 1);
  CHECK(occurrences(checked.err, "step 0: pair 0 (point 2 and edge 0): ") == 1);
}

TEST_CASE("mesh --prove says that no pair needs a proof, and refuses a motion in which no two elements could meet") {
  const TemporaryFolder folder;
  const auto frame = [&](const std::string& name, const std::string& more) {
    return folder.write(name, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n" + more);
  };
  const std::string other = "v 9 0 0\nv 9 1 0\nv 9 0 1\nf 4 5 6\n";
  const std::string before = frame("two-0.obj", other), after = frame("two-1.obj", other);
  const Run far = run_program({"mesh", "--prove", folder.path("far"), before, after});
  CAPTURE(far.out, far.err);
  CHECK(far.status == 0);
  const std::string none_near = ": no two elements that are asked about come near enough to need a proof";
  CHECK(occurrences(far.out, "0 pairs in 1 step proved in " + folder.path("far") + none_near + kFirstFrame + "\n") ==
        1);
  check_folder(folder, "far", 1, {"--allow-empty"});
  CHECK(check(folder, "far").status == 1);
  const Run checked = check(folder, "far", {"--allow-empty"});
  CHECK(checked.status == 0);
  CHECK(occurrences(checked.out, ": 2 frames, 6 vertices, 6 points, 6 edges, 2 faces; no two elements that are") == 1);
  CHECK(occurrences(checked.out,
                    "\n0 queries checked" + none_near +
                        "; not asked: whether a first frame intersects itself, and what lines above leave out\n") == 1);

  const std::string one = frame("one-0.obj", ""), again = frame("one-1.obj", "");
  const Run refused = run_program({"mesh", "--prove", folder.path("one"), one, again});
  CHECK(refused.status == 2);
  CHECK(occurrences(refused.err, "there is nothing to prove: of 3 points, 3 edges and 1 face no two ") == 1);
  CHECK_FALSE(fs::exists(folder.path("one")));

  // Proofs of the motion without its elements, under the old digest.
  std::string bare;
  for (const std::string& line : lines_of(folder.read("far/motion.txt"))) {
    if (line.rfind("point ", 0) != 0 && line.rfind("edge ", 0) != 0 && line.rfind("face ", 0) != 0) bare += line + "\n";
  }
  folder.write("far/motion.txt", bare);
  const Run another = check(folder, "far", {"--allow-empty"});
  CHECK(another.status != 0);
  // And under their own.
  const std::string proofs = folder.read("far/proofs.txt"), digest = "file mesh " + io::sha256(bare);
  folder.write("far/proofs.txt", std::string(proofs).replace(proofs.find("file mesh "), digest.size(), digest));
  const Run nothing = check(folder, "far", {"--allow-empty"});
  CHECK(nothing.status == 2);
  CHECK(occurrences(nothing.err,
                    "there is nothing to check: 2 frames, 6 vertices, 0 points, 0 edges, 0 faces, 6 vertices are in no "
                    "element, but") == 1);
}

TEST_CASE("mesh --prove: folders and options that are refused, and runs that leave nothing") {
  const TemporaryFolder folder;
  const auto frames = write_needles(folder, "f", kSide, 3, rising_tip);
  folder.write("full/file", "mine");
  folder.write("leftover/motion.txt.touchstone-1.partial", "of a process that was killed");
  fs::create_directory(folder.path("empty"));
  fs::create_symlink("nowhere", folder.path("link"));
  const auto names = folder.names();
  const auto check_refused = [&](const std::vector<std::string>& arguments, const std::string& part) {
    const Run refused = run_program(arguments);
    CAPTURE(arguments, refused.err);
    CHECK(refused.status == 2);
    CHECK(occurrences(refused.err, "\n") == 1);
    CHECK(occurrences(refused.err, part) == 1);
    CHECK(folder.names() == names);
  };
  const std::string full = folder.path("full"), there = folder.path("f-0.obj"), fresh = folder.path("fresh");
  check_refused({"mesh", "--prove", full, frames[0], frames[1]}, "full: holds file; the motion and its proofs go into");
  check_refused({"mesh", "--prove", full, "--report", folder.path("report.json"), frames[0], frames[1]}, "full: holds");
  check_refused({"mesh", "--prove", there, frames[0], frames[1]}, "f-0.obj");
  check_refused({"mesh", "--prove", folder.path("link"), frames[0], frames[1]},
                "link: is a link to nowhere, which does not exist; make that folder, or remove the link");
  CHECK(folder.read("full/file") == "mine");
  CHECK((folder.read("f-0.obj") == needle_frame(kSide, rising_tip(0))));
  check_refused({"mesh", "--prove", fresh, "--check", frames[0]}, "--check");
  check_refused({"mesh", "--prove", "", frames[0], frames[1]}, "the name is empty");
  check_refused({"mesh", "--prove", fresh, "--report", fresh + "/proofs.txt", frames[0], frames[1]},
                "proofs.txt, which another option names too");
  check_refused({"mesh", "--prove", fresh, frames[0]}, "a step needs two frames");
  folder.write("f-1.obj", "v 0 0 0\n");  // another mesh: found after the first frame
  check_refused({"mesh", "--prove", fresh, frames[0], frames[1]}, "f-1.obj differs from");
  folder.write("f-1.obj", needle_frame(kSide, rising_tip(1)));

  for (const char* name : {"empty", "leftover"}) {
    CHECK(run({"mesh", "--prove", folder.path(name)}, frames).status == 0);
    check_folder(folder, name, 2);
    CHECK(std::distance(fs::directory_iterator(folder.path(name)), fs::directory_iterator{}) == 2);
  }
  check_refused({"mesh", "--prove", folder.path("empty"), frames[0], frames[1]}, "empty: holds ");
}

TEST_CASE("simulate: every substep is a step of the motion, no pair has a contact, and held particles stay", "[slow]") {
  const TemporaryFolder folder;
  std::string proofs;
  for (const std::string threads : {"1", "3"}) {
    const std::string name = "hoop" + threads;
    const Run made = run_program({"simulate", "hoop", "--steps", "60", "--threads", threads, "--prove",
                                  folder.path(name), "--proof", folder.path(name + ".csv")});
    CAPTURE(made.out, made.err);
    REQUIRE(made.status == 0);
    const std::size_t substeps = lines_of(folder.read(name + ".csv")).size() - 1;
    check_folder(folder, name, substeps);
    CHECK(occurrences(made.out, " proved in " + folder.path(name) +
                                    ": no contact; not asked: whether the first frame intersects itself\n") == 1);
    CHECK(occurrences(folder.read(name + "/proofs.txt"), "contact") == 0);
    const std::string end = lines_of(folder.read(name + "/proofs.txt")).back();
    CHECK(end.size() > std::string("end 100 0").size());  // a thousand pairs or more
    CHECK(end.substr(end.size() - 2) == " 0");
    if (proofs.empty()) proofs = folder.read(name + "/proofs.txt");
    CHECK((folder.read(name + "/proofs.txt") == proofs));
  }
  const auto motion = lines_of(folder.read("hoop1/motion.txt"));
  CHECK(
      std::any_of(motion.begin(), motion.end(), [](const std::string& line) { return line.rfind("fixed ", 0) == 0; }));
  const Run checked = check(folder, "hoop1");
  CAPTURE(checked.out);
  CHECK(occurrences(checked.out, " with separation euclidean, the sum of two radii: ") == 1);
  CHECK(occurrences(checked.out, " elements with radii from 0x1.0624dd2f1a9fcp-9 to 0x1.26e978d4fdf3bp-7, ") == 1);
}

TEST_CASE("simulate: pairs are proved to keep the sum of their radii, and neighbours along a cable not to touch") {
  const TemporaryFolder folder;
  // A cable with segments shorter than its radius, and a sphere that comes to rest on it.
  const std::string scene = folder.write("scene.json", R"({"touchstone_scene": 1, "particles": [
      {"position": [0, 0, 0], "pinned": true}, {"position": [0.25, 0, 0]}, {"position": [0.5, 0, 0]},
      {"position": [0.75, 0, 0]}, {"position": [1, 0, 0], "pinned": true}, {"position": [0.5, 0.1, 0.875], "mass": 1,
      "radius": 0.5}], "cables": [{"particles": [0, 1, 2, 3, 4], "radius": 0.25, "solid": true, "density": 1000,
      "young": 1e6}]})");
  const Run made = run_program({"simulate", scene, "--steps", "20", "--prove", folder.path("out")});
  CAPTURE(made.out, made.err);
  REQUIRE(made.status == 0);
  const Run checked = check(folder, "out");
  CAPTURE(checked.out, checked.err);
  CHECK(checked.status == 0);
  CHECK(occurrences(checked.out, " elements with radii from 0x1p-2 to 0x1p-1, ") == 1);
  const std::string count = std::to_string(occurrences(folder.read("out/motion.txt"), "\nnear "));
  CHECK(occurrences(checked.out, ", " + count + " pairs of neighbours") == 1);
  CHECK(occurrences(made.out, kFirstFrame + "; asked about touching alone: " + count + " pairs of neighbours\n") == 1);

  // With a longer radius the proofs show too little.
  std::string longer = folder.read("out/motion.txt");
  const auto at = longer.find("radius 0x1p-1\n");
  REQUIRE(at != std::string::npos);
  longer.replace(at, 13, "radius 0x1p0");
  std::string proofs = folder.read("out/proofs.txt");
  const auto digest = proofs.find("mesh ") + 5;
  proofs.replace(digest, 64, "-");
  folder.write("out/motion.txt", longer);
  folder.write("out/proofs.txt", proofs);
  CHECK(check(folder, "out").status == 1);
}

TEST_CASE("simulate: the motion goes on after a checkpoint, contacts that the paper's method lets pass are proved") {
  const TemporaryFolder folder;
  const std::string state = folder.path("state.json");
  REQUIRE(run_program({"simulate", "two-edges", "--steps", "20", "--checkpoint", state, "--prove", folder.path("one")})
              .status == 0);
  REQUIRE(run_program({"simulate", "--resume", state, "--steps", "20", "--prove", folder.path("two")}).status == 0);
  REQUIRE(run_program({"simulate", "two-edges", "--steps", "40", "--prove", folder.path("all")}).status == 0);
  const auto one = lines_of(folder.read("one/motion.txt")), two = lines_of(folder.read("two/motion.txt")),
             all = lines_of(folder.read("all/motion.txt"));
  const auto last = count_of(one, "frame") - 1;
  check_folder(folder, "two", count_of(two, "frame") - 1, {"--allow-empty"});
  CHECK((frame_of(two, 0) == frame_of(one, last)));
  CHECK(last + count_of(two, "frame") == count_of(all, "frame"));
  CHECK((frame_of(two, count_of(two, "frame") - 1) == frame_of(all, count_of(all, "frame") - 1)));

  const Run paper =
      run_program({"simulate", "hoop", "--steps", "30", "--narrow-phase", "paper", "--prove", folder.path("paper")});
  CAPTURE(paper.out);
  CHECK(paper.status == 1);
  check_folder(folder, "paper", 30);
  CHECK(occurrences(folder.read("paper/proofs.txt"), " contact ") > 0);
}

TEST_CASE("simulate --prove: what is refused, and runs that end early", "[slow]") {
  const TemporaryFolder folder;
  const std::string fresh = folder.path("fresh");
  folder.write("full/file", "mine");
  const auto names = folder.names();
  const auto check_refused = [&](std::vector<std::string> arguments, const std::string& part) {
    arguments.insert(arguments.begin(), {"simulate", "two-edges"});
    const Run refused = run_program(arguments);
    CAPTURE(arguments, refused.err);
    CHECK(refused.status == 2);
    CHECK(occurrences(refused.err, part) == 1);
    CHECK(folder.names() == names);
  };
  check_refused({"--prove", folder.path("full")}, "full: holds file; ");
  check_refused({"--prove", fresh, "--explain"}, "--explain");
  check_refused({"--prove", fresh, "--energies", fresh + "/motion.txt"}, "name the same file");
  check_refused({"--prove", fresh, "--steps", "0"}, "no step was made, so there is nothing to prove");

  // Ctrl-C: the steps that were made are proved.
  RunOptions options;
  options.interrupt_after = 2;
  const Run ended = run_program({"simulate", "whip", "--size", "400", "--steps", "1000000", "--prove", fresh}, options);
  CHECK(ended.status == 128 + 2);
  const auto frames = count_of(lines_of(folder.read("fresh/motion.txt")), "frame");
  CHECK(frames > 1);
  check_folder(folder, "fresh", frames - 1, {"--allow-empty"});  // a busy machine makes few steps, far from contact
}

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
