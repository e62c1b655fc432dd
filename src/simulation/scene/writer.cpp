// SPDX-License-Identifier: MIT
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <utility>

#include "scene/body_file.hpp"
#include "scene/scene_file.hpp"
#include "scene/surface_file.hpp"

namespace touchstone::sim {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Settings& s) {
  Json json;
  json["time_step"] = s.time_step;
  json["duration"] = s.duration;
  json["integrator"] = integrator_name(s.integrator);
  json["gravity"] = list(s.gravity);
  json["drag"] = s.drag;
  json["newton_tolerance"] = s.newton_tolerance;
  if (s.tolerance != 0) json["tolerance"] = s.tolerance;
  if (s.least_step != 0) json["least_step"] = s.least_step;
  json["contact"] = {{"restitution", s.contact.restitution},
                     {"friction", s.contact.friction},
                     {"thickness", s.contact.thickness},
                     {"passes", s.contact.passes}};
  for (const auto& [key, used] : std::initializer_list<std::pair<const char*, bool>>{
           {"repulsion", s.contact.repulsion}, {"impulses", s.contact.impulses}, {"zones", s.contact.zones}}) {
    if (!used) json["contact"][key] = false;
  }
  return json;
}

Json json_of(const Particle& p) {
  Json json;
  json["position"] = list(p.position);
  if (!p.velocity.isZero(0)) json["velocity"] = list(p.velocity);
  if (!p.force.isZero(0)) json["force"] = list(p.force);
  if (p.mass != 0) json["mass"] = p.mass;
  if (!p.path.empty()) {
    for (const Waypoint& point : p.path)
      json["path"].push_back({{"time", point.time}, {"position", list(point.position)}});
  } else if (p.pinned()) {
    json["pinned"] = true;
  } else if (p.fixed[0] || p.fixed[1] || p.fixed[2]) {
    json["pinned"] = p.fixed;
  }
  if (!p.collides) json["collides"] = false;
  if (p.radius != 0) json["radius"] = p.radius;
  return json;
}

/// The particles of a wire or face, as an object where there is a radius.
template <class Element>
Json with_radius(const Element& element) {
  if (element.radius == 0) return element.particles;
  return {{"particles", element.particles}, {"radius", element.radius}};
}

Json json_of(const CableEnd& end) {
  Json json;
  json["hold"] = "clamped";
  if (end.twist_rate != 0) {
    json["twist_rate"] = end.twist_rate;
    json["twist_until"] = end.twist_until;
  }
  return json;
}

Json json_of(const Cable& cable) {
  Json json;
  json["particles"] = cable.particles;
  if (cable.closed) json["closed"] = true;
  json["radius"] = cable.radius;
  if (cable.solid) json["solid"] = true;
  json["density"] = cable.density;
  json["stretch"] = cable.stretch;
  json["bend"] = cable.bend;
  json["twist"] = cable.twist;
  json["damping"] = cable.damping;
  if (cable.natural_curvature != std::array<double, 2>{}) json["natural_curvature"] = cable.natural_curvature;
  if (cable.rest_is_bent) json["rest_is_bent"] = true;
  if (cable.length_scale != 1) json["length_scale"] = cable.length_scale;
  // Pinned ends are pinned particles.
  if (cable.start.clamped) json["start"] = json_of(cable.start);
  if (cable.end.clamped) json["end"] = json_of(cable.end);
  if (cable.closing_twist_rate != 0) {
    json["closing_twist_rate"] = cable.closing_twist_rate;
    json["closing_twist_until"] = cable.closing_twist_until;
  }
  return json;
}

/// One line an element, so that a person can find it.
template <class Indices, class Write>
void append(std::string& text, const char* name, const Indices& elements, Write write) {
  text += ",\n\"" + std::string(name) + "\": [";
  const char* separator = "\n";
  for (const auto& element : elements) {
    text += separator + write(element).dump();
    separator = ",\n";
  }
  text += "]";
}

}  // namespace

std::string scene_to_json(const Scene& scene) {
  std::string text = "{\"touchstone_scene\": 1,\n\"name\": " + Json(scene.name).dump() +
                     ",\n\"settings\": " + json_of(scene.settings).dump(2);
  append(text, "particles", scene.particles, [](const Particle& p) { return json_of(p); });
  append(text, "springs", scene.springs, [](const Spring& s) {
    Json json = {
        {"particles", {s.a, s.b}}, {"stiffness", s.stiffness}, {"damping", s.damping}, {"rest_length", s.rest_length}};
    if (!s.collides) json["collides"] = false;
    if (s.radius != 0) json["radius"] = s.radius;
    return json;
  });
  append(text, "cables", scene.cables, [](const Cable& cable) { return json_of(cable); });
  append(text, "wires", scene.wires, [](const Wire& wire) { return with_radius(wire); });
  append(text, "faces", scene.faces, [](const Facet& face) { return with_radius(face); });
  if (!scene.surfaces.empty()) append(text, "surfaces", scene.surfaces, [](const Surface& s) { return json_of(s); });
  if (!scene.bodies.empty()) {
    text += ",\n\"bodies\": [";
    const char* separator = "\n";
    for (const Body& body : scene.bodies) {
      text += separator + body_to_json(body);
      separator = ",\n";
    }
    text += "]";
  }
  return text + "}\n";
}

}  // namespace touchstone::sim
