// `touchstone simulate --prove`: the checker accepts what it writes, and a run that fails leaves nothing.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <vector>

#include "cli/motion_proof_runs.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::tests;

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
