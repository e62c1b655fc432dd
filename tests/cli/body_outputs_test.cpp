// touchstone bodies: proofs, pages and distances.
// SPDX-License-Identifier: MIT
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/body_runs.hpp"
#include "cli/run_checker.hpp"
#include "support/query_text.hpp"

using namespace touchstone;
using namespace touchstone::tests;

TEST_CASE("bodies --prove: the checker accepts each step, also where a recorder changes the sign of a quaternion") {
  const BarAndWall scene;
  // The quarter turn, a rest under the other sign, another quarter turn from there to a quaternion at right angles to
  // the first one, and half a turn back, which the signs alone choose.
  const std::string poses = "0,bar,0,0,0,1,0,0,0\n2,bar,0,0,0," + std::string(kTurned) +
                            "\n3,bar,0,0,0,-0.70710678118654757,0,0,-0.70710678118654757\n4,bar,0,0,0,0,0,0,1\n"
                            "5,bar,0,0,0,1,0,0,0\n";
  for (const std::string wall : {"1.625", "1.6875"}) {
    std::string text = kHeader + poses;
    for (const std::string time : {"0", "2", "3", "4", "5"}) text += time + ",wall," + wall + ",0,0,1,0,0,0\n";
    const std::string name = "proved" + wall, folder = scene.folder.path(name);
    const Run made = scene.run(text, {"--json", "--prove", folder, "--threads", "1"});
    CAPTURE(wall, made.err);
    const bool free = wall != "1.625";
    CHECK(made.status == (free ? 0 : 1));
    CHECK(occurrences(made.err, " in 4 steps proved in " + folder + ": " + (free ? "no contact" : "12 contacts") +
                                    "; not asked: whether the first frame intersects itself\n") == 1);
    const Run checked = run_checker(folder + "/proofs.txt", {folder + "/motion.txt"});
    CAPTURE(checked.out, checked.err);
    CHECK(checked.status == 0);
    CHECK(occurrences(checked.out, ": 5 frames, 16 vertices, 16 points, 36 edges, 24 faces, 16 vertices on 2 bodies") ==
          1);

    // Each contact of a step is proved with its times.
    std::string proofs = scene.folder.read(name + "/proofs.txt");
    std::size_t step_number = 0;
    for (const std::string& line : lines_of(made.out)) {
      const auto step = nlohmann::json::parse(line);
      const std::size_t begin = proofs.find("step " + std::to_string(step_number++) + "\n");
      const std::string of_step = proofs.substr(begin, proofs.find("\nstep ", begin + 1) - begin);
      if (step["free"]) {
        CHECK(occurrences(of_step, " contact ") == 0);
      } else {
        const std::string times = hexfloat(step["toi"]) + " " + hexfloat(step["toi_upper"]) + "\n";
        CHECK(occurrences(of_step, " contact " + times) == step["first"].size());
      }
    }
    const Run again = scene.run(text, {"--prove", scene.folder.path("again" + wall), "--threads", "3"});
    CHECK(again.status == made.status);
    CHECK((scene.folder.read("again" + wall + "/proofs.txt") == proofs));
  }
  // The checker does look: elsewhere the bodies do not meet so.
  std::string motion = scene.folder.read("proved1.625/motion.txt");
  for (std::size_t at; (at = motion.find("0x1.ap+0")) != std::string::npos;) motion.replace(at, 8, "0x1.5p+0");
  const std::string changed = scene.folder.write("motion.txt", motion);
  std::string proofs = scene.folder.read("proved1.625/proofs.txt");
  const std::size_t digest = proofs.find("file mesh ") + 10;
  proofs.replace(digest, 64, "-");
  CHECK(run_checker(scene.folder.write("proofs.txt", proofs), {changed}).status == 1);
}

TEST_CASE("bodies --prove: separations, what has no proof is refused, and nothing is left behind") {
  const BarAndWall scene;
  for (const std::string metric : {"euclidean", "max"}) {
    const std::string folder = scene.folder.path(metric);
    const Run made = scene.run(BarAndWall::quarter_turn("1.6875"),
                               {"--separation", "0.0625", "--metric", metric, "--prove", folder});
    CHECK(made.status == 1);
    const Run checked = run_checker(folder + "/proofs.txt", {folder + "/motion.txt"});
    CHECK(checked.status == 0);
    CHECK(occurrences(checked.out, "in 1 step with separation " + metric + " 0x1p-4: 2 frames") == 1);
  }
  const std::string folder = scene.folder.path("new");
  const auto refused = [&](const std::vector<std::string>& more, const std::string& reason,
                           const std::string& poses = BarAndWall::quarter_turn("1.625")) {
    check_refused(scene.run(poses, with({"--prove", folder}, more)), reason);
    CHECK_FALSE(std::filesystem::exists(folder));
  };
  refused({"--ignore", "bar,wall"}, "--ignore and --only-between leave no pair");
  refused({"--free-step", folder + "/motion.txt"}, "another option names too");
  refused({"--as-given"},
          "poses.csv: 0 -> 1: by the signs of its quaternions body 'bar' turns by more than 180 degrees",
          std::string(kHeader) + "0,bar,0,0,0,1,0,0,0\n1,bar,0,0,0,-0.1,0,0,0.9949874371066200\n");
  refused({}, "poses.csv:2: x is 'a'", std::string(kHeader) + "0,bar,a,0,0,1,0,0,0\n");
  check_refused(scene.run(BarAndWall::quarter_turn("1.625"), {"--prove", scene.folder.path("max")}), "max: holds ");
}

TEST_CASE("bodies --prove: the checker names bodies that are not asked about, and asks about all others") {
  const BarAndWall scene;
  const std::string block = scene.folder.write("block.obj", box_obj(0.25, 0.25, 0.25));
  for (const auto& [option, value, pairs] :
       {std::array<std::string, 3>{"--ignore", "bar,wall", "1 pair"}, {"--only-between", "block,*", "2 pairs"}}) {
    const std::string folder = scene.folder.path(option.substr(2));
    const std::vector<std::string> more = {block, option, value, "--prove", folder};
    const Run made = scene.run(
        BarAndWall::quarter_turn("1.625") + "0,block,-1.3,-1.3,0,1,0,0,0\n2,block,-1.3,-1.3,0,1,0,0,0\n", more);
    CAPTURE(option, made.out, made.err);
    CHECK(made.status == 0);  // the bar meets the wall, which is not asked about
    CHECK(occurrences(made.out + made.err, ": no contact; not asked: whether the first frame intersects itself, " +
                                               pairs + " of groups\n") == 1);
    const std::string proofs = scene.folder.read(option.substr(2) + "/proofs.txt");
    const Run checked = run_checker(folder + "/proofs.txt", {folder + "/motion.txt"});
    CAPTURE(checked.out, checked.err);
    CHECK(checked.status == 0);
    CHECK(occurrences(checked.out, "groups of vertices, " + pairs + " of groups not asked about: 0-") == 1);
    // Without the lines the bar and the wall are asked about.
    std::string motion;
    for (const std::string& line : lines_of(scene.folder.read(option.substr(2) + "/motion.txt"))) {
      if (line.rfind("ignore ", 0) != 0) motion += line + "\n";
    }
    std::string of_any = proofs;
    of_any.replace(of_any.find("file mesh ") + 10, 64, "-");
    CHECK(run_checker(scene.folder.write("proofs.txt", of_any), {scene.folder.write("motion.txt", motion)}).status ==
          1);
  }
}

TEST_CASE("bodies --html: the page has the bodies, and what was found") {
  const BarAndWall scene;
  const std::string page = scene.folder.path("page.html");
  const Run run = scene.run(BarAndWall::quarter_turn("1.625"), {"--html", page});
  CHECK(run.status == 1);
  CHECK(occurrences(run.out, "animation in " + page + ", ") == 1);
  const std::string text = scene.folder.read("page.html");
  CHECK(occurrences(text, "<title>2 bodies, time 0 to 2") == 1);
  CHECK(occurrences(text, R"("parts":[{"edges":18,"faces":12,"firstNumber":1,"name":"bar","vertices":8})") == 1);
  // Nine pictures of ten degrees each, the start, and one of the first contact, to which all three marks belong.
  CHECK(occurrences(text, R"(id="frame-10")") == 1);
  CHECK(occurrences(text, R"(id="frame-11")") == 0);
  CHECK(occurrences(text, R"("heading":"time 0.713745: edge )") == 1);
  CHECK(occurrences(text, R"("heading":"time 0.713745: )") == 3);
  CHECK(occurrences(text, "<pre>query,1\nmotion,0,") == 3);
  CHECK(occurrences(text, "[[0.0,0.0,0.0,0.0,3.0,") == 1);  // the plot of contacts

  // Bodies that pierce each other at the start; one of them has a name that is no text of a page.
  const std::string odd = scene.folder.write("<b>.obj", box_obj(1, 1, 1)),
                    poses = scene.folder.write("odd.csv",
                                               std::string(kHeader) + "0,<b>,0,0,0,1,0,0,0\n1,<b>,0,9,0,1,0,0,0\n");
  const Run pierced = run_program({"bodies", odd, scene.wall, "--poses", poses, "--html", page});
  CHECK(pierced.status == 1);
  const std::string again = scene.folder.read("page.html");
  CHECK(occurrences(again, "<b>") == 0);
  CHECK(occurrences(again, "pierces face") > 0);

  check_refused(scene.run(BarAndWall::quarter_turn("1.625"), {"--html", "-"}), "--html");
  check_refused(scene.run(BarAndWall::quarter_turn("1.625"),
                          {"--html", scene.folder.path("o"), "--free-step", scene.folder.path("o")}),
                "which another option names too");
  check_refused(scene.run(BarAndWall::quarter_turn("1.625"), {"--html", scene.folder.path("none/p.html")}),
                "none/p.html");
}

TEST_CASE("bodies --clearance: the least distance in each recorded pose") {
  const BarAndWall scene;
  const Run run = scene.run(BarAndWall::quarter_turn("1.625"), {"--clearance", "--json"});
  CHECK(run.status == 1);
  const auto step = nlohmann::json::parse(run.out);
  CHECK(step["clearance"][0] == 0.375);
  CHECK(double(step["clearance"][1]) == Approx(0.375));
  CHECK(occurrences(run.err, "; least distance 0.375 at time 0: edge ") == 1);
  CHECK(occurrences(run.err, " of bar and ") == 1);
  CHECK(occurrences(run.err, "; the least distance between recorded poses was not asked; ") == 1);
  const Run max = scene.run(BarAndWall::quarter_turn("1.6875"), {"--clearance", "--metric", "max"});
  CHECK(max.status == 0);
  CHECK(occurrences(max.out, " in the max metric at time ") == 1);
  const Run pierced = scene.run(BarAndWall::quarter_turn("0"), {"--clearance"});
  CHECK(occurrences(pierced.out, "; least distance 0 at time 0: ") == 1);
  check_refused(scene.run(BarAndWall::quarter_turn("9"), {"--metric", "max"}), "--separation or --clearance");
}
