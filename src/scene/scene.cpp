// SPDX-License-Identifier: MIT
#include "scene/scene.hpp"

#include <fmt/format.h>

#include <cmath>

#include <touchstone/error.hpp>

namespace touchstone::sim {

std::string_view integrator_name(Integrator integrator) noexcept {
  switch (integrator) {
    case Integrator::implicit_euler: return "implicit-euler";
    case Integrator::tr_bdf2: return "tr-bdf2";
    case Integrator::implicit_midpoint: return "implicit-midpoint";
    case Integrator::symplectic_euler: return "symplectic-euler";
  }
  return "";
}

namespace {

/// Says what is wrong with one thing, by the path that it has in a scene file.
class Place {
 public:
  explicit Place(std::string path) : path_(std::move(path)) {}

  [[noreturn]] void fail(std::string_view key, std::string_view reason) const {
    throw Error(fmt::format("{}{}{}: {}", path_, path_.empty() || key.empty() ? "" : ".", key, reason));
  }
  void in_range(std::string_view key, double value, double low, double high) const {
    if (!(value >= low && value <= high)) fail(key, fmt::format("{} is not in [{}, {}]", value, low, high));
  }
  void positive(std::string_view key, double value, double high) const {
    if (!(value > 0 && value <= high)) fail(key, fmt::format("{} is not in (0, {}]", value, high));
  }
  void finite(std::string_view key, const Vector3& value) const {
    if (!value.allFinite() || value.lpNorm<Eigen::Infinity>() > kMostLength) {
      fail(key, "must be three finite numbers of at most 1e9");
    }
  }

  static constexpr double kMostLength = 1e9;

 private:
  std::string path_;
};

constexpr double kMost = 1e15;

void check_settings(const Settings& s) {
  const Place place("settings");
  place.in_range("time_step", s.time_step, 1e-9, 1e3);
  place.in_range("duration", s.duration, 0, 1e9);
  place.finite("gravity", s.gravity);
  place.in_range("drag", s.drag, 0, 1e6);
  place.in_range("newton_tolerance", s.newton_tolerance, 1e-14, 1);
  const Place contact("settings.contact");
  contact.in_range("restitution", s.contact.restitution, 0, 1);
  contact.in_range("friction", s.contact.friction, 0, 100);
  contact.in_range("thickness", s.contact.thickness, 0, 1);
  contact.in_range("passes", s.contact.passes, 1, 1000);
}

void check_particle(const Place& place, const Particle& p) {
  place.finite("position", p.position);
  place.finite("velocity", p.velocity);
  place.finite("force", p.force);
  place.in_range("mass", p.mass, 0, kMost);
  for (std::size_t i = 0; i < p.path.size(); ++i) {
    place.finite(fmt::format("path[{}].position", i), p.path[i].position);
    place.in_range(fmt::format("path[{}].time", i), p.path[i].time, i == 0 ? 0 : p.path[i - 1].time, kMost);
    if (i > 0 && p.path[i].time == p.path[i - 1].time) {
      place.fail(fmt::format("path[{}].time", i), "must be later than the waypoint before it");
    }
  }
}

void check_cable(const Place& place, const Cable& cable) {
  const std::size_t least = cable.closed ? 3 : 2;
  if (cable.particles.size() < least) place.fail("particles", fmt::format("must be at least {}", least));
  place.positive("radius", cable.radius, 1e3);
  place.in_range("density", cable.density, 0, 1e6);
  place.positive("stretch", cable.stretch, kMost);
  place.in_range("bend", cable.bend, 0, kMost);
  place.in_range("twist", cable.twist, 0, kMost);
  if (cable.twist > 0 && cable.bend == 0) place.fail("twist", "a cable that resists twist must resist bending");
  if (cable.twist > 0 && cable.density == 0) place.fail("density", "a cable that twists must have mass");
  place.in_range("damping", cable.damping, 0, 1e6);
  place.in_range("length_scale", cable.length_scale, 1e-3, 1e3);
  for (const double k : cable.natural_curvature) place.in_range("natural_curvature", k, -1e6, 1e6);
  const bool curved = cable.rest_is_bent || cable.natural_curvature[0] != 0 || cable.natural_curvature[1] != 0;
  if (curved && cable.twist == 0) {
    place.fail("twist", "a cable that is bent at rest must resist twist, or its bends have no direction");
  }
  for (const CableEnd* end : {&cable.start, &cable.end}) {
    place.in_range(end == &cable.start ? "start.twist_rate" : "end.twist_rate", end->twist_rate, -1e6, 1e6);
    place.in_range(end == &cable.start ? "start.twist_until" : "end.twist_until", end->twist_until, 0, 1e9);
    if (cable.closed && end->clamped) place.fail("closed", "a ring has no ends to clamp");
    if (end->clamped && cable.bend == 0) place.fail("bend", "a cable that does not resist bending cannot be clamped");
  }
  place.in_range("closing_twist_rate", cable.closing_twist_rate, -1e6, 1e6);
  place.in_range("closing_twist_until", cable.closing_twist_until, 0, 1e9);
}

Vector3 start_of(const Scene& scene, Index particle) {
  const Particle& p = scene.particles[particle];
  return p.path.empty() ? p.position : p.path.front().position;
}

template <class Elements>
void check_indices(const Scene& scene, const Place& place, std::string_view key, const Elements& indices) {
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] >= scene.particles.size()) {
      place.fail(key, fmt::format("there is no particle {}: there are {}", indices[i], scene.particles.size()));
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (indices[i] == indices[j]) place.fail(key, fmt::format("particle {} is there twice", indices[i]));
    }
  }
}

template <class Elements>
void check_collide(const Scene& scene, const Place& place, const Elements& indices) {
  for (const Index p : indices) {
    if (scene.particles[p].collides) continue;
    place.fail("particles", fmt::format("particle {} does not collide, and this does", p));
  }
}

/// Where a cable doubles back its curvature is infinite.
void check_fold(const Scene& scene, const Place& place, Index a, Index b, Index c) {
  const Vector3 in = (start_of(scene, b) - start_of(scene, a)).normalized();
  const Vector3 out = (start_of(scene, c) - start_of(scene, b)).normalized();
  if (a != c && (in + out).norm() > 1e-7) return;
  place.fail("particles", fmt::format("at particle {} the cable folds back on itself", b));
}

void check_distance(const Scene& scene, const Place& place, Index a, Index b) {
  if (!((start_of(scene, a) - start_of(scene, b)).norm() > 1e-12))
    place.fail("", fmt::format("particles {} and {} are in one place", a, b));
}

}  // namespace

void check_scene(const Scene& scene) {
  check_settings(scene.settings);
  if (scene.particles.empty()) Place("particles").fail("", "a scene must have some");
  if (scene.particles.size() > kMostParticles) Place("particles").fail("", "are more than 10,000,000");
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    check_particle(Place(fmt::format("particles[{}]", i)), scene.particles[i]);
  }
  std::vector<char> has_mass(scene.particles.size(), 0);
  for (std::size_t i = 0; i < scene.springs.size(); ++i) {
    const Spring& s = scene.springs[i];
    const Place place(fmt::format("springs[{}]", i));
    check_indices(scene, place, "particles", Edge{s.a, s.b});
    place.in_range("stiffness", s.stiffness, 0, kMost);
    place.in_range("damping", s.damping, 0, kMost);
    place.in_range("rest_length", s.rest_length, 0, Place::kMostLength);
    check_distance(scene, place, s.a, s.b);
    if (s.collides) check_collide(scene, place, Edge{s.a, s.b});
  }
  for (std::size_t i = 0; i < scene.cables.size(); ++i) {
    const Cable& cable = scene.cables[i];
    const Place place(fmt::format("cables[{}]", i));
    check_cable(place, cable);
    for (const Index p : cable.particles) check_indices(scene, place, "particles", std::array<Index, 1>{p});
    for (std::size_t j = 0; j < cable.edge_count(); ++j) {
      const Index a = cable.particles[j], b = cable.particles[(j + 1) % cable.particles.size()];
      check_indices(scene, place, "particles", Edge{a, b});
      check_distance(scene, place, a, b);
      if (cable.density > 0) has_mass[a] = has_mass[b] = 1;
    }
    check_collide(scene, place, cable.particles);
    const std::size_t count = cable.particles.size(), bends = cable.closed ? count : count - 2;
    for (std::size_t j = 0; j < bends; ++j) {
      check_fold(scene, place, cable.particles[j], cable.particles[(j + 1) % count], cable.particles[(j + 2) % count]);
    }
  }
  for (std::size_t i = 0; i < scene.wires.size(); ++i) {
    const Place place(fmt::format("wires[{}]", i));
    check_indices(scene, place, "particles", scene.wires[i]);
    check_distance(scene, place, scene.wires[i][0], scene.wires[i][1]);
    check_collide(scene, place, scene.wires[i]);
  }
  for (std::size_t i = 0; i < scene.faces.size(); ++i) {
    const Place place(fmt::format("faces[{}]", i));
    check_indices(scene, place, "particles", scene.faces[i]);
    check_collide(scene, place, scene.faces[i]);
  }
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    const Particle& p = scene.particles[i];
    if (!p.pinned() && p.mass == 0 && !has_mass[i]) {
      Place(fmt::format("particles[{}]", i)).fail("mass", "0 is not allowed for a particle that can move");
    }
  }
}

}  // namespace touchstone::sim
