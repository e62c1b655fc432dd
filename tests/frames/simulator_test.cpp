// The frames of a simulation read back, loose particles among them.
// SPDX-License-Identifier: MIT
#include <string>

#include "frames/frame.hpp"
#include "io/temporary_folder.hpp"
#include "scene/scene_file.hpp"
#include "scene/shipped_scenes.hpp"
#include "sim/output_text.hpp"
#include "support/catch.hpp"

using namespace touchstone;

namespace {

frames::Frame frame_of(const sim::Simulation& simulation) {
  const tests::TemporaryFolder folder;
  return frames::read_frame(folder.write("a.vtk", sim::vtk_frame(simulation)), 0, {});
}

void check_frame(const sim::Simulation& simulation) {
  const frames::Frame frame = frame_of(simulation);
  const auto& q = simulation.state().q;
  const auto& colliders = simulation.colliders();
  REQUIRE(frame.topology->vertex_count == simulation.scene().particles.size());
  for (std::size_t i = 0; i < frame.positions.size(); ++i) {
    REQUIRE(frame.positions[i] == q[static_cast<Eigen::Index>(i)]);
  }
  REQUIRE(frame.topology->faces.size() == colliders.faces().size());
  for (std::size_t i = 0; i < colliders.faces().size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) CHECK(frame.topology->faces[i][k] == colliders.faces()[i][k]);
  }
  REQUIRE(frame.topology->edges.size() == colliders.edges().size());
  for (std::size_t i = 0; i < colliders.edges().size(); ++i) {
    for (std::size_t k = 0; k < 2; ++k) CHECK(frame.topology->edges[i][k] == colliders.edges()[i][k]);
  }
}

}  // namespace

TEST_CASE("the frames of a shipped scene read back bit for bit") {
  for (const char* const name : {"hoop", "two-edges"}) {
    for (const sim::ShippedScene& shipped : sim::shipped_scenes()) {
      if (shipped.name != name) continue;
      CAPTURE(name);
      sim::Simulation simulation(shipped.make(shipped.least), {});
      check_frame(simulation);
      simulation.step();
      check_frame(simulation);
    }
  }
}

TEST_CASE("particles that collide and are in no edge are points of a frame") {
  const sim::Scene scene = sim::scene_from_json(
      R"({"touchstone_scene": 1, "particles": [{"position": [0, 0, 0], "mass": 1}, {"position": [1, 0, 0], "mass": 1},
          {"position": [0, 1, 0], "mass": 1}, {"position": [0, 0, 9], "mass": 1},
          {"position": [0, 0, 7], "mass": 1, "collides": false}, {"position": [0.1, 0, 8], "mass": 1}],
          "faces": [[0, 1, 2]]})");
  const sim::Simulation simulation(scene, {});
  check_frame(simulation);
  CHECK(frame_of(simulation).topology->points == std::vector<MeshIndex>{3, 5});
}
