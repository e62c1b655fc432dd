// `touchstone mesh --prove`: the checker accepts what it writes, no byte depends on the number of threads, and a run that
// fails leaves nothing.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "cli/motion_proof_runs.hpp"
#include "sequence/needle.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

namespace fs = std::filesystem;

/// An .npy file of version 1.
template <class Number>
std::string npy(const std::string& type, const std::string& shape, const std::vector<Number>& numbers) {
  std::string header = "{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + ", }";
  header.append(118 - header.size() - 1, ' ').append("\n");
  std::string bytes = "\x93NUMPY";
  bytes.append({'\1', '\0', '\x76', '\0'}).append(header);
  return bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number));
}

constexpr std::size_t kSide = 5;  // of the cloth under the needle

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
