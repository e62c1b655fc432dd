// Checkpoints: a state that a run reaches is accepted. A state that no run reaches is refused, and its key is named.
// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include <cmath>
#include <functional>
#include <numbers>

#include <touchstone/error.hpp>

#include "io/sealed_json.hpp"
#include "scene/parts.hpp"
#include "scene/shipped_scenes.hpp"
#include "sim/checkpoint.hpp"
#include "sim/simulation.hpp"
#include "sim/state_check.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::sim;
using Json = nlohmann::json;

namespace {

/// Everything that a state holds: cables that are driven, turned at an end, closed and twisted, loose; particles on
/// paths and held in one coordinate.
Scene busy_scene(Integrator integrator) {
  Scene scene;
  scene.settings.integrator = integrator;
  scene.settings.time_step = 1.0 / 300;
  const auto cable = [&](const Vector3& from, const Vector3& to, Index segments) -> Cable& {
    scene.cables.push_back(straight_cable(scene, from, to, segments));
    Cable& made = scene.cables.back();
    set_material(made, 1e5, 0.4, 0.01, 1200);
    made.damping = 0.01;
    return made;
  };
  Cable& turned = cable({0, 0, 1}, {1, 0, 1}, 6);
  turned.start = {true, 3, 0.05};
  turned.end = {true, -40, 1e9};
  scene.particles[turned.particles.back()].fixed = {true, true, true};
  scene.particles[turned.particles.front()].path = {
      {0.01, {0, 0, 1}}, {0.02, {0.1, 0, 1.1}}, {0.03, {0, 0.1, 1.05}}, {0.2, {-0.1, 0.3, 1}}};
  Cable& loose = cable({0, 1, 1}, {1, 1, 1.3}, 5);
  scene.particles[loose.particles[2]].velocity = {3, 20, -4};
  scene.particles[loose.particles[3]].fixed = {false, true, false};
  Cable& ring = scene.cables.emplace_back();
  for (int i = 0; i < 12; ++i) {
    const double phi = 2 * std::numbers::pi * i / 12;
    ring.particles.push_back(add_particle(scene, {3 + std::cos(phi), std::sin(phi), 0.5 + 0.1 * std::sin(3 * phi)}, 0));
  }
  ring.closed = true;
  set_material(ring, 1e5, 0.4, 0.02, 1200);
  ring.closing_twist_rate = 20;
  ring.rest_is_bent = true;
  add_floor(scene, 10);
  return scene;
}

std::string text_of(const Simulation& simulation) { return checkpoint_to_json(simulation); }

/// @returns the checkpoint that is written then; when it is refused, nothing may have changed
std::string resume(const std::string& text) {
  Checkpoint checkpoint = checkpoint_from_json(text);
  Simulation simulation(checkpoint.scene, {});
  const std::string before = checkpoint_to_json(simulation);
  try {
    simulation.resume(std::move(checkpoint.state), checkpoint.steps, std::move(checkpoint.bodies));
  } catch (...) {
    CHECK((checkpoint_to_json(simulation) == before));
    throw;
  }
  return checkpoint_to_json(simulation);
}

void check_checkpoint_refused(const std::string& text, const std::string& message) {
  try {
    resume(text);
  } catch (const touchstone::Error& error) {
    CHECK_THAT(error.what(), Catch::StartsWith(message));
    CHECK(std::string(error.what()).find('\n') == std::string::npos);
    return;
  }
  FAIL_CHECK("it was accepted, and not refused with " + message);
}

/// A checkpoint's text with a digest that matches, so that its content is looked at.
std::string sealed(Json json) {
  json.erase("sha256");
  return io::sealed_json(json.dump());
}

std::string number(double value) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%a", value);
  return text.data();
}

}  // namespace

TEST_CASE("what a run comes to is accepted, at every step and by every integrator") {
  for (const auto integrator :
       {Integrator::implicit_euler, Integrator::tr_bdf2, Integrator::implicit_midpoint, Integrator::symplectic_euler}) {
    CAPTURE(integrator_name(integrator));
    Scene scene = busy_scene(integrator);
    if (integrator == Integrator::symplectic_euler) scene.settings.time_step = 2e-5;
    Simulation simulation(scene, {});
    for (int i = 0; i < 40; ++i) {
      const std::string text = text_of(simulation);
      CHECK((resume(text) == text));
      simulation.step();
    }
  }
  for (const auto& shipped : shipped_scenes()) {
    CAPTURE(shipped.name);
    Simulation simulation(make_shipped_scene(shipped.name, shipped.least), {});
    for (int i = 0; i < 30; ++i) simulation.step();
    const std::string text = text_of(simulation);
    CHECK((resume(text) == text));
  }
}

TEST_CASE("a checkpoint whose text is damaged is refused") {
  const Simulation simulation(make_shipped_scene("two-edges", 1), {});
  const std::string good = text_of(simulation);
  CHECK_NOTHROW(resume(good));
  const std::string mismatch =
      "the checkpoint's digest does not match its content: the file is damaged or no checkpoint";
  for (const char* text : {"", "x", "[]", "{}", "\n", "{\n}"}) check_checkpoint_refused(text, mismatch);
  const auto with = [&](const char* key, const Json& value) {
    Json json = Json::parse(good);
    json[key] = value;
    return sealed(json);
  };
  check_checkpoint_refused(io::sealed_json("{x"), "no JSON");
  check_checkpoint_refused(io::sealed_json("{\"q\": []}"), "the checkpoint: lacks the key 'touchstone_checkpoint'");
  check_checkpoint_refused(with("colour", 1), "the checkpoint: has no key 'colour'");
  check_checkpoint_refused(with("touchstone_checkpoint", 3), "touchstone_checkpoint: must be 2");
  check_checkpoint_refused(with("q", "0x1p+0"), "q: must be a list");
  check_checkpoint_refused(with("time", 0.5), "time: must be a string");
  for (const char* text : {"", "nan", "inf", "1e999", " 1", "0x1p0 ", "zz"}) {
    CAPTURE(text);
    check_checkpoint_refused(with("time", text), "time: is no finite hexfloat, such as \"0x1.8p-2\"");
  }
  check_checkpoint_refused(with("scene", 3), "scene: must be a string");
  check_checkpoint_refused(with("scene", "{}"), "scene: the scene: lacks the key 'touchstone_scene'");
  std::string twice = good;
  twice.replace(0, twice.find('\n'), "{\"steps\": 0, ");
  check_checkpoint_refused(io::sealed_json(twice), "steps: the key is there twice in one object");
  for (const Json& steps : {Json(-1), Json(1.5), Json("3"), Json(1'000'000'000'001), Json(1e300)}) {
    CAPTURE(steps.dump());
    check_checkpoint_refused(with("steps", steps), "steps: must be a whole number from 0 to 1000000000000");
  }
}

TEST_CASE("no bit of a checkpoint can change unnoticed") {
  std::string text = text_of(Simulation(make_shipped_scene("two-edges", 1), {}));
  for (std::size_t i = 0; i < text.size(); ++i) {
    for (int bit = 0; bit < 8; ++bit) {
      text[i] = static_cast<char>(text[i] ^ (1 << bit));
      std::string message = "none";
      try {
        checkpoint_from_json(text);
      } catch (const Error& error) {
        message = error.what();
      }
      text[i] = static_cast<char>(text[i] ^ (1 << bit));
      CAPTURE(i, bit);
      REQUIRE(message == "the checkpoint's digest does not match its content: the file is damaged or no checkpoint");
    }
  }
  CHECK_NOTHROW(resume(text));
  for (const std::size_t size : {text.size() - 1, text.size() / 2, std::size_t{70}}) {
    CHECK_THROWS_AS(checkpoint_from_json(text.substr(0, size)), Error);
  }
  CHECK_THROWS_AS(checkpoint_from_json(text + "\n"), Error);
}

TEST_CASE("a checkpoint of an older version, which has no digest, is refused as such") {
  Json json = Json::parse(text_of(Simulation(make_shipped_scene("two-edges", 1), {})));
  json.erase("sha256");
  json["touchstone_checkpoint"] = 1;
  check_checkpoint_refused(json.dump(1),
                           "the checkpoint has no digest, as an older version wrote it; start the run again");
}

TEST_CASE("a state that a run of its scene cannot come to is refused by its key") {
  Simulation simulation(busy_scene(Integrator::implicit_euler), {});
  for (int i = 0; i < 10; ++i) simulation.step();
  const System& system = simulation.system();
  const State& state = simulation.state();
  const std::string good = text_of(simulation);
  const auto with = [&](const std::function<void(Json&)>& damage) {
    Json json = Json::parse(good);
    damage(json);
    return sealed(json);
  };
  const auto at = [&](const char* key, std::size_t i, double value) {
    return with([&](Json& json) { json[key][i] = number(value); });
  };
  const auto next = [](double x) { return std::nextafter(x, 2.0 * std::abs(x) + 1); };
  CHECK_NOTHROW(resume(good));

  SECTION("time and steps go together, to the last bit") {
    const double step = simulation.scene().settings.time_step;
    check_checkpoint_refused(with([&](Json& json) { json["steps"] = 11; }), "time: after 11 steps of ");
    check_checkpoint_refused(with([&](Json& json) { json["time"] = number(next(10 * step)); }),
                             "time: after 10 steps of ");
    // Where time cannot tell them apart any more, the driven particle is not where it would be.
    check_checkpoint_refused(with([&](Json& json) {
                               json["steps"] = 1'000'000'000'000;
                               json["time"] = number(1e12 * step);
                             }),
                             "q[0]: the x of particle 0 is driven: at 3333333333.3");
  }
  SECTION("sizes") {
    for (const char* key : {"q", "v", "directors", "reference_twists"}) {
      CAPTURE(key);
      const std::string size = std::string(key) + ": has ";
      check_checkpoint_refused(with([&](Json& json) { json[key] = Json::array(); }),
                               size + "0 numbers, and this scene needs ");
      const std::size_t extra = key == std::string("directors") ? 3 : 1;
      check_checkpoint_refused(with([&](Json& json) {
                                 for (std::size_t i = 0; i < extra; ++i) json[key].push_back("0x0p+0");
                               }),
                               size);
    }
    check_checkpoint_refused(with([&](Json& json) { json["directors"].push_back("0x0p+0"); }),
                             "directors: must be three numbers a segment");
  }
  SECTION("what is held or driven is where the scene says, to the last bit") {
    const auto last = static_cast<std::size_t>(simulation.scene().cables[0].particles.back());
    const auto ghost = static_cast<std::size_t>(system.ghosts[0]);
    check_checkpoint_refused(at("q", 0, next(state.q[0])), "q[0]: the x of particle 0 is driven: at 0.0333");
    check_checkpoint_refused(
        at("q", 3 * last + 2, next(state.q[static_cast<Eigen::Index>(3 * last + 2)])),
        "q[" + std::to_string(3 * last + 2) + "]: the z of particle " + std::to_string(last) + " is held");
    check_checkpoint_refused(at("q", 3 * ghost, 17), "q[" + std::to_string(3 * ghost) + "]: the x of particle");
    const auto angle = static_cast<std::size_t>(system.angle(system.driven_angles[1].edge));
    check_checkpoint_refused(at("q", angle, 0.25), "q[" + std::to_string(angle) + "]: the twist of segment ");
    check_checkpoint_refused(at("v", 3 * last, 1e-300),
                             "v[" + std::to_string(3 * last) + "]: the x of particle 6 is held");
    check_checkpoint_refused(at("v", 0, 50),
                             "v[0]: the x of particle 0 is driven, and nothing in this scene is driven faster");
  }
  SECTION("directors have length 1 and are across their segments") {
    const std::string director = "directors[0]: this and the next two numbers, the director of segment 0-1, must ";
    check_checkpoint_refused(with([&](Json& json) {
                               for (std::size_t k = 0; k < 3; ++k)
                                 json["directors"][k] =
                                     number((1 + 1e-14) * state.frames.director[0][static_cast<int>(k)]);
                             }),
                             director + "have length 1");
    check_checkpoint_refused(with([&](Json& json) {
                               for (std::size_t k = 0; k < 3; ++k) json["directors"][k] = number(0);
                             }),
                             director + "have length 1, not 0");
    const Vector3 along = (position(state.q, 1) - position(state.q, 0)).normalized();
    const Vector3 leaning = (state.frames.director[0] + 1e-5 * along).normalized();
    check_checkpoint_refused(with([&](Json& json) {
                               for (std::size_t k = 0; k < 3; ++k)
                                 json["directors"][k] = number(leaning[static_cast<int>(k)]);
                             }),
                             director + "be perpendicular to it: the cosine between them is 1e-05");
  }
  SECTION("twists are those by which the directors differ, and whole turns") {
    const double twist = state.frames.reference_twist[2];
    CHECK_NOTHROW(resume(at("reference_twists", 2, twist + 6 * std::numbers::pi)));
    check_checkpoint_refused(at("reference_twists", 2, twist + 1e-6),
                             "reference_twists[2]: the directors of segments 2-3 and 3-4");
    check_checkpoint_refused(at("reference_twists", 2, 1e300),
                             "reference_twists[2]: 1e+300 is not in [-1000000000000, 1");
  }
  SECTION("elements that touch") {
    Simulation edges(make_shipped_scene("two-edges", 1), {});
    Json json = Json::parse(text_of(edges));
    const VectorX& q = edges.state().q;
    // One edge's end is put on the other's.
    for (int k = 0; k < 3; ++k) json["q"][static_cast<std::size_t>(6 + k)] = number(q[k]);
    check_checkpoint_refused(sealed(json), "q: the checkpoint begins with elements that touch: edge 0-1 and edge 2-3");
  }
}
