// Moves a scene on by some steps, for a tool that counts the instructions of Simulation::step:
//   steps SCENE [with]
// SCENE is the feature that the scene lacks; with `with` it has it.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdio>
#include <string>

#include "scene/parts.hpp"
#include "scene/sheet.hpp"
#include "scene/shipped_scenes.hpp"
#include "sim/simulation.hpp"

using namespace touchstone::sim;

namespace {

/// A string that falls on crossed wires, and as many loose edges; a floor beneath when there are faces.
Scene strings_on_wires(bool faces) {
  Scene scene;
  scene.settings.contact.friction = 0.3;
  scene.settings.contact.thickness = 2e-3;
  for (int i = 0; i < 4; ++i) {
    const double at = 0.1 * i;
    Cable cable = straight_cable(scene, {-0.2, at, 0.02 + 0.02 * i}, {0.2, at + 0.05, 0.03 + 0.02 * i}, 8);
    set_material(cable, 1e7, 0.4, 0.003, 1200);
    cable.damping = 2e-3;
    scene.cables.push_back(cable);
    const Index a = add_pinned(scene, {at - 0.15, -0.5, 0}), b = add_pinned(scene, {at - 0.15, 0.6, 0});
    scene.wires.push_back({a, b});
  }
  if (faces) add_floor(scene, 1);
  return scene;
}

/// Edges that share no particle, each a stiff spring, falling on wires.
Scene loose_edges(bool folds) {
  Scene scene;
  scene.settings.contact.thickness = 2e-3;
  scene.settings.contact.friction = 0.3;
  for (int i = 0; i < 12; ++i) {
    const double z = 0.02 + 0.03 * i, turn = 0.7 * i;
    const Vector3 half(0.1 * std::cos(turn), 0.1 * std::sin(turn), 0.003 * i);
    const Index a = add_particle(scene, Vector3(0, 0, z) - half, 0.01);
    const Index b = add_particle(scene, Vector3(0, 0, z) + half, 0.01);
    add_spring(scene, a, b, 1e3, 0.1, true);
    if (folds) add_spring(scene, b, add_particle(scene, Vector3(0.05, 0.1, z) + half, 0.01), 1e3, 0.1, true);
  }
  add_floor(scene, 1);
  return scene;
}

/// A sheet above the floor.
Surface small_sheet(Scene& scene) {
  const std::size_t others = scene.particles.size();
  Surface surface;
  surface.faces = add_sheet(scene, {{-0.1, -0.3, 0.01}, {0.2, 0, 0}, {0, 0.2, 0}, 4}).faces;
  surface.stretch = 50;
  surface.bend = 1e-5;
  for (std::size_t p = others; p < scene.particles.size(); ++p) scene.particles[p].mass = 1e-3;
  return surface;
}

Scene scene_of(const std::string& lacking, bool with) {
  if (lacking == "faces") return strings_on_wires(with);
  if (lacking == "cloth") {
    Scene scene = strings_on_wires(true);
    if (with) scene.surfaces.push_back(small_sheet(scene));
    return scene;
  }
  if (lacking == "folds") return loose_edges(with);
  if (lacking == "friction") {
    Scene scene = strings_on_wires(true);
    if (!with) scene.settings.contact.friction = 0;
    return scene;
  }
  if (lacking == "separations") {
    Scene scene = strings_on_wires(true);
    for (Cable& cable : scene.cables) cable.solid = with;
    return scene;
  }
  if (lacking == "bodies") {
    Scene scene = strings_on_wires(true);
    if (!with) return scene;
    Body frame;
    frame.vertices = {{-0.1, -0.1, 0}, {0.1, -0.1, 0}, {0.1, 0.1, 0}, {-0.1, 0.1, 0}};
    frame.edges = {{0, 1}, {1, 2}, {2, 3}, {0, 3}};
    frame.density = 1;
    frame.pose.p = {0, 0.15, 0.3};
    scene.bodies = {frame};
    return scene;
  }
  Scene scene = loose_edges(true);
  if (with) {
    Cable cable = straight_cable(scene, {-0.4, 0.3, 0.1}, {0.4, 0.3, 0.1}, 12);
    set_material(cable, 1e7, 0.4, 0.003, 1200);
    scene.cables.push_back(cable);
  }
  return scene;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 2) return 2;
  Simulation simulation(scene_of(arguments[1], count > 2), {});
  std::uint64_t contacts = 0, solves = 0;
  for (int i = 0; i < 25; ++i) {
    for (const SubstepRecord& record : simulation.step()) {
      contacts += record.response.contacts;
      solves += static_cast<std::uint64_t>(record.response.solves);
    }
  }
  std::printf("%llu contacts, %llu solves\n", static_cast<unsigned long long>(contacts),
              static_cast<unsigned long long>(solves));
  return 0;
}
