// SPDX-License-Identifier: MIT
#include "scene/shipped_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <touchstone/error.hpp>

#include "scene/parts.hpp"

namespace touchstone::sim {

const std::vector<ShippedScene>& shipped_scenes() {
  static const std::vector<ShippedScene> all{
      {"two-edges", "one edge is thrown against another and bounces", "pairs of edges", 1, 1, 10'000, make_two_edges},
      {"hoop", "a basketball of springs goes through a rim with a net of strings", "about how many edges", 200, 560,
       50'000, make_hoop},
      {"hoop-rim", "a basketball meets a board and a rigid rim, with a net of strings", "about how many edges", 200,
       560, 50'000, make_hoop_rim},
      {"cable-drop", "layers of cables fall on one another and on the floor", "segments of all cables", 40, 400,
       200'000, make_cable_drop},
      {"whip", "a cable at 100 m/s meets a wire", "segments of the cable", 4, 60, 10'000, make_whip},
      {"ring-twist", "a ring is twisted until it buckles and writhes (Michell 1889)", "segments of the ring", 12, 80,
       5'000, make_ring_twist},
      {"chain", "a heavy weight on a light chain swings against a peg", "segments of the chain", 4, 40, 10'000,
       make_chain},
      {"flag", "a sheet is let down by two corners, and falls into folds", "triangles of the sheet", 8, 500, 100'000,
       make_flag},
      {"drape", "a sheet falls over a ball and onto the floor", "triangles of the sheet", 8, 500, 100'000, make_drape},
      {"twist", "a sheet is wrung by both ends, for ten turns", "triangles of the sheet", 40, 500, 100'000, make_twist},
      {"link-chain", "a chain of rigid links falls, held at one end", "links", 2, 24, 2'000, make_link_chain},
      {"stack", "boxes rest on one another and on the ground", "boxes", 1, 5, 200, make_stack},
      {"nut-and-bolt", "a nut runs down a thread by its weight", "faces around the thread", 24, 36, 96,
       make_nut_and_bolt},
  };
  return all;
}

const ShippedScene* find_shipped_scene(std::string_view name) {
  const auto& all = shipped_scenes();
  const auto found = std::find_if(all.begin(), all.end(), [&](const ShippedScene& s) { return s.name == name; });
  return found == all.end() ? nullptr : &*found;
}

Scene make_shipped_scene(std::string_view name, std::optional<Index> size) {
  const ShippedScene* const shipped = find_shipped_scene(name);
  if (shipped == nullptr) throw Error(fmt::format("{} is no shipped scene", name));
  const Index chosen = size.value_or(shipped->usual);
  if (chosen < shipped->least || chosen > shipped->most) {
    throw Error(fmt::format("--size {}: {} takes {} to {} {}", chosen, name, shipped->least, shipped->most,
                            shipped->size_means));
  }
  Scene scene = shipped->make(chosen);
  scene.name = name;
  return scene;
}

Scene make_two_edges(Index pairs) {
  Scene scene;
  scene.settings.gravity.setZero();
  scene.settings.integrator = Integrator::tr_bdf2;
  scene.settings.duration = 2;
  scene.settings.contact.restitution = 0.8;
  scene.settings.contact.thickness = 1e-3;
  for (Index i = 0; i < pairs; ++i) {
    const double y = 3.0 * i;
    const Index a = add_particle(scene, {-1, y, 0}, 1), b = add_particle(scene, {1, y + 0.1, 0}, 1);
    const Index c = add_particle(scene, {0.2, y - 1, 0.7}, 1), d = add_particle(scene, {0.1, y + 1, 0.9}, 1);
    // No stiffer than a step can follow: an impact on stiffer ones would lose more than its restitution says.
    add_spring(scene, a, b, 3e3, 1, true);
    add_spring(scene, c, d, 3e3, 1, true);
    for (const Index p : {c, d}) scene.particles[p].velocity = {0, 0, -1};
  }
  return scene;
}

Scene make_whip(Index segments) {
  Scene scene;
  scene.settings.integrator = Integrator::tr_bdf2;
  scene.settings.time_step = 5e-5;  // it flies 5 mm in it
  scene.settings.duration = 0.05;
  scene.settings.contact.restitution = 0.2;
  scene.settings.contact.friction = 0.2;
  const Index a = add_pinned(scene, {0.35, -0.5, 0.003}), b = add_pinned(scene, {0.35, 0.5, -0.002});
  scene.wires.push_back({{a, b}});
  Cable cable = straight_cable(scene, {0, 0.01, 0.5}, {1.5, -0.02, 0.52}, segments);
  set_material(cable, 1e8, 0.4, 0.004, 1200);
  cable.twist = 0;
  cable.damping = 1e-3;
  for (const Index p : cable.particles) scene.particles[p].velocity = {0, 0, -100};
  scene.cables.push_back(std::move(cable));
  return scene;
}

Scene make_ring_twist(Index segments) {
  Scene scene;
  scene.settings.integrator = Integrator::tr_bdf2;
  scene.settings.duration = 5;
  scene.settings.gravity.setZero();
  scene.settings.drag = 1;
  scene.settings.contact.restitution = 0;
  scene.settings.contact.friction = 0.3;
  Cable ring;
  for (Index i = 0; i < segments; ++i) {
    // A ripple of a thousandth of the radius: perfect symmetry would never choose a way to buckle.
    const double phi = 2 * std::numbers::pi * i / segments;
    ring.particles.push_back(
        add_particle(scene, {0.2 * std::cos(phi), 0.2 * std::sin(phi), 2e-4 * std::cos(2 * phi)}, 0));
  }
  ring.closed = true;
  set_material(ring, 2e6, 0.5, 0.003, 1100);
  ring.damping = 0.02;
  ring.closing_twist_rate = 10;  // rad/s: past 16.3 rad after 1.6 s
  ring.closing_twist_until = 3.5;
  scene.cables.push_back(std::move(ring));
  return scene;
}

Scene make_chain(Index segments) {
  Scene scene;
  scene.settings.integrator = Integrator::tr_bdf2;
  scene.settings.time_step = 1.0 / 960;
  scene.settings.duration = 5;
  scene.settings.contact.restitution = 0.2;
  scene.settings.contact.friction = 0.3;
  const Index a = add_pinned(scene, {0.1, -0.5, -0.4}), b = add_pinned(scene, {0.1, 0.5, -0.41});
  scene.wires.push_back({{a, b}});
  Cable cable = straight_cable(scene, {0, 0, 0}, {-0.8, 0.02, -0.6}, segments);
  set_material(cable, 2e9, 0.3, 0.001, 1000);
  cable.bend = cable.twist = 0;
  cable.damping = 1e-3;
  scene.particles[cable.particles.front()].fixed = {true, true, true};
  const double chain_mass = 1000 * std::numbers::pi * 1e-6;
  scene.particles[cable.particles.back()].mass = 1e4 * chain_mass / segments;  // ten thousand times a link's
  scene.cables.push_back(std::move(cable));
  return scene;
}

}  // namespace touchstone::sim
