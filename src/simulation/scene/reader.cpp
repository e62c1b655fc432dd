// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <touchstone/error.hpp>

#include "json/json_node.hpp"
#include "scene/body_file.hpp"
#include "scene/parts.hpp"
#include "scene/scene_file.hpp"
#include "scene/surface_file.hpp"

namespace touchstone::sim {
namespace {

using json::JsonNode;

constexpr Index kVersion = 1;

template <std::size_t N>
std::array<Index, N> indices_from(const JsonNode& node) {
  const auto all = node.items();
  if (all.size() != N) node.fail("must be a list of " + std::to_string(N) + " particle numbers");
  std::array<Index, N> indices{};
  for (std::size_t i = 0; i < N; ++i) indices[i] = all[i].index();
  return indices;
}

Integrator integrator_from(const JsonNode& node) {
  if (const auto integrator = find_integrator(node.text())) return *integrator;
  node.fail("must be implicit-euler, tr-bdf2, implicit-midpoint or symplectic-euler");
}

Settings settings_from(const JsonNode& node) {
  node.check_keys({"time_step", "duration", "integrator", "gravity", "drag", "newton_tolerance", "tolerance",
                   "least_step", "contact"});
  Settings s;
  s.time_step = node.number_or("time_step", s.time_step);
  s.duration = node.number_or("duration", s.duration);
  if (const auto name = node.find("integrator")) s.integrator = integrator_from(*name);
  s.gravity = vector_or(node, "gravity", s.gravity);
  s.drag = node.number_or("drag", s.drag);
  s.newton_tolerance = node.number_or("newton_tolerance", s.newton_tolerance);
  s.tolerance = node.number_or("tolerance", s.tolerance);
  s.least_step = node.number_or("least_step", s.least_step);
  if (const auto contact = node.find("contact")) {
    contact->check_keys({"restitution", "friction", "thickness", "passes", "repulsion", "impulses", "zones"});
    s.contact.restitution = contact->number_or("restitution", s.contact.restitution);
    s.contact.friction = contact->number_or("friction", s.contact.friction);
    s.contact.thickness = contact->number_or("thickness", s.contact.thickness);
    if (const auto passes = contact->find("passes")) {
      s.contact.passes = static_cast<int>(passes->whole_number(1, 1000));
    }
    s.contact.repulsion = contact->boolean_or("repulsion", true);
    s.contact.impulses = contact->boolean_or("impulses", true);
    s.contact.zones = contact->boolean_or("zones", true);
  }
  return s;
}

Particle particle_from(const JsonNode& node) {
  node.check_keys({"position", "velocity", "force", "mass", "pinned", "path", "collides", "radius"});
  Particle p;
  p.position = vector_from(node.at("position"));
  p.velocity = vector_or(node, "velocity", p.velocity);
  p.force = vector_or(node, "force", p.force);
  p.mass = node.number_or("mass", 0);
  p.collides = node.boolean_or("collides", true);
  p.radius = node.number_or("radius", 0);
  if (const auto pinned = node.find("pinned")) {
    if (node.has("path")) pinned->fail("a particle is pinned or has a path, not both");
    bool axes = false;
    try {
      p.fixed.fill(pinned->boolean());
    } catch (const Error&) {
      axes = true;
    }
    if (axes) {
      const auto all = pinned->items();
      if (all.size() != 3) pinned->fail("must be true, false or a list of three of these, one a coordinate");
      for (std::size_t k = 0; k < 3; ++k) p.fixed[k] = all[k].boolean();
    }
  }
  if (const auto path = node.find("path")) {
    for (const JsonNode& point : path->items()) {
      point.check_keys({"time", "position"});
      p.path.push_back({point.at("time").number(), vector_from(point.at("position"))});
    }
    if (p.path.empty()) path->fail("must have a waypoint");
  }
  return p;
}

const Particle& particle_at(const Scene& scene, const JsonNode& node, Index index) {
  if (index >= scene.particles.size()) {
    node.fail("there is no particle " + std::to_string(index) + ": there are " +
              std::to_string(scene.particles.size()));
  }
  return scene.particles[index];
}

double distance(const Scene& scene, const JsonNode& node, Index a, Index b) {
  return (particle_at(scene, node, a).position - particle_at(scene, node, b).position).norm();
}

Spring spring_from(const Scene& scene, const JsonNode& node) {
  node.check_keys({"particles", "stiffness", "damping", "rest_length", "collides", "radius"});
  const auto ends = indices_from<2>(node.at("particles"));
  Spring s;
  s.a = ends[0];
  s.b = ends[1];
  s.stiffness = node.at("stiffness").number();
  s.damping = node.number_or("damping", 0);
  s.rest_length = node.has("rest_length") ? node.at("rest_length").number() : distance(scene, node, s.a, s.b);
  s.collides = node.boolean_or("collides", true);
  s.radius = node.number_or("radius", 0);
  return s;
}

/// A wire or face: its particles alone, or an object of them and a radius.
template <class Element>
Element with_radius(const JsonNode& node) {
  constexpr std::size_t kCorners = std::tuple_size_v<decltype(Element::particles)>;
  if (!node.is_object()) return {indices_from<kCorners>(node)};
  node.check_keys({"particles", "radius"});
  return {indices_from<kCorners>(node.at("particles")), node.number_or("radius", 0)};
}

/// Cloth, or triangles whose edges are springs at rest.
void add_surface(Scene& scene, const JsonNode& node) {
  if (is_cloth(node)) {
    scene.surfaces.push_back(cloth_from(node));
    return;
  }
  node.check_keys({"faces", "stiffness", "damping", "radius"});
  const double radius = node.number_or("radius", 0);
  if (const std::string reason = wrong_radius(radius); !reason.empty()) node.at("radius").fail(reason);
  const double stiffness = node.at("stiffness").number(), damping = node.number_or("damping", 0);
  std::vector<Edge> edges;
  for (const JsonNode& item : node.at("faces").items()) {
    const Face face = indices_from<3>(item);
    scene.faces.push_back({face, radius});
    for (std::size_t k = 0; k < 3; ++k)
      edges.push_back({std::min(face[k], face[(k + 1) % 3]), std::max(face[k], face[(k + 1) % 3])});
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (const Edge& edge : edges) {
    scene.springs.push_back({edge[0], edge[1], stiffness, damping, distance(scene, node, edge[0], edge[1]), true});
  }
}

CableEnd end_from(const JsonNode& node, Particle& particle) {
  node.check_keys({"hold", "twist_rate", "twist_until"});
  CableEnd end;
  const std::string hold = node.has("hold") ? node.at("hold").text() : "free";
  if (hold != "free" && hold != "pinned" && hold != "clamped") node.at("hold").fail("must be free, pinned or clamped");
  end.clamped = hold == "clamped";
  if (hold != "free" && particle.path.empty()) particle.fixed = {true, true, true};
  end.twist_rate = node.number_or("twist_rate", 0);
  end.twist_until = node.number_or("twist_until", end.twist_until);
  if (end.twist_rate != 0 && !end.clamped) node.at("twist_rate").fail("only a clamped end can be turned");
  return end;
}

void set_stiffness(const JsonNode& node, Cable& cable) {
  if (const auto young = node.find("young")) {
    for (const char* key : {"stretch", "bend", "twist"}) {
      if (node.has(key)) node.at(key).fail("follows from young, poisson and radius where these are given");
    }
    const double poisson = node.number_or("poisson", 0.3);
    if (!(poisson > -1 && poisson <= 0.5)) node.at("poisson").fail("must be in (-1, 0.5]");
    const double modulus = young->number();
    if (!(modulus > 0)) young->fail("must be positive");
    set_material(cable, modulus, poisson, cable.radius, cable.density);
    if (!node.boolean_or("bends", true)) cable.bend = cable.twist = 0;
    if (!node.boolean_or("twists", true)) cable.twist = 0;
    return;
  }
  for (const char* key : {"poisson", "bends", "twists"}) {
    if (node.has(key)) node.at(key).fail("goes with young");
  }
  if (!node.has("stretch")) node.fail("lacks the key 'young', or 'stretch' instead");
  cable.stretch = node.at("stretch").number();
  cable.bend = node.number_or("bend", 0);
  cable.twist = node.number_or("twist", 0);
}

void add_cable(Scene& scene, const JsonNode& node) {
  node.check_keys({"particles",
                   "from",
                   "to",
                   "segments",
                   "closed",
                   "radius",
                   "solid",
                   "density",
                   "young",
                   "poisson",
                   "bends",
                   "twists",
                   "stretch",
                   "bend",
                   "twist",
                   "damping",
                   "natural_curvature",
                   "rest_is_bent",
                   "length_scale",
                   "start",
                   "end",
                   "closing_twist_rate",
                   "closing_twist_until"});
  Cable cable;
  if (const auto particles = node.find("particles")) {
    for (const char* key : {"from", "to", "segments"}) {
      if (node.has(key)) node.at(key).fail("a cable goes through particles or from a place to another, not both");
    }
    for (const JsonNode& item : particles->items()) {
      cable.particles.push_back(item.index());
      particle_at(scene, item, cable.particles.back());
    }
    if (cable.particles.size() < 2) particles->fail("must be at least 2");
  } else {
    constexpr Index kMostSegments = 1'000'000;
    const JsonNode segments = node.at("segments");
    const auto count = static_cast<Index>(segments.whole_number(1, kMostSegments));
    if (scene.particles.size() + count >= kMostParticles) segments.fail("more than 10,000,000 particles in all");
    const Vector3 from = vector_from(node.at("from")), to = vector_from(node.at("to"));
    cable.particles = straight_cable(scene, from, to, count).particles;
  }
  cable.closed = node.boolean_or("closed", false);
  cable.radius = node.at("radius").number();
  cable.solid = node.boolean_or("solid", false);
  cable.density = node.at("density").number();
  set_stiffness(node, cable);
  cable.damping = node.number_or("damping", 0);
  if (const auto curvature = node.find("natural_curvature")) {
    const auto both = curvature->items();
    if (both.size() != 2) curvature->fail("must be a list of two numbers");
    cable.natural_curvature = {both[0].number(), both[1].number()};
  }
  cable.rest_is_bent = node.boolean_or("rest_is_bent", false);
  cable.length_scale = node.number_or("length_scale", 1);
  if (const auto start = node.find("start")) cable.start = end_from(*start, scene.particles[cable.particles.front()]);
  if (const auto end = node.find("end")) cable.end = end_from(*end, scene.particles[cable.particles.back()]);
  cable.closing_twist_rate = node.number_or("closing_twist_rate", 0);
  cable.closing_twist_until = node.number_or("closing_twist_until", cable.closing_twist_until);
  if (cable.closing_twist_rate != 0 && !cable.closed) node.at("closing_twist_rate").fail("goes with a closed cable");
  scene.cables.push_back(std::move(cable));
}

}  // namespace

Scene scene_from_json(std::string_view text) {
  const json::JsonDocument document = json::parse_json(text);
  const JsonNode root(document.value(), "the scene");
  root.check_keys({"touchstone_scene", "name", "settings", "particles", "springs", "surfaces", "cables", "wires",
                   "faces", "bodies"});
  root.at("touchstone_scene").version(kVersion);
  Scene scene;
  if (const auto name = root.find("name")) scene.name = name->text();
  if (const auto settings = root.find("settings")) scene.settings = settings_from(*settings);
  if (const auto particles = root.find("particles")) {
    for (const JsonNode& node : particles->items()) scene.particles.push_back(particle_from(node));
  }
  if (const auto springs = root.find("springs")) {
    for (const JsonNode& node : springs->items()) scene.springs.push_back(spring_from(scene, node));
  }
  if (const auto cables = root.find("cables")) {
    for (const JsonNode& node : cables->items()) add_cable(scene, node);
  }
  if (const auto wires = root.find("wires")) {
    for (const JsonNode& node : wires->items()) scene.wires.push_back(with_radius<Wire>(node));
  }
  if (const auto faces = root.find("faces")) {
    for (const JsonNode& node : faces->items()) scene.faces.push_back(with_radius<Facet>(node));
  }
  if (const auto surfaces = root.find("surfaces")) {
    for (const JsonNode& node : surfaces->items()) add_surface(scene, node);
  }
  if (const auto bodies = root.find("bodies")) {
    for (const JsonNode& node : bodies->items()) scene.bodies.push_back(body_from(node));
  }
  check_scene(scene);
  return scene;
}

}  // namespace touchstone::sim
