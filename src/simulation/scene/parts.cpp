// SPDX-License-Identifier: MIT
#include "scene/parts.hpp"

#include <numbers>

namespace touchstone::sim {

Index add_particle(Scene& scene, const Vector3& position, double mass) {
  Particle p;
  p.position = position;
  p.mass = mass;
  scene.particles.push_back(p);
  return static_cast<Index>(scene.particles.size() - 1);
}

Index add_pinned(Scene& scene, const Vector3& position) {
  const Index p = add_particle(scene, position, 0);
  scene.particles[p].fixed = {true, true, true};
  return p;
}

void set_contact(ContactSettings& contact, double restitution, double friction, double thickness) {
  contact.restitution = restitution;
  contact.friction = friction;
  contact.thickness = thickness;
}

void add_spring(Scene& scene, Index a, Index b, double stiffness, double damping, bool collides) {
  const double rest = (scene.particles[b].position - scene.particles[a].position).norm();
  scene.springs.push_back({a, b, stiffness, damping, rest, collides});
}

void set_material(Cable& cable, double young, double poisson, double radius, double density) {
  const double area = std::numbers::pi * radius * radius;
  const double moment = area * radius * radius / 4;
  cable.radius = radius;
  cable.density = density;
  cable.stretch = young * area;
  cable.bend = young * moment;
  cable.twist = young / (2 * (1 + poisson)) * 2 * moment;
}

void set_material(Surface& surface, double young, double poisson, double thickness, double density) {
  surface.stretch = young * thickness;
  surface.poisson = poisson;
  surface.bend = young * thickness * thickness * thickness / (12 * (1 - poisson * poisson));
  surface.areal_density = density * thickness;
}

Cable straight_cable(Scene& scene, const Vector3& from, const Vector3& to, Index segments) {
  Cable cable;
  for (Index i = 0; i <= segments; ++i) {
    cable.particles.push_back(add_particle(scene, from + (to - from) * (static_cast<double>(i) / segments), 0));
  }
  return cable;
}

void add_floor(Scene& scene, double half_width) {
  const double w = half_width;
  const Index a = add_pinned(scene, {-w, -w, 0}), b = add_pinned(scene, {w, -w, 0});
  const Index c = add_pinned(scene, {w, w, 0}), d = add_pinned(scene, {-w, w, 0});
  scene.faces.push_back({{a, b, c}});
  scene.faces.push_back({{a, c, d}});
}

}  // namespace touchstone::sim
