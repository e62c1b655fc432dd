// `touchstone generate --meshes`: frames that are free of contact but for the crossing that was asked for, the same
// bytes every time, and a folder that appears whole.
// SPDX-License-Identifier: MIT
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <touchstone/mesh.hpp>

#include "cli/run_program.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

std::vector<std::string> generate_meshes(const std::string& out, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments = {"generate", "--meshes", "--size", "900", "--out", out};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/// What an OBJ file of triangles and lines holds.
struct Obj {
  MeshElements elements;
  std::vector<double> positions;
  std::vector<std::string> groups;      ///< in the order of the file
  std::vector<std::size_t> group_ends;  ///< the number of faces before the next group
};

Obj obj_of(const std::string& text) {
  Obj obj;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string keyword, word;
    words >> keyword;
    std::vector<std::string> rest;
    while (words >> word) rest.push_back(word);
    const auto vertex = [&](std::size_t i) { return static_cast<MeshIndex>(std::stoul(rest.at(i)) - 1); };
    if (keyword == "v") {
      for (const std::string& number : rest) obj.positions.push_back(std::strtod(number.c_str(), nullptr));
      ++obj.elements.vertex_count;
    } else if (keyword == "f") {
      REQUIRE(rest.size() == 3);
      obj.elements.faces.push_back({vertex(0), vertex(1), vertex(2)});
      if (!obj.groups.empty()) obj.group_ends.back() = obj.elements.faces.size();
    } else if (keyword == "l") {
      obj.elements.edges.push_back({vertex(0), vertex(1)});
    } else {
      REQUIRE(keyword == "g");
      REQUIRE(rest.size() == 1);
      obj.groups.push_back(rest[0]);
      obj.group_ends.push_back(0);
    }
  }
  REQUIRE(obj.positions.size() == 3 * obj.elements.vertex_count);
  return obj;
}

std::string frame(const std::string& folder, int number) {
  const std::string digits = std::to_string(number);
  return folder + "/frame-" + std::string(4 - digits.size(), '0') + digits + ".obj";
}

/// FNV-1a over the bytes.
std::uint64_t checksum(const std::string& text) {
  std::uint64_t sum = 0xCBF29CE484222325u;
  for (const char c : text) sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001B3u;
  return sum;
}

std::set<std::string> names_in(const std::string& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.insert(entry.path().filename().string());
  return names;
}

}  // namespace

TEST_CASE("the frames of a drape are free of contact, but for the two steps of a planted crossing", "[slow]") {
  const TemporaryFolder folder;
  const std::string seed = GENERATE("1", "2", "3");
  const std::string speed = GENERATE("1", "30");
  const int crossing = GENERATE(0, 1, 3, 5);
  std::vector<std::string> more = {"--steps", "6", "--seed", seed, "--speed", speed};
  if (crossing > 0) more.insert(more.end(), {"--crossing", std::to_string(crossing)});
  const Run run = run_program(generate_meshes(folder.path("a"), more));
  CAPTURE(seed, speed, crossing, run.out, run.err);
  REQUIRE(run.status == 0);
  CHECK(run.err == "");
  CHECK(occurrences(run.out, folder.path("a/drape") + ": 7 frames of ") == 1);
  REQUIRE(names_in(folder.path("a/drape")).size() == 7);

  std::vector<Obj> frames;
  for (int i = 0; i <= 6; ++i) frames.push_back(obj_of(folder.read(frame("a/drape", i))));
  const Mesh mesh(frames[0].elements);
  CHECK(frames[0].groups == std::vector<std::string>{"cloth", "sphere"});
  for (int i = 1; i <= 6; ++i) {
    const auto index = static_cast<std::size_t>(i);
    const Positions x0(frames[index - 1].positions, 3), x1(frames[index].positions, 3);
    REQUIRE(frames[index].elements.faces == frames[0].elements.faces);
    const FirstContact found = first_contact(mesh, x0, x1);
    CAPTURE(i);
    REQUIRE(found.free() == (crossing == 0 || (i != crossing && i != crossing + 1)));
    REQUIRE(intersections(mesh, x1).empty() == (crossing == 0 || i != crossing));
    if (found.free()) continue;
    const MeshPair pair = found.earliest.at(0).pair;
    CHECK(pair.kind == Kind::vertex_face);
    CHECK(pair.second >= frames[0].group_ends[0]);  // of the sphere
    CHECK(occurrences(run.out, "\nvertex " + std::to_string(pair.first + 1) + " goes through the sphere in step " +
                                   std::to_string(crossing) + ", which ends at " + frame("", crossing).substr(1) +
                                   ", and back in step " + std::to_string(crossing + 1) + "\n") == 1);
  }
  CHECK(occurrences(run.out, "goes through") == (crossing > 0 ? 1 : 0));
}

TEST_CASE("a planted crossing changes one vertex of one frame") {
  const TemporaryFolder folder;
  REQUIRE(run_program(generate_meshes(folder.path("a"), {"--steps", "4"})).status == 0);
  REQUIRE(run_program(generate_meshes(folder.path("b"), {"--steps", "4", "--crossing", "2"})).status == 0);
  for (int i = 0; i <= 4; ++i) {
    const std::string a = folder.read(frame("a/drape", i)), b = folder.read(frame("b/drape", i));
    std::istringstream lines_a(a), lines_b(b);
    std::string line_a, line_b;
    std::size_t differences = 0;
    while (std::getline(lines_a, line_a) && std::getline(lines_b, line_b)) differences += line_a != line_b ? 1 : 0;
    CHECK(differences == (i == 2 ? 1 : 0));
  }
}

TEST_CASE("the frames of every scene are the same bytes, every time and on every machine") {
  const TemporaryFolder folder;
  const auto more = [](const std::string& scene) { return std::vector<std::string>{"--steps", "3", "--scene", scene}; };
  const auto [scene, groups, expected] =
      GENERATE(table<std::string, std::size_t, std::uint64_t>({{"cloth", 2, 0xAA2DD4B13A31B2D7},
                                                               {"sheets", 2, 0xAF5029FF180B8433},
                                                               {"cables", 0, 0x7ADB9C69CEFF4262},
                                                               {"drape", 2, 0x8B7BDC57B7F189CA}}));
  REQUIRE(run_program(generate_meshes(folder.path("a"), more(scene))).status == 0);
  REQUIRE(run_program(generate_meshes(folder.path("b"), more(scene))).status == 0);
  std::string all;
  for (int i = 0; i <= 3; ++i) {
    const std::string text = folder.read(frame("a/" + scene, i));
    CHECK(text == folder.read(frame("b/" + scene, i)));
    all += text;
  }
  CAPTURE(scene);
  CHECK(checksum(all) == expected);
  const Obj obj = obj_of(folder.read(frame("a/" + scene, 3)));
  CHECK(obj.groups.size() == groups);
  CHECK(obj.elements.faces.empty() == (scene == "cables"));
  CHECK(obj.elements.edges.empty() == (scene != "cables"));
  CHECK_NOTHROW(Mesh(obj.elements));
  CHECK(run_program(generate_meshes(folder.path("c"), {"--steps", "3", "--seed", "2", "--scene", scene})).status == 0);
  CHECK(folder.read(frame("c/" + scene, 0)) != folder.read(frame("a/" + scene, 0)));
}

TEST_CASE("a folder of frames is never mixed with files that were there") {
  const TemporaryFolder folder;
  const std::string mine = folder.write("a/drape/frame-0000.obj", "mine");
  const Run run = run_program(generate_meshes(folder.path("a"), {"--steps", "2"}));
  CHECK(run.status == 2);
  CHECK(run.out == "");
  CHECK(occurrences(run.err, "a/drape: is there already") == 1);
  CHECK(folder.read("a/drape/frame-0000.obj") == "mine");
  CHECK(names_in(folder.path("a")) == std::set<std::string>{"drape"});

  // One scene cannot be written: the others are not either.
  CHECK(run_program(generate_meshes(folder.path("a"), {"--steps", "2", "--scene", "cables", "--scene", "drape"}))
            .status == 2);
  CHECK(names_in(folder.path("a")) == std::set<std::string>{"drape"});

  const Run twice = run_program(generate_meshes(folder.path("b"), {"--scene", "cables", "--scene", "cables"}));
  CHECK(twice.status == 2);
  CHECK(occurrences(twice.err, "--scene cables is given twice") == 1);
  CHECK_FALSE(std::filesystem::exists(folder.path("b")));

  std::filesystem::remove(mine);  // an empty folder will do
  CHECK(run_program(generate_meshes(folder.path("a"), {"--steps", "2"})).status == 0);
  CHECK(names_in(folder.path("a/drape")).size() == 3);

  folder.write("file", "");
  CHECK(run_program(generate_meshes(folder.path("file"), {"--steps", "2"})).status == 2);
}

TEST_CASE("what a killed run left is removed by the next one, and another run's folder is not") {
  const TemporaryFolder folder;
  const std::string partial = "a/drape.touchstone-1.partial";
  const pid_t child = ::fork();
  if (child == 0) {
    const std::string out = folder.path("a");
    ::execl(TOUCHSTONE_PROGRAM, "touchstone", "generate", "--meshes", "--size", "20000", "--steps", "100000", "--out",
            out.c_str(), nullptr);
    ::_exit(127);
  }
  const std::string second = folder.path(partial) + "/frame-0001.obj";
  const std::string second_of_many = folder.path(partial) + "/frame-000001.obj";
  for (int i = 0; i < 3000 && !std::filesystem::exists(second) && !std::filesystem::exists(second_of_many); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  CHECK(std::filesystem::exists(folder.path(partial)));
  CHECK_FALSE(std::filesystem::exists(folder.path("a/drape")));
  // While it runs, its folder is its own.
  CHECK(run_program(generate_meshes(folder.path("a"), {"--steps", "2"})).status == 0);
  CHECK(std::filesystem::exists(folder.path(partial)));
  std::filesystem::remove_all(folder.path("a/drape"));
  ::kill(child, SIGKILL);
  int status = 0;
  ::waitpid(child, &status, 0);
  CHECK(std::filesystem::exists(folder.path(partial)));
  CHECK(run_program(generate_meshes(folder.path("a"), {"--steps", "2"})).status == 0);
  CHECK(names_in(folder.path("a")) == std::set<std::string>{"drape"});
}
