// SPDX-License-Identifier: MIT
#include "scene/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <touchstone/error.hpp>

#include "scene/surface_check.hpp"

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

std::optional<Integrator> find_integrator(std::string_view name) noexcept {
  for (const auto integrator :
       {Integrator::implicit_euler, Integrator::tr_bdf2, Integrator::implicit_midpoint, Integrator::symplectic_euler}) {
    if (name == integrator_name(integrator)) return integrator;
  }
  return std::nullopt;
}

namespace {

/// The path of a thing in a scene file, for the messages about it.
class ScenePath {
 public:
  explicit ScenePath(std::string path) : path_(std::move(path)) {}

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

  /// A radius in contacts.
  void radius(double value) const {
    if (const std::string reason = wrong_radius(value); !reason.empty()) fail("radius", reason);
  }

  static constexpr double kMostLength = 1e9;

 private:
  std::string path_;
};

// In SI units: mass, stiffness and damping, of which sums and products with coordinates stay far from overflow.
constexpr double kMost = 1e15;

constexpr double kLeastDistance = 1e-12;  // m

void check_settings(const Settings& s) {
  const ScenePath path("settings");
  path.in_range("time_step", s.time_step, 1e-9, 1e3);
  path.in_range("duration", s.duration, 0, 1e9);
  path.finite("gravity", s.gravity);
  path.in_range("drag", s.drag, 0, 1e6);
  path.in_range("newton_tolerance", s.newton_tolerance, 1e-14, 1);
  path.in_range("tolerance", s.tolerance, 0, 1e9);
  path.in_range("least_step", s.least_step, 0, s.time_step);
  if (s.least_step > 0 && s.tolerance == 0) path.fail("least_step", "goes with a tolerance");
  const ScenePath contact("settings.contact");
  contact.in_range("restitution", s.contact.restitution, 0, 1);
  contact.in_range("friction", s.contact.friction, 0, 100);
  contact.in_range("thickness", s.contact.thickness, 0, 1);
  contact.in_range("passes", s.contact.passes, 1, 1000);
}

void check_particle(const ScenePath& path, const Particle& p) {
  path.finite("position", p.position);
  path.finite("velocity", p.velocity);
  path.finite("force", p.force);
  path.in_range("mass", p.mass, 0, kMost);
  path.radius(p.radius);
  if (p.radius > 0 && !p.collides) path.fail("radius", "goes with a particle that collides");
  for (std::size_t i = 0; i < p.path.size(); ++i) {
    path.finite(fmt::format("path[{}].position", i), p.path[i].position);
    path.in_range(fmt::format("path[{}].time", i), p.path[i].time, i == 0 ? 0 : p.path[i - 1].time, kMost);
    if (i > 0 && p.path[i].time == p.path[i - 1].time) {
      path.fail(fmt::format("path[{}].time", i), "must be later than the waypoint before it");
    }
  }
}

void check_cable(const ScenePath& path, const Cable& cable) {
  const std::size_t least = cable.closed ? 3 : 2;
  if (cable.particles.size() < least) path.fail("particles", fmt::format("must be at least {}", least));
  path.in_range("radius", cable.radius, kLeastRadius, kMostRadius);
  path.in_range("density", cable.density, 0, 1e6);
  path.positive("stretch", cable.stretch, kMost);
  path.in_range("bend", cable.bend, 0, kMost);
  path.in_range("twist", cable.twist, 0, kMost);
  if (cable.twist > 0 && cable.bend == 0) path.fail("twist", "a cable that resists twist must resist bending");
  if (cable.twist > 0 && cable.density == 0) path.fail("density", "a cable that twists must have mass");
  path.in_range("damping", cable.damping, 0, 1e6);
  path.in_range("length_scale", cable.length_scale, 1e-3, 1e3);
  for (const double k : cable.natural_curvature) path.in_range("natural_curvature", k, -1e6, 1e6);
  const bool curved = cable.rest_is_bent || cable.natural_curvature[0] != 0 || cable.natural_curvature[1] != 0;
  if (curved && cable.twist == 0) {
    path.fail("twist", "a cable that is bent at rest must resist twist, or its bends have no direction");
  }
  for (const CableEnd* end : {&cable.start, &cable.end}) {
    path.in_range(end == &cable.start ? "start.twist_rate" : "end.twist_rate", end->twist_rate, -1e6, 1e6);
    path.in_range(end == &cable.start ? "start.twist_until" : "end.twist_until", end->twist_until, 0, 1e9);
    if (cable.closed && end->clamped) path.fail("closed", "a ring has no ends to clamp");
    if (end->clamped && cable.bend == 0) path.fail("bend", "a cable that does not resist bending cannot be clamped");
  }
  path.in_range("closing_twist_rate", cable.closing_twist_rate, -1e6, 1e6);
  path.in_range("closing_twist_until", cable.closing_twist_until, 0, 1e9);
}

Vector3 start_of(const Scene& scene, Index particle) {
  const Particle& p = scene.particles[particle];
  return p.path.empty() ? p.position : p.path.front().position;
}

template <class Indices>
void check_indices(const Scene& scene, const ScenePath& path, std::string_view key, const Indices& indices) {
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] >= scene.particles.size()) {
      path.fail(key, fmt::format("there is no particle {}: there are {}", indices[i], scene.particles.size()));
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (indices[i] == indices[j]) path.fail(key, fmt::format("particle {} is there twice", indices[i]));
    }
  }
}

template <class Indices>
void check_collide(const Scene& scene, const ScenePath& path, const Indices& indices) {
  for (const Index p : indices) {
    if (scene.particles[p].collides) continue;
    path.fail("particles", fmt::format("particle {} does not collide, and this does", p));
  }
}

/// Where a cable folds back on itself, its curvature is infinite.
void check_fold(const Scene& scene, const ScenePath& path, Index a, Index b, Index c) {
  const Vector3 in = (start_of(scene, b) - start_of(scene, a)).normalized();
  const Vector3 out = (start_of(scene, c) - start_of(scene, b)).normalized();
  if (a != c && (in + out).norm() > 1e-7) return;
  path.fail("particles", fmt::format("at particle {} the cable folds back on itself", b));
}

void check_distance(const Scene& scene, const ScenePath& path, Index a, Index b) {
  if (!((start_of(scene, a) - start_of(scene, b)).norm() > kLeastDistance))
    path.fail("", fmt::format("particles {} and {} are in one place", a, b));
}

/// The radius of a particle in an edge or face is that of its elements.
void check_lone_radii(const Scene& scene) {
  if (std::none_of(scene.particles.begin(), scene.particles.end(), [](const Particle& p) { return p.radius > 0; })) {
    return;
  }
  const auto check = [&](Index p, std::string_view element, std::size_t number) {
    if (scene.particles[p].radius == 0) return;
    ScenePath(fmt::format("particles[{}]", p))
        .fail("radius", fmt::format("it is a corner of {}[{}], whose radius counts", element, number));
  };
  for (std::size_t i = 0; i < scene.springs.size(); ++i) {
    if (!scene.springs[i].collides) continue;
    for (const Index p : {scene.springs[i].a, scene.springs[i].b}) check(p, "springs", i);
  }
  for (std::size_t i = 0; i < scene.cables.size(); ++i) {
    for (const Index p : scene.cables[i].particles) check(p, "cables", i);
  }
  for (std::size_t i = 0; i < scene.wires.size(); ++i) {
    for (const Index p : scene.wires[i].particles) check(p, "wires", i);
  }
  for (std::size_t i = 0; i < scene.faces.size(); ++i) {
    for (const Index p : scene.faces[i].particles) check(p, "faces", i);
  }
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
    for (const Face& face : scene.surfaces[i].faces) {
      for (const Index p : face) check(p, "surfaces", i);
    }
  }
}

}  // namespace

std::string wrong_radius(double radius) {
  if (radius == 0 || (radius >= kLeastRadius && radius <= kMostRadius)) return "";
  return fmt::format("{} is neither 0 nor in [{}, {}]", radius, kLeastRadius, kMostRadius);
}

bool has_radii(const Scene& scene) {
  const auto any = [](const auto& elements) {
    return std::any_of(elements.begin(), elements.end(), [](const auto& element) { return element.radius > 0; });
  };
  return any(scene.particles) || any(scene.springs) || any(scene.wires) || any(scene.faces) || any(scene.surfaces) ||
         std::any_of(scene.cables.begin(), scene.cables.end(), [](const Cable& cable) { return cable.solid; });
}

void check_scene(const Scene& scene) {
  check_settings(scene.settings);
  if (scene.particles.empty() && scene.bodies.empty()) ScenePath("particles").fail("", "a scene must have some");
  if (scene.particles.size() > kMostParticles) ScenePath("particles").fail("", "are more than 10,000,000");
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    check_particle(ScenePath(fmt::format("particles[{}]", i)), scene.particles[i]);
  }
  check_bodies(scene);
  std::vector<char> has_mass(scene.particles.size(), 0);
  for (std::size_t i = 0; i < scene.springs.size(); ++i) {
    const Spring& s = scene.springs[i];
    const ScenePath path(fmt::format("springs[{}]", i));
    check_indices(scene, path, "particles", Edge{s.a, s.b});
    path.in_range("stiffness", s.stiffness, 0, kMost);
    path.in_range("damping", s.damping, 0, kMost);
    path.in_range("rest_length", s.rest_length, 0, ScenePath::kMostLength);
    check_distance(scene, path, s.a, s.b);
    path.radius(s.radius);
    if (s.radius > 0 && !s.collides) path.fail("radius", "goes with a spring that collides");
    if (s.collides) check_collide(scene, path, Edge{s.a, s.b});
  }
  for (std::size_t i = 0; i < scene.cables.size(); ++i) {
    const Cable& cable = scene.cables[i];
    const ScenePath path(fmt::format("cables[{}]", i));
    check_cable(path, cable);
    for (const Index p : cable.particles) check_indices(scene, path, "particles", std::array<Index, 1>{p});
    for (std::size_t j = 0; j < cable.edge_count(); ++j) {
      const Index a = cable.particles[j], b = cable.particles[(j + 1) % cable.particles.size()];
      check_indices(scene, path, "particles", Edge{a, b});
      check_distance(scene, path, a, b);
      if (cable.density > 0) has_mass[a] = has_mass[b] = 1;
    }
    check_collide(scene, path, cable.particles);
    const std::size_t count = cable.particles.size(), bends = cable.closed ? count : count - 2;
    for (std::size_t j = 0; j < bends; ++j) {
      check_fold(scene, path, cable.particles[j], cable.particles[(j + 1) % count], cable.particles[(j + 2) % count]);
    }
  }
  for (std::size_t i = 0; i < scene.wires.size(); ++i) {
    const ScenePath path(fmt::format("wires[{}]", i));
    const Edge& wire = scene.wires[i].particles;
    check_indices(scene, path, "particles", wire);
    check_distance(scene, path, wire[0], wire[1]);
    path.radius(scene.wires[i].radius);
    check_collide(scene, path, wire);
  }
  for (std::size_t i = 0; i < scene.faces.size(); ++i) {
    const ScenePath path(fmt::format("faces[{}]", i));
    check_indices(scene, path, "particles", scene.faces[i].particles);
    path.radius(scene.faces[i].radius);
    check_collide(scene, path, scene.faces[i].particles);
  }
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
    const Surface& surface = scene.surfaces[i];
    check_surface(scene, i);
    for (const Face& face : surface.faces) {
      for (const Index p : face) has_mass[p] |= surface.areal_density > 0;
    }
  }
  check_lone_radii(scene);
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    const Particle& p = scene.particles[i];
    if (!p.pinned() && p.mass == 0 && !has_mass[i]) {
      ScenePath(fmt::format("particles[{}]", i)).fail("mass", "0 is not allowed for a particle that can move");
    }
  }
}

}  // namespace touchstone::sim
