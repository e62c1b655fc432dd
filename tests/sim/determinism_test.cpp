// A run writes the same bytes on any number of threads, and with a checkpoint as without.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <functional>
#include <string>

#include "scene/parts.hpp"
#include "scene/shipped_scenes.hpp"
#include "sim/checkpoint.hpp"
#include "sim/output_text.hpp"
#include "support/catch.hpp"

using namespace touchstone::sim;

namespace {

struct EndOfRun {
  std::string bytes;                           // the results of the proofs, and the last state
  std::uint64_t contacts = 0, most_pairs = 0;  // contacts: those of elements that were only close included
};

void go_on(Simulation& simulation, int steps, EndOfRun& course) {
  for (int i = 0; i < steps; ++i) {
    for (const SubstepRecord& record : simulation.step()) {
      course.bytes += proof_row(simulation, record);
      course.contacts += record.response.contacts + record.response.close;
      course.most_pairs = std::max(course.most_pairs, record.proof.pairs);
    }
  }
}

EndOfRun run_on_threads(const Scene& scene, int threads, int steps) {
  Simulation simulation(scene, {NarrowPhase::exact, threads});
  EndOfRun course;
  go_on(simulation, steps, course);
  course.bytes += checkpoint_to_json(simulation);
  return course;
}

EndOfRun run_with_a_stop(const Scene& scene, int steps, int stop) {
  Simulation first(scene, {});
  EndOfRun course;
  go_on(first, stop, course);
  Checkpoint checkpoint = checkpoint_from_json(checkpoint_to_json(first));
  REQUIRE(checkpoint.steps == static_cast<std::uint64_t>(stop));
  Simulation second(checkpoint.scene, {});
  second.resume(std::move(checkpoint.state), checkpoint.steps, std::move(checkpoint.bodies));
  go_on(second, steps - stop, course);
  course.bytes += checkpoint_to_json(second);
  return course;
}

/// A rod with natural curvature is wound up by one end and falls across two others, with friction; all of them bend,
/// twist and are damped, and a clamped end is driven.
Scene twisting_cables() {
  Scene scene;
  scene.settings.contact.friction = 0.4;
  scene.settings.contact.restitution = 0.2;
  scene.settings.drag = 0.3;
  for (int i = 0; i < 3; ++i) {
    const bool across = i == 2;
    Cable cable = across ? straight_cable(scene, {-0.3, 0.02, 0.06}, {0.32, -0.01, 0.08}, 24)
                         : straight_cable(scene, {0.2 * i - 0.1, -0.3, 0}, {0.2 * i - 0.11, 0.3, 0.01}, 20);
    set_material(cable, 2e6, 0.4, 0.004, 1100);
    cable.natural_curvature = {3.0, -1.0 * i};
    cable.damping = 2e-3;
    cable.start.clamped = true;
    cable.start.twist_rate = 30;
    cable.start.twist_until = 0.5;
    Particle& held = scene.particles[cable.particles.front()];
    held.fixed = {true, true, true};
    if (across) held.path = {{0, held.position}, {0.4, held.position + Vector3(0, 0, -0.05)}};
    cable.end.clamped = !across;
    if (!across) scene.particles[cable.particles.back()].fixed = {true, true, true};
    scene.cables.push_back(std::move(cable));
  }
  return scene;
}

/// The ball is just above the net, and comes down fast.
Scene hoop_at_once() {
  Scene scene = make_shipped_scene("hoop", 200);
  for (Particle& p : scene.particles) {
    if (p.pinned() || p.position.z() < 1.7) continue;
    p.position.z() -= 0.5;
    p.velocity.z() -= 8;
  }
  return scene;
}

/// A scene that is soft enough for explicit steps: cables without damping and with `softer` times their stretch.
Scene for_explicit_steps(Scene scene, double step, double softer) {
  scene.settings.time_step = step;
  scene.settings.integrator = Integrator::symplectic_euler;
  for (Cable& cable : scene.cables) {
    cable.damping = 0;
    cable.stretch *= softer;
  }
  return scene;
}

struct Row {
  const char* name;
  std::function<Scene()> make;
  int steps;
  double explicit_step;  // s
  int explicit_steps;
  double softer = 1;
  std::uint64_t pairs = 0;  // of an implicit step, at least
};

std::vector<Row> rows() {
  const auto shipped = [](const char* name, Index size) {
    return [=] {
      Scene scene = make_shipped_scene(name, size);
      scene.settings.time_step = 1.0 / 60;  // in so few steps they must meet contacts
      return scene;
    };
  };
  constexpr std::uint64_t kBlocks = 64 + 1;  // one thread takes blocks of 64: more are shared by two
  return {
      {"two-edges", shipped("two-edges", 40), 60, 1e-2, 90},
      {"hoop", hoop_at_once, 15, 2e-4, 250, 1, kBlocks},
      {"cable-drop", shipped("cable-drop", 100), 20, 2e-4, 600},
      {"whip", shipped("whip", 12), 20, 1e-4, 150},
      {"ring-twist", shipped("ring-twist", 24), 200, 5e-4, 10000},
      {"chain", shipped("chain", 12), 60, 2e-4, 5000, 1e-2},
      {"twisting cables", twisting_cables, 40, 1e-4, 1500},
  };
}

}  // namespace

TEST_CASE("the same bytes on one and two threads, and after a checkpoint as without", "[slow]") {
  const auto all = rows();
  const auto number = GENERATE_COPY(range(std::size_t{0}, all.size()));
  const auto integrator = GENERATE(Integrator::implicit_euler, Integrator::tr_bdf2, Integrator::implicit_midpoint,
                                   Integrator::symplectic_euler);
  const Row& row = all[number];
  CAPTURE(row.name, integrator_name(integrator));
  Scene scene = row.make();
  scene.settings.integrator = integrator;
  const bool is_explicit = integrator == Integrator::symplectic_euler;
  if (is_explicit) scene = for_explicit_steps(scene, row.explicit_step, row.softer);
  const int steps = is_explicit ? row.explicit_steps : row.steps;
  const EndOfRun once = run_on_threads(scene, 1, steps);
  CHECK(once.contacts > 0);
  if (!is_explicit) CHECK(once.most_pairs >= row.pairs);
  CHECK(run_on_threads(scene, 2, steps).bytes == once.bytes);
  CHECK(run_with_a_stop(scene, steps, 2 * steps / 3).bytes == once.bytes);
}
