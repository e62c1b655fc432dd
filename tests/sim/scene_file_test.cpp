// Scenes as JSON: a scene that is written is read again to the last bit, and an error is named by its path.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <tuple>

#include <touchstone/error.hpp>

#include "scene/scene_file.hpp"
#include "scene/shipped_scenes.hpp"
#include "sim/checkpoint.hpp"
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

TEST_CASE("nothing that a scene says is lost on the way through JSON") {
  // A scene with every key. Its numbers are no defaults and no short decimals.
  double last = 0.1;
  const auto odd = [&] { return last = 0.1 + std::fmod(last * 7.7, 0.83); };
  Scene scene;
  scene.settings = {odd(), odd(), Integrator::tr_bdf2,     {odd(), odd(), odd()}, odd(), odd(),
                    odd(), odd(), {odd(), odd(), odd(), 5}};
  for (int i = 0; i < 14; ++i) {
    Particle p;
    p.position = {i + odd(), odd(), 10 * odd()};
    p.velocity = {odd(), odd(), odd()};
    p.force = {odd(), odd(), odd()};
    p.mass = odd();
    scene.particles.push_back(p);
  }
  scene.particles[0].fixed = {false, true, false};
  scene.particles[4].fixed = scene.particles[6].fixed = {true, true, true};  // clamped ends are held
  scene.particles[1].path = {{odd(), {odd(), 30 + odd(), odd()}}, {2 + odd(), {odd(), 30, odd()}}};
  scene.particles[2].collides = false;
  scene.particles[1].radius = odd();
  scene.springs = {{0, 2, odd(), odd(), odd(), false}, {3, 4, odd(), odd(), odd(), true}};
  Cable cable;
  cable.particles = {4, 5, 6};
  cable.radius = odd();
  cable.density = odd();
  cable.stretch = odd();
  cable.bend = odd();
  cable.twist = odd();
  cable.damping = odd();
  cable.natural_curvature = {odd(), odd()};
  cable.length_scale = odd();
  cable.start = {true, odd(), odd()};
  cable.end = {true, odd(), odd()};
  scene.cables = {cable};
  cable.particles = {7, 8, 9, 10};
  cable.closed = cable.rest_is_bent = true;
  cable.natural_curvature = {};
  cable.start = cable.end = {};
  cable.closing_twist_rate = odd();
  cable.closing_twist_until = odd();
  scene.cables.push_back(cable);
  scene.springs[1].radius = odd();
  scene.cables.back().solid = true;
  scene.wires = {{{0, 3}, 0}, {{0, 4}, odd()}};
  scene.faces = {{{11, 12, 13}, odd()}, {{3, 11, 13}, 0}};
  scene.name = "odd \"name\"";
  const Scene again = scene_from_json(scene_to_json(scene));

  CHECK(again.name == scene.name);
  const Settings &s = scene.settings, &t = again.settings;
  CHECK(std::tie(t.time_step, t.duration, t.integrator, t.drag, t.newton_tolerance) ==
        std::tie(s.time_step, s.duration, s.integrator, s.drag, s.newton_tolerance));
  CHECK(t.gravity == s.gravity);
  CHECK(std::tie(t.contact.restitution, t.contact.friction, t.contact.thickness, t.contact.passes) ==
        std::tie(s.contact.restitution, s.contact.friction, s.contact.thickness, s.contact.passes));
  REQUIRE(again.particles.size() == scene.particles.size());
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    CAPTURE(i);
    const Particle &p = scene.particles[i], &q = again.particles[i];
    CHECK(q.position == p.position);
    CHECK(q.velocity == p.velocity);
    CHECK(q.force == p.force);
    CHECK(std::tie(q.mass, q.fixed, q.collides, q.radius) == std::tie(p.mass, p.fixed, p.collides, p.radius));
    REQUIRE(q.path.size() == p.path.size());
    for (std::size_t k = 0; k < p.path.size(); ++k) {
      CHECK(q.path[k].time == p.path[k].time);
      CHECK(q.path[k].position == p.path[k].position);
    }
  }
  REQUIRE(again.springs.size() == scene.springs.size());
  for (std::size_t i = 0; i < scene.springs.size(); ++i) {
    const Spring &a = scene.springs[i], &b = again.springs[i];
    CHECK(std::tie(b.a, b.b, b.stiffness, b.damping, b.rest_length, b.collides, b.radius) ==
          std::tie(a.a, a.b, a.stiffness, a.damping, a.rest_length, a.collides, a.radius));
  }
  REQUIRE(again.cables.size() == scene.cables.size());
  for (std::size_t i = 0; i < scene.cables.size(); ++i) {
    CAPTURE(i);
    const Cable &a = scene.cables[i], &b = again.cables[i];
    CHECK(b.particles == a.particles);
    CHECK(std::tie(b.closed, b.radius, b.solid, b.density, b.stretch, b.bend, b.twist, b.damping) ==
          std::tie(a.closed, a.radius, a.solid, a.density, a.stretch, a.bend, a.twist, a.damping));
    CHECK(std::tie(b.natural_curvature, b.rest_is_bent, b.length_scale) ==
          std::tie(a.natural_curvature, a.rest_is_bent, a.length_scale));
    CHECK(std::tie(b.closing_twist_rate, b.closing_twist_until) ==
          std::tie(a.closing_twist_rate, a.closing_twist_until));
    CHECK(std::tie(b.start.clamped, b.start.twist_rate, b.start.twist_until) ==
          std::tie(a.start.clamped, a.start.twist_rate, a.start.twist_until));
    CHECK(std::tie(b.end.clamped, b.end.twist_rate, b.end.twist_until) ==
          std::tie(a.end.clamped, a.end.twist_rate, a.end.twist_until));
  }
  CHECK(again.wires == scene.wires);
  CHECK(again.faces == scene.faces);
}

TEST_CASE("a scene without radii is written as before there were any, and the lists of elements take both forms") {
  const std::string particles =
      R"("particles": [
{"position":[0.0,0.0,0.0],"mass":1.0},
{"position":[1.0,0.0,0.0],"mass":1.0},
{"position":[0.0,1.0,0.0],"mass":1.0}])";
  const std::string springs = R"("springs": [
{"particles":[0,1],"stiffness":2.0,"damping":0.0,"rest_length":1.0}])";
  const auto written = [](const std::string& text) {
    const std::string all = scene_to_json(scene_from_json(text));
    return all.substr(all.find("\"particles\""));
  };
  const std::string begin = "{\"touchstone_scene\": 1,\n";
  const std::string thin =
      particles + ",\n" + springs + ",\n\"cables\": [],\n\"wires\": [\n[0,2]],\n\"faces\": [\n[0,1,2]]}\n";
  CHECK(written(begin + thin) == thin);
  const std::string objects = particles + ",\n" + springs +
                              ",\n\"cables\": [],\n\"wires\": [\n{\"particles\":[0,2],\"radius\":0.5}],\n\"faces\": "
                              "[\n{\"particles\":[0,1,2],\"radius\":0.25}]}\n";
  CHECK(written(begin + objects) == objects);
  const Scene scene = scene_from_json(begin + objects);
  CHECK(scene.wires == std::vector<Wire>{{{0, 2}, 0.5}});
  CHECK(scene.faces == std::vector<Facet>{{{0, 1, 2}, 0.25}});
  CHECK(has_radii(scene));
  CHECK_FALSE(has_radii(scene_from_json(begin + thin)));
  // An object without a radius is as a list.
  CHECK(scene_from_json(scene_with(R"(, "wires": [{"particles": [0, 1]}])")).wires == std::vector<Wire>{{{0, 1}, 0}});
}

TEST_CASE("radii that make no sense are refused with their path") {
  check_refused(scene_with(R"(, "wires": [{"particles": [0, 1], "radius": -1}])"),
                "wires[0].radius: -1 is neither 0 nor in [1e-12, 1000]");
  check_refused(scene_with(R"(, "wires": [{"particles": [0, 1], "radius": 1e-13}])"), "wires[0].radius: 1e-13 is");
  check_refused(scene_with(R"(, "wires": [{"particles": [0, 1], "radius": 1001}])"), "wires[0].radius: 1001 is");
  check_refused(scene_with(R"(, "wires": [{"particles": [0, 1], "radius": "1"}])"),
                "wires[0].radius: must be a number");
  check_refused(scene_with(R"(, "wires": [{"particles": [0, 1], "thickness": 1}])"),
                "wires[0]: has no key 'thickness'");
  check_refused(scene_with(R"(, "wires": [{"radius": 1}])"), "wires[0]: lacks the key 'particles'");
  check_refused(scene_with(R"(, "springs": [{"particles": [0, 1], "stiffness": 1, "radius": -0.5}])"),
                "springs[0].radius: -0.5 is");
  check_refused(scene_with(R"(, "springs": [{"particles": [0, 1], "stiffness": 1, "collides": false, "radius": 0.5}])"),
                "springs[0].radius: goes with a spring that collides");
  check_refused(
      scene_with(R"(, "cables": [{"particles": [0, 1], "radius": 1, "density": 1, "stretch": 1, "solid": 1}])"),
      "cables[0].solid: must be true or false");
  const std::string three =
      R"({"touchstone_scene": 1, "particles": [{"position": [0, 0, 0], "mass": 1},
          {"position": [1, 0, 0], "mass": 1}, {"position": [0, 1, 0], "mass": 1, "radius": )";
  check_refused(three + R"(-2}]})", "particles[2].radius: -2 is neither");
  check_refused(three + R"(2, "collides": false}]})", "particles[2].radius: goes with a particle that collides");
  check_refused(three + R"(2}], "wires": [[0, 1], [1, 2]]})", "particles[2].radius: it is a corner of wires[1]");
  check_refused(three + R"(2}], "faces": [[0, 1, 2]]})", "particles[2].radius: it is a corner of faces[0]");
  check_refused(three + R"(2}], "springs": [{"particles": [0, 2], "stiffness": 1}]})",
                "particles[2].radius: it is a corner of springs[0]");
  check_refused(three + R"(2}], "cables": [{"particles": [0, 2], "radius": 1, "density": 1, "stretch": 1}]})",
                "particles[2].radius: it is a corner of cables[0]");
  CHECK_NOTHROW(
      scene_from_json(three + R"(2}], "springs": [{"particles": [0, 2], "stiffness": 1, "collides": false}]})"));
  check_refused(three + R"(0}], "faces": [{"particles": [0, 1, 2], "radius": -3}]})", "faces[0].radius: -3 is");
  check_refused(three + R"(0}], "surfaces": [{"faces": [[0, 1, 2]], "stiffness": 1, "radius": -3}]})",
                "surfaces[0].radius: -3 is");
  const Scene cloth =
      scene_from_json(three + R"(0}], "surfaces": [{"faces": [[0, 1, 2]], "stiffness": 1, "radius": 0.125}]})");
  CHECK(cloth.faces == std::vector<Facet>{{{0, 1, 2}, 0.125}});
  Scene infinite = cloth;
  infinite.faces[0].radius = std::nan("");
  CHECK_THROWS_WITH(check_scene(infinite), Catch::Contains("faces[0].radius: nan is neither"));
  infinite.faces[0].radius = INFINITY;
  CHECK_THROWS_WITH(check_scene(infinite), Catch::Contains("faces[0].radius: inf is neither"));
}

TEST_CASE("a checkpoint is the whole state, to the last bit") {
  Scene scene = make_shipped_scene("ring-twist", 16);
  scene.settings.gravity = {1, 2, 3};
  Simulation simulation(scene, {});
  for (int i = 0; i < 30; ++i) simulation.step();
  const Checkpoint again = checkpoint_from_json(checkpoint_to_json(simulation));
  const State& state = simulation.state();
  CHECK(again.steps == 30);
  CHECK(again.state.time == state.time);
  CHECK(again.state.q == state.q);
  CHECK(again.state.v == state.v);
  CHECK(again.state.frames.director == state.frames.director);
  CHECK(again.state.frames.reference_twist == state.frames.reference_twist);
  // All of it differs from the initial state of the scene.
  const State fresh = Stepper(simulation.system(), scene.settings).initial();
  CHECK(state.q != fresh.q);
  CHECK(state.v != fresh.v);
  CHECK(state.frames.director != fresh.frames.director);
  CHECK(state.frames.reference_twist != fresh.frames.reference_twist);
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

TEST_CASE("a scene of very many elements is read in time that grows with their number", "[slow]") {
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
  check_refused(scene_with(R"(, "springs": [{"radius": [1, -10.5e-400]}])"),
                "springs[0].radius[1]: -10.5e-400 is too small for a double; write 0");
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
  // Its square is 0 in doubles, and so would be the stiffness that follows from it.
  for (const char* stiffness : {R"("young": 1e9)", R"("stretch": 1)"}) {
    check_refused(scene_with(R"(, "cables": [{"particles": [0, 1], "radius": 1e-200, "density": 1, )" +
                             std::string(stiffness) + "}]"),
                  "cables[0].radius: 1e-200 is not in");
  }
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
