// `touchstone simulate`: its last line, its files and its refusals.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "support/catch.hpp"

using namespace touchstone::tests;

namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

/// The verdict without what was left out.
std::string verdict(const std::string& text) {
  const std::string line = first_line(text);
  return line.substr(0, line.find(';'));
}

}  // namespace

TEST_CASE("the hoop runs with a proof of each step, and the ball goes through the net") {
  const TemporaryFolder folder;
  const std::string out = folder.path("out"), proof = folder.path("proof.csv");
  // A second and a quarter: it has fallen through by then.
  const Run run = run_program({"simulate", "hoop", "--size", "200", "--steps", "75", "--out", out, "--proof", proof});
  CAPTURE(run.out, run.err);
  CHECK(run.status == 0);
  CHECK(verdict(run.out) == "75 steps, 0 crossings");

  const auto rows = lines_of(folder.read("proof.csv"));
  REQUIRE(rows.size() >= 76);
  const auto header = cells_of(rows[0]);
  CHECK(header.front() == "step");
  CHECK(header.back() == "certified");
  const auto column = [&](const char* name) {
    const auto found = std::find(header.begin(), header.end(), name);
    REQUIRE(found != header.end());
    return static_cast<std::size_t>(found - header.begin());
  };
  const std::size_t contact_column = column("contacts"), pair_column = column("pairs");
  std::uint64_t contacts = 0, pairs = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto cells = cells_of(rows[i]);
    REQUIRE(cells.size() == header.size());
    CHECK(cells.back() == "1");
    contacts += std::stoull(cells[contact_column]);
    pairs += std::stoull(cells[pair_column]);
  }
  CHECK(cells_of(rows.back())[0] == "75");
  CHECK(contacts > 50);
  CHECK(pairs > 1000);

  const auto energies = lines_of(folder.read("out/energies.csv"));
  REQUIRE(energies.size() == 77);
  double before = std::stod(cells_of(energies[1])[7]);
  for (std::size_t i = 2; i < energies.size(); ++i) {
    const double total = std::stod(cells_of(energies[i])[7]);
    CHECK(total <= before + 0.05);
    before = total;
  }

  // Frames: a series of legacy VTK files, whose counts say how many numbers follow.
  const std::string series = folder.read("out/frames/frames.vtk.series");
  CHECK(occurrences(series, "\"name\": \"frame-") == 38);
  const auto frame = lines_of(folder.read("out/frames/frame-000074.vtk"));
  REQUIRE(frame.size() > 5);
  CHECK(frame[0] == "# vtk DataFile Version 3.0");
  CHECK(frame[2] == "ASCII");
  CHECK(frame[3] == "DATASET POLYDATA");
  std::istringstream points(frame[4]);
  std::string word;
  std::size_t count = 0;
  points >> word >> count;
  CHECK(word == "POINTS");
  REQUIRE(frame.size() > 5 + count);
  CHECK(frame[5 + count].rfind("LINES ", 0) == 0);
  // The ball's particles come after the net's and before the floor's four.
  double x = 0, y = 0, z = 0;
  std::istringstream ball(frame[5 + count - 5]);
  ball >> x >> y >> z;
  CHECK(z < 1.1);
  CHECK(z > 0);
  CHECK(std::filesystem::exists(folder.path("out/energies.svg")));
}

TEST_CASE("ten seconds of the hoop, every step certified, every other one a frame", "[slow]") {
  const TemporaryFolder folder;
  const Run run = run_program({"simulate", "hoop", "--out", folder.path("out"), "--proof", folder.path("proof.csv")});
  CHECK(run.status == 0);
  CHECK(verdict(run.out) == "600 steps, 0 crossings");
  const auto rows = lines_of(folder.read("proof.csv"));
  REQUIRE(rows.size() >= 601);
  CHECK(rows.size() <= 603);  // a few steps may be cut
  std::size_t step = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto cells = cells_of(rows[i]);
    if (cells[0] != std::to_string(step)) ++step;
    CHECK(cells[0] == std::to_string(step));
    CHECK(cells.back() == "1");
  }
  CHECK(step == 600);
  CHECK(occurrences(folder.read("out/frames/frames.vtk.series"), "\"name\": \"frame-") == 301);
  const auto energies = lines_of(folder.read("out/energies.csv"));
  REQUIRE(energies.size() == 602);
  CHECK(std::stod(cells_of(energies.back())[1]) == Approx(10));
}

TEST_CASE("a run that is resumed writes what an uninterrupted one does, on any number of threads") {
  const TemporaryFolder folder;
  const auto path = [&](const char* name) { return folder.path(name); };
  CHECK(run_program({"simulate", "chain", "--steps", "60", "--checkpoint", path("whole.json")}).status == 0);
  CHECK(
      run_program({"simulate", "chain", "--steps", "60", "--threads", "2", "--checkpoint", path("two.json")}).status ==
      0);
  CHECK(run_program({"simulate", "chain", "--steps", "25", "--checkpoint", path("part.json")}).status == 0);
  const Run rest =
      run_program({"simulate", "--resume", path("part.json"), "--steps", "35", "--checkpoint", path("rest.json")});
  CHECK(rest.status == 0);
  CHECK(first_line(rest.out) == "35 steps, 0 crossings; left out: the radius of 1 cable that is not solid");
  CHECK(folder.read("rest.json") == folder.read("whole.json"));
  CHECK(folder.read("two.json") == folder.read("whole.json"));
}

TEST_CASE("the table of energies follows a body, a vertex of it, or a particle") {
  const TemporaryFolder folder;
  const auto last_columns = [&](const std::vector<std::string>& scene, const std::string& followed) {
    std::vector<std::string> arguments = {"simulate"};
    arguments.insert(arguments.end(), scene.begin(), scene.end());
    for (const char* more : {"--steps", "2", "--energies"}) arguments.emplace_back(more);
    arguments.push_back(folder.path("energies.csv"));
    arguments.insert(arguments.end(), {"--follow", followed});
    const Run run = run_program(arguments);
    CAPTURE(run.err);
    REQUIRE(run.status == 0);
    const auto rows = lines_of(folder.read("energies.csv"));
    REQUIRE(rows.size() == 4);
    for (const auto& row : rows) REQUIRE(cells_of(row).size() == cells_of(rows[0]).size());
    return std::pair(rows[0].substr(rows[0].find("numerical")), cells_of(rows[1]));
  };
  // A box of half a metre stands on a plane: see `stack`.
  const auto [body, body_start] = last_columns({"stack", "--size", "1"}, "body:1");
  CHECK(body == "numerical,x,y,z,qw,qx,qy,qz");
  CHECK(std::vector<std::string>(body_start.end() - 4, body_start.end()) ==
        std::vector<std::string>{"1", "0", "0", "0"});
  const auto [vertex, vertex_start] = last_columns({"stack", "--size", "1"}, "body:1:0");
  CHECK(vertex == "numerical,x,y,z");
  CHECK(vertex_start.end()[-1] != body_start.end()[-5]);
  const auto [particle, particle_start] = last_columns({"two-edges"}, "0");
  CHECK(particle == "numerical,x,y,z");
}

TEST_CASE("the candidates that it writes certify") {
  const TemporaryFolder folder;
  CHECK(run_program({"simulate", "hoop", "--size", "200", "--steps", "30", "--queries", folder.path("q")}).status == 0);
  // One file for each separation. 2.5 mm is the radius of a string, and 2 mm that of the ball.
  std::vector<std::string> arguments{"certify"};
  std::size_t separations = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path("q"))) {
    if (entry.is_directory()) continue;
    arguments.push_back(entry.path().string());
    const std::string name = entry.path().filename().string();
    const std::string first_line =
        lines_of(folder.read(std::filesystem::relative(entry.path(), folder.path("")).string())).at(0);
    if (name == "candidates.csv") {
      CHECK(first_line.find('#') == std::string::npos);
    } else {
      ++separations;
      CHECK("# separation " + name.substr(11, name.size() - 15) + " euclidean" == first_line);
    }
  }
  CHECK(separations >= 3);
  CHECK(std::filesystem::exists(folder.path("q/edge-edge/candidates-0x1.26e978d4fdf3cp-8.csv")));
  const Run certified = run_program(arguments);
  CAPTURE(certified.out, certified.err);
  CHECK(certified.status == 0);
  CHECK(occurrences(certified.out, "claims hold") == 1);
}

TEST_CASE("cable-drop proves that no two cables of radius r come nearer than 2 r, with a stop as without", "[slow]") {
  const TemporaryFolder folder;
  const auto path = [&](const char* name) { return folder.path(name); };
  const Run run = run_program(
      {"simulate", "cable-drop", "--proof", path("proof.csv"), "--checkpoint", path("whole.json"), "--threads", "2"});
  CHECK(run.status == 0);
  const auto lines = lines_of(run.out);
  REQUIRE(lines.size() >= 3);
  CHECK(lines.front() == "120 steps, 0 crossings; left out: pairs among 7 elements that cannot move");
  CHECK(lines[2].rfind("every pair asked about stayed farther apart than its separation (", 0) == 0);
  CHECK(occurrences(run.out, "with separations of up to 0.006 m)") == 1);

  const auto rows = lines_of(folder.read("proof.csv"));
  const auto header = cells_of(rows[0]);
  const auto column = [&](const char* name) {
    const auto found = std::find(header.begin(), header.end(), name);
    REQUIRE(found != header.end());
    return static_cast<std::size_t>(found - header.begin());
  };
  std::uint64_t entering = 0, separated = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto cells = cells_of(rows[i]);
    REQUIRE(cells.size() == header.size());
    CHECK(cells.back() == "1");
    entering += std::stoull(cells[column("entering")]);
    const auto here = std::stoull(cells[column("separated")]);
    separated += here;
    const double least = std::stod(cells[column("least_separation")]);
    const double largest = std::stod(cells[column("largest_separation")]);
    CHECK((here > 0 ? least >= 0.003 && least <= largest && largest <= 0.006 : least == 0 && largest == 0));
  }
  CHECK(entering > 0);
  CHECK(separated > 0);

  CHECK(run_program({"simulate", "cable-drop", "--steps", "50", "--checkpoint", path("part.json")}).status == 0);
  CHECK(run_program({"simulate", "--resume", path("part.json"), "--checkpoint", path("rest.json")}).status == 0);
  CHECK(folder.read("rest.json") == folder.read("whole.json"));

  const Run paper = run_program({"simulate", "cable-drop", "--size", "60", "--steps", "5", "--narrow-phase", "paper"});
  CHECK(occurrences(paper.out, "the radii of the scene were left aside: the narrow phase of the paper knows no") == 1);
  // A scene without radii says nothing of them.
  const Run thin = run_program({"simulate", "two-edges", "--steps", "5", "--proof", path("thin.csv")});
  CHECK(occurrences(thin.out, "separation") == 0);
  CHECK(occurrences(thin.out, "radii") == 0);
  CHECK(occurrences(folder.read("thin.csv"), "separat") == 0);
}

TEST_CASE("with the paper's solver as narrow phase the ball's edges get through the net, and the proof says so") {
  const Run hoop = run_program({"simulate", "hoop", "--steps", "30", "--narrow-phase", "paper"});
  CAPTURE(hoop.out);
  CHECK(hoop.status == 1);
  const auto lines = lines_of(hoop.out);
  CHECK(lines[1].rfind("crossing: step ", 0) == 0);
  CHECK(occurrences(lines[1], " s: edge ") == 1);
  CHECK(occurrences(lines[1], " and edge ") == 1);
  CHECK(occurrences(lines[1], " at (") == 1);
  CHECK(occurrences(hoop.out, " s: edge ") >= 5);
  CHECK(first_line(hoop.out).rfind("30 steps, ", 0) == 0);
  const Run same = run_program({"simulate", "hoop", "--steps", "30"});
  CHECK(same.status == 0);
  CHECK(verdict(same.out) == "30 steps, 0 crossings");
}

TEST_CASE("the whip goes through the wire with the paper's solver, and not with ours") {
  // At which sizes the closed form errs is a matter of rounding.
  int through = 0;
  const std::string none = "30 steps, 0 crossings; left out: the radius of 1 cable that is not solid";
  for (const char* size : {"20", "30", "60", "150"}) {
    // Steps of 1.7 m: the scene's own are shorter.
    const std::vector<std::string> leap{
        "simulate",     "whip",           "--size",  size, "--time-step", "0.016666666666666666",
        "--integrator", "implicit-euler", "--steps", "30"};
    std::vector<std::string> by_paper = leap;
    by_paper.insert(by_paper.end(), {"--narrow-phase", "paper"});
    const Run paper = run_program(by_paper);
    CAPTURE(paper.out);
    CHECK(first_line(paper.out).rfind("30 steps, ", 0) == 0);
    if (paper.status == 1) {
      ++through;
      CHECK(occurrences(paper.out, "crossing: step ") >= 1);
      CHECK(occurrences(paper.out, " s: edge 0-1 and edge ") >= 1);
      CHECK(first_line(paper.out) != none);
    } else {
      CHECK(first_line(paper.out) == none);
    }
    const Run exact = run_program(leap);
    CHECK(exact.status == 0);
    CHECK(first_line(exact.out) == none);
  }
  CHECK(through >= 1);
}

TEST_CASE("a scene's passes are those that it needs") {
  const Run whip = run_program({"simulate", "whip", "--explain"});
  CHECK(whip.status == 0);
  CHECK(occurrences(whip.out, "yes  edge-edge pass") == 1);
  CHECK(occurrences(whip.out, "no   vertex-face pass") == 1);
  CHECK(occurrences(whip.out, "yes  bending forces") == 1);
  CHECK(occurrences(whip.out, "no   twist angles") == 1);
  const Run edges = run_program({"simulate", "two-edges", "--explain"});
  CHECK(occurrences(edges.out, "no   fold pass") == 1);
  CHECK(occurrences(edges.out, "no   friction") == 1);
  const Run hoop = run_program({"simulate", "hoop", "--explain"});
  CHECK(occurrences(hoop.out, "yes  vertex-face pass") == 1);
  CHECK(occurrences(hoop.out, "no   single-particle pass   every particle is in an edge, but 1 that") == 1);
  CHECK(occurrences(hoop.out, "yes  separations            ") == 1);
  CHECK(occurrences(hoop.out, " elements with radii of up to 0.009 m; 0 pairs of particles are neighbours\n") == 1);
  CHECK(occurrences(edges.out, "no   separations            no element has a radius\n") == 1);
  const Run paper = run_program({"simulate", "hoop", "--explain", "--narrow-phase", "paper"});
  CHECK(occurrences(paper.out, "no   separations            the narrow phase of the paper knows none") == 1);
}

TEST_CASE("a run that cannot go on leaves what it has proved, and goes on from there only to fail again") {
  const TemporaryFolder folder;
  // The wire 2-3 is driven through the pinned wire 0-1, which it would meet in the sixth step.
  const std::string scene = folder.write("through.json", R"({"touchstone_scene": 1, "settings": {"gravity": [0, 0, 0]},
      "particles": [{"position": [-1, 0, 0], "pinned": true}, {"position": [1, 0, 0], "pinned": true},
        {"position": [0, -1, 0.1],
         "path": [{"time": 0, "position": [0, -1, 0.1]}, {"time": 1, "position": [0, -1, -1]}]},
        {"position": [0.1, 1, 0.1],
         "path": [{"time": 0, "position": [0.1, 1, 0.1]}, {"time": 1, "position": [0.1, 1, -1]}]}],
      "wires": [[0, 1], [2, 3]]})");
  const Run run = run_program({"simulate", scene, "--out", folder.path("out"), "--proof", folder.path("proof.csv"),
                               "--checkpoint", folder.path("state.json")});
  CAPTURE(run.err);
  CHECK(run.status == 2);
  CHECK(occurrences(run.err, "step 6 at ") == 1);
  CHECK(occurrences(run.err, "edge 0-1 and edge 2-3 would touch at (0.05, 0, 0), and nothing of them is free") == 1);
  CHECK(occurrences(run.err, "\n") == 1);
  CHECK(folder.names() == std::set<std::string>{"out", "proof.csv", "state.json", "through.json"});
  CHECK(cells_of(lines_of(folder.read("proof.csv")).back())[0] == "5");
  CHECK(cells_of(lines_of(folder.read("out/energies.csv")).back())[0] == "5");
  CHECK(occurrences(folder.read("out/frames/frames.vtk.series"), "frame-000005.vtk") == 1);
  const Run again = run_program({"simulate", "--resume", folder.path("state.json")});
  CHECK(again.status == 2);
  CHECK(occurrences(again.err, "step 6 at ") == 1);
}

TEST_CASE("bad usage and bad scenes end with status 2, one line, and nothing written") {
  const TemporaryFolder folder;
  const auto check_refused = [&](const std::vector<std::string>& arguments, const std::string& part) {
    const Run run = run_program(arguments);
    CAPTURE(arguments, run.err, run.out);
    CHECK(run.status == 2);
    CHECK(run.out == "");
    CHECK(occurrences(run.err, "\n") == 1);
    CHECK(occurrences(run.err, part) == 1);
  };
  check_refused({"simulate"}, "name a scene, or a checkpoint with --resume");
  check_refused({"simulate", "hoop", "--resume", "x"}, "not both");
  check_refused({"simulate", "hoop", "--size", "3"}, "--size 3: hoop takes 200 to 50000");
  check_refused({"simulate", folder.path("none.json")}, "none.json: cannot be opened");
  check_refused({"simulate", "hop"},
                "'hop' is no file, and no scene that comes with the program: these are two-edges, ho");
  check_refused({"simulate", folder.write("bad.json", "{\"touchstone_scene\": 1, \"particles\": [{}]}")},
                "bad.json: particles[0]: lacks the key 'position'");
  const std::string near = folder.write("near.json", R"({"touchstone_scene": 1, "particles": [
      {"position": [0, 0, 0], "mass": 1, "radius": 0.5}, {"position": [1, 0, 0], "mass": 1, "radius": 0.75}]})");
  check_refused({"simulate", near},
                "near.json: the scene begins with elements that are too near: particle 0 and particle 1 are 1 m apart, "
                "and their radii ask for more than 1.25 m");
  check_refused({"simulate", folder.path("bad.json"), "--size", "4"}, "only shipped scenes are made to a size");
  check_refused({"simulate", "hoop", "--threads", "0"}, "--threads");
  check_refused({"simulate", "hoop", "--narrow-phase", "best"}, "--narrow-phase");
  check_refused({"simulate", "--resume", folder.path("bad.json")}, "bad.json: the checkpoint's digest does not match");
  check_refused({"simulate", "two-edges", "--proof", folder.path("no/proof.csv")}, "cannot be written");
  check_refused({"simulate", "two-edges", "--checkpoint", folder.path("no/state.json")}, "cannot be written");
  check_refused({"simulate", "--resume", "x", "--size", "9"}, "--size: a checkpoint has its size");
  const std::string energies = folder.path("energies.csv");
  check_refused({"simulate", "stack", "--follow", "body:0"}, "neither is given");
  check_refused({"simulate", "stack", "--energies", energies, "--follow", "box"}, "--follow: neither the number of a");
  check_refused({"simulate", "stack", "--energies", energies, "--follow", "body:99"},
                "--follow: there is no such body");
  check_refused({"simulate", "hoop", "--energies", energies, "--follow", "body:0"}, "no such body: there are 0");
  check_refused({"simulate", "stack", "--energies", energies, "--follow", "body:1:8"}, "the body has 8");
  check_refused({"simulate", "hoop", "--energies", energies, "--follow", "99999"}, "there is no such particle");
  CHECK(folder.names() == std::set<std::string>{"bad.json", "near.json"});

  const std::string scene = folder.path("scene.json");
  CHECK(run_program({"simulate", "two-edges", "--scene-out", scene}).status == 0);
  const Run again = run_program({"simulate", scene, "--steps", "30"});
  CHECK(again.status == 0);
  CHECK(first_line(again.out) == "30 steps, 0 crossings");
}

TEST_CASE("a verdict says what was checked and what was left out") {
  const TemporaryFolder folder;
  const Run edges = run_program({"simulate", "two-edges", "--steps", "5"});
  const auto lines = lines_of(edges.out);
  REQUIRE(lines.size() >= 2);
  CHECK(lines[1] == "checked: no intersection at 0 s, and each step to 0.0833333333 s, of 2 edges");
  CHECK(lines.front() == "5 steps, 0 crossings");
  const Run hoop = run_program({"simulate", "hoop", "--size", "200", "--steps", "1"});
  CHECK(occurrences(first_line(hoop.out), "1 steps, 0 crossings; left out: 1 particle and ") == 1);
  CHECK(occurrences(first_line(hoop.out), " springs that do not collide") == 1);
  const std::string state = folder.path("state.json");
  CHECK(run_program({"simulate", "two-edges", "--steps", "5", "--checkpoint", state}).status == 0);
  const Run rest = run_program({"simulate", "--resume", state, "--steps", "1"});
  CHECK(occurrences(rest.out, "checked: no intersection at 0.0833333333 s, and each step to 0.1 s, of") == 1);
  CHECK(first_line(run_program({"simulate", "two-edges", "--steps", "0"}).out) ==
        "0 steps, 0 crossings; warning: only the start was asked about");
  const std::string still = folder.write("still.json", R"({"touchstone_scene": 1, "particles": [
      {"position": [0, 0, 0], "mass": 1, "collides": false}, {"position": [1, 0, 0], "mass": 1, "collides": false}],
      "springs": [{"particles": [0, 1], "stiffness": 1, "collides": false}]})");
  CHECK(first_line(run_program({"simulate", still, "--steps", "1"}).out) ==
        "1 steps, 0 crossings; warning: nothing collides, so no pair was asked about; left out: 2 particles and 1 "
        "spring that do not collide");
}

TEST_CASE("a scene that starts pierced is refused, with the file, the elements and the place") {
  const TemporaryFolder folder;
  const std::string particles = R"("particles": [{"position": [-1, -1, 0], "mass": 1},
      {"position": [1, -1, 0], "mass": 1}, {"position": [0, 1, 0], "mass": 1}, {"position": [0, -0.25, -1], "mass": 1},
      {"position": [0, -0.25, 1], "mass": 1}], "faces": [[0, 1, 2]])";
  const std::string spring = R"("springs": [{"particles": [3, 4], "stiffness": 10}])";
  const std::string cable = R"("cables": [{"particles": [3, 4], "radius": 0.01, "solid": true, "density": 1000,
      "young": 1e6}])";
  for (const std::string& through : {spring, cable}) {
    const std::string file = folder.write("bad.json", "{\"touchstone_scene\": 1, " + particles + ", " + through + "}");
    const Run run = run_program({"simulate", file, "--out", folder.path("out")});
    CHECK(run.status == 2);
    CHECK(run.out.empty());
    CHECK(occurrences(run.err, "\n") == 1);
    CHECK(occurrences(run.err,
                      "bad.json: the scene begins with elements that pierce each other: edge 3-4 and face "
                      "0-1-2 at (0, -0.25, 0); positions at which all elements are apart would be right") == 1);
    CHECK(folder.names() == std::set<std::string>{"bad.json"});
  }
}
