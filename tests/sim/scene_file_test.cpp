// Scenes as JSON: what is written is read again to the last bit, and what makes no sense is named.
// SPDX-License-Identifier: MIT
#include <touchstone/error.hpp>

#include "sim/scene_file.hpp"
#include "sim/shipped_scenes.hpp"
#include "sim/simulation.hpp"
#include "support/catch.hpp"

using namespace touchstone::sim;

namespace {

const std::string kTwoParticles =
    R"("particles": [{"position": [0, 0, 0], "mass": 1}, {"position": [1, 0, 0], "mass": 1}])";

std::string scene_with(const std::string& more) { return R"({"touchstone_scene": 1, )" + kTwoParticles + more + "}"; }

void check_refused(const std::string& text, const std::string& message) {
  CAPTURE(text);
  try {
    scene_from_json(text);
  } catch (const touchstone::Error& error) {
    CHECK_THAT(error.what(), Catch::Contains(message));
    CHECK(std::string(error.what()).find('\n') == std::string::npos);
    return;
  }
  FAIL_CHECK("it was accepted");
}

}  // namespace

TEST_CASE("every shipped scene is the same after a round trip through JSON") {
  for (const auto& shipped : shipped_scenes()) {
    CAPTURE(shipped.name);
    for (const Index size : {shipped.least, shipped.usual}) {
      const Scene scene = make_shipped_scene(shipped.name, size);
      const std::string text = scene_to_json(scene);
      const Scene again = scene_from_json(text);
      CHECK(scene_to_json(again) == text);
      CHECK(System(scene).initial_position == System(again).initial_position);
      CHECK(System(scene).mass == System(again).mass);
      CHECK(System(scene).force == System(again).force);
    }
  }
}

TEST_CASE("a scene from a file moves as the shipped one does, bit for bit") {
  const Scene scene = make_shipped_scene("chain", 10);
  Simulation shipped(scene, {}), read(scene_from_json(scene_to_json(scene)), {});
  for (int i = 0; i < 30; ++i) {
    shipped.step();
    read.step();
  }
  CHECK(shipped.state().q == read.state().q);
  CHECK(shipped.state().v == read.state().v);
}

TEST_CASE("cables from place to place, surfaces and held ends") {
  const Scene scene = scene_from_json(scene_with(
      R"(, "surfaces": [], "cables": [{"from": [0, 0, 1], "to": [0, 2, 1], "segments": 4, "radius": 0.01, "density": 1000,
          "young": 1e7, "poisson": 0.25, "start": {"hold": "clamped", "twist_rate": 2}, "end": {"hold": "pinned"}}])"));
  REQUIRE(scene.cables.size() == 1);
  const Cable& cable = scene.cables[0];
  CHECK(cable.particles.size() == 5);
  CHECK(cable.stretch == Approx(1e7 * 3.14159265 * 1e-4));
  CHECK(cable.bend == Approx(1e7 * 3.14159265 * 1e-8 / 4));
  CHECK(cable.twist == Approx(1e7 / 2.5 * 3.14159265 * 1e-8 / 2));
  CHECK(cable.start.clamped);
  CHECK_FALSE(cable.end.clamped);
  CHECK(scene.particles[cable.particles.back()].pinned());
  CHECK(System(scene).ghosts.size() == 1);

  const Scene tetrahedron = scene_from_json(
      R"({"touchstone_scene": 1, "particles": [{"position": [0, 0, 0], "mass": 1}, {"position": [1, 0, 0], "mass": 1},
          {"position": [0, 1, 0], "mass": 1}, {"position": [0, 0, 1], "mass": 1}],
          "surfaces": [{"faces": [[0, 1, 2], [0, 1, 3], [1, 2, 3], [0, 2, 3]], "stiffness": 50}]})");
  CHECK(tetrahedron.springs.size() == 6);
  CHECK(tetrahedron.faces.size() == 4);
}

TEST_CASE("a scene of very many elements is read in time that grows with their number") {
  // By the square of it, this takes many minutes.
  constexpr int kParticles = 1'000'000;
  std::string text = R"({"touchstone_scene": 1, "particles": [)";
  for (int i = 0; i < kParticles; ++i) {
    text += (i == 0 ? R"({"mass":1,"position":[)" : R"(,{"mass":1,"position":[)") + std::to_string(i) + ",0,0]}";
  }
  CHECK(scene_from_json(text + "]}").particles.size() == kParticles);
}

TEST_CASE("what makes no sense is refused with its path") {
  check_refused("", "no JSON");
  check_refused("{\"touchstone_scene\": 1,", "line 1");
  check_refused("[1]", "must be an object");
  check_refused("{}", "lacks the key 'touchstone_scene'");
  check_refused(R"({"touchstone_scene": 2})", "touchstone_scene: must be 1");
  check_refused(R"({"touchstone_scene": 1})", "particles: a scene must have some");
  check_refused(scene_with(R"(, "colour": 3)"), "has no key 'colour'");
  check_refused(scene_with(R"(, "springs": [], "springs": [])"), "springs: the key is there twice in one object");
  check_refused(R"({"touchstone_scene": 1, "particles": [{"position": [0, 0, 0], "mass": 1}, [[], {}, [[{"a": 1}],
                    {"mass": 1, "b": {"mass": 2}, "mass": 1}]]]})",
                "particles[1][2][1].mass: the key is there twice in one object");
  check_refused(R"({"a\nb": {"k": 0, "k": 0}})", "a\\nb.k: the key is there twice");
  check_refused(scene_with(R"(, "cables": [{"particles": [0, 1], "radius": 1, "density": 1}])"),
                "cables[0]: lacks the key 'young', or 'stretch' instead");
  check_refused(scene_with(R"(, "settings": {"time_step": 0})"), "settings.time_step: 0 is not in [1e-09, 1000]");
  check_refused(scene_with(R"(, "settings": {"time_step": "fast"})"), "settings.time_step: must be a number");
  check_refused(scene_with(R"(, "settings": {"time_step": 1e999})"), "no JSON");
  check_refused(scene_with(R"(, "settings": {"integrator": "rk4"})"), "settings.integrator: must be implicit-euler");
  check_refused(scene_with(R"(, "settings": {"gravity": [0, 0]})"),
                "settings.gravity: must be a list of three numbers");
  check_refused(scene_with(R"(, "settings": {"contact": {"restitution": 1.5}})"),
                "settings.contact.restitution: 1.5 is not in [0, 1]");
  check_refused(scene_with(R"(, "settings": {"contact": {"passes": 0}})"), "settings.contact.passes");
  check_refused(scene_with(R"(, "springs": [{"particles": [0, 7], "stiffness": 1}])"),
                "springs[0]: there is no particle 7");
  check_refused(scene_with(R"(, "springs": [{"particles": [0, 0], "stiffness": 1}])"),
                "springs[0].particles: particle 0 is there twice");
  check_refused(scene_with(R"(, "springs": [{"particles": [0, 1]}])"), "springs[0]: lacks the key 'stiffness'");
  check_refused(scene_with(R"(, "springs": [{"particles": [0, -1], "stiffness": 1}])"),
                "springs[0].particles[1]: must be a whole number");
  check_refused(scene_with(R"(, "springs": [{"particles": [0, 1], "stiffness": -1}])"),
                "springs[0].stiffness: -1 is not in");
  check_refused(scene_with(R"(, "wires": [[0, 1, 1]])"), "wires[0]: must be a list of 2");
  check_refused(scene_with(R"(, "faces": [[0, 1, 9]])"), "faces[0].particles: there is no particle 9");
  check_refused(scene_with(R"(, "cables": [{"particles": [0, 1], "radius": 0, "density": 1, "stretch": 1}])"),
                "cables[0].radius: 0 is not in");
  check_refused(
      scene_with(R"(, "cables": [{"particles": [0, 1], "radius": 1, "density": 1, "stretch": 1, "twist": 1}])"),
      "cables[0].twist");
  check_refused(
      scene_with(R"(, "cables": [{"particles": [0, 1], "radius": 1, "density": 1, "young": 1, "stretch": 1}])"),
      "cables[0].stretch: follows from");
  check_refused(scene_with(R"(, "cables": [{"particles": [0], "radius": 1, "density": 1, "stretch": 1}])"),
                "cables[0].particles");
  check_refused(
      scene_with(
          R"(, "cables": [{"from": [0, 0, 0], "to": [1, 0, 0], "segments": 0, "radius": 1, "density": 1, "stretch": 1}])"),
      "cables[0].segments: must be a whole number from 1");
  check_refused(
      scene_with(R"(, "cables": [{"particles": [0, 1, 0], "radius": 1, "density": 1, "stretch": 1, "bend": 1}])"),
      "cables[0].particles: at particle 1 the cable folds back");
  const std::string hidden =
      R"({"touchstone_scene": 1, "particles": [{"position": [0, 0, 0], "mass": 1, "collides": false},
          {"position": [1, 0, 0], "mass": 1}, {"position": [0, 1, 0], "mass": 1}], )";
  const std::string refusal = ".particles: particle 0 does not collide, and this does";
  check_refused(hidden + R"("wires": [[1, 0]]})", "wires[0]" + refusal);
  check_refused(hidden + R"("faces": [[1, 0, 2]]})", "faces[0]" + refusal);
  check_refused(hidden + R"("springs": [{"particles": [0, 1], "stiffness": 1}]})", "springs[0]" + refusal);
  check_refused(hidden + R"("cables": [{"particles": [0, 1], "radius": 1, "density": 1, "stretch": 1}]})",
                "cables[0]" + refusal);
  CHECK_NOTHROW(scene_from_json(hidden + R"("springs": [{"particles": [0, 1], "stiffness": 1, "collides": false}]})"));
  check_refused(R"({"touchstone_scene": 1, "particles": [{"position": [0, 0, 0]}]})",
                "particles[0].mass: 0 is not allowed");
  check_refused(
      R"({"touchstone_scene": 1, "particles": [{"position": [0, 0, 0], "mass": 1, "path": [{"time": 1, "position": [0, 0, 0]},
                    {"time": 1, "position": [1, 0, 0]}]}]})",
      "particles[0].path[1].time");
  check_refused(R"({"touchstone_scene": 1, "particles": [{"position": [0, 0, 0], "mass": 1, "pinned": 3}]})",
                "particles[0].pinned");
  check_refused(
      R"({"touchstone_scene": 1, "particles": [{"position": [0, 0, 0], "mass": 1}, {"position": [0, 0, 0], "mass": 1}],
                    "wires": [[0, 1]]})",
      "are in one place");
}

TEST_CASE("shipped scenes are found by name and made within their sizes") {
  CHECK_THROWS_WITH(make_shipped_scene("kitchen", std::nullopt), Catch::Contains("kitchen is no shipped scene"));
  CHECK_THROWS_WITH(make_shipped_scene("hoop", 3), Catch::Contains("--size 3"));
  CHECK(make_shipped_scene("hoop", std::nullopt).name == "hoop");
}
