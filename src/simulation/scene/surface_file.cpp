// SPDX-License-Identifier: MIT
#include "scene/surface_file.hpp"

#include <touchstone/error.hpp>

#include "scene/parts.hpp"

namespace touchstone::sim {
namespace {

using json::JsonNode;

// What `strain_limit: true` asks for (Bridson et al. 2002).
constexpr double kUsualStrainLimit = 0.1;

double positive(const JsonNode& node) {
  const double value = node.number();
  if (!(value > 0)) node.fail("must be positive");
  return value;
}

/// Stretch, bend and mass: of a material and a thickness, or given.
void set_sheet(const JsonNode& node, Surface& surface) {
  surface.poisson = node.number_or("poisson", surface.poisson);
  if (const auto young = node.find("young")) {
    for (const char* key : {"stretch", "areal_density"}) {
      if (node.has(key)) node.at(key).fail("follows from young, density and sheet_thickness where these are given");
    }
    if (!(surface.poisson > -1 && surface.poisson <= 0.5)) node.at("poisson").fail("must be in (-1, 0.5]");
    set_material(surface, positive(*young), surface.poisson, positive(node.at("sheet_thickness")),
                 node.at("density").number());
    if (const auto bend = node.find("bend")) surface.bend = bend->number();
    return;
  }
  for (const char* key : {"sheet_thickness", "density"}) {
    if (node.has(key)) node.at(key).fail("goes with young");
  }
  if (!node.has("stretch")) node.fail("lacks the key 'young', or 'stretch' instead");
  surface.stretch = node.at("stretch").number();
  surface.bend = node.number_or("bend", 0);
  surface.areal_density = node.number_or("areal_density", 0);
}

double strain_limit_from(const JsonNode& node) {
  try {
    return node.boolean() ? kUsualStrainLimit : 0;
  } catch (const Error&) {
    const double limit = node.number();
    if (!(limit > 0)) node.fail("must be true, false or a positive number");
    return limit;
  }
}

}  // namespace

bool is_cloth(const JsonNode& node) {
  if (!node.is_object()) return false;
  for (const char* key : {"young", "stretch", "poisson", "sheet_thickness", "density", "bend", "areal_density",
                          "strain_limit", "rest_is_bent"}) {
    if (node.has(key)) return true;
  }
  return false;
}

Surface cloth_from(const JsonNode& node) {
  if (node.has("stiffness")) node.at("stiffness").fail("goes with a surface of springs, and the other keys with cloth");
  node.check_keys({"faces", "young", "poisson", "sheet_thickness", "density", "stretch", "bend", "areal_density",
                   "damping", "strain_limit", "rest_is_bent", "radius"});
  Surface surface;
  for (const JsonNode& item : node.at("faces").items()) {
    const auto corners = item.items();
    if (corners.size() != 3) item.fail("must be a list of 3 particle numbers");
    surface.faces.push_back({corners[0].index(), corners[1].index(), corners[2].index()});
  }
  set_sheet(node, surface);
  surface.damping = node.number_or("damping", 0);
  if (const auto limit = node.find("strain_limit")) surface.strain_limit = strain_limit_from(*limit);
  surface.rest_is_bent = node.boolean_or("rest_is_bent", false);
  surface.radius = node.number_or("radius", 0);
  return surface;
}

nlohmann::ordered_json json_of(const Surface& surface) {
  nlohmann::ordered_json json;
  json["stretch"] = surface.stretch;
  json["poisson"] = surface.poisson;
  json["bend"] = surface.bend;
  json["areal_density"] = surface.areal_density;
  if (surface.damping != 0) json["damping"] = surface.damping;
  if (surface.strain_limit != 0) json["strain_limit"] = surface.strain_limit;
  if (surface.rest_is_bent) json["rest_is_bent"] = true;
  if (surface.radius != 0) json["radius"] = surface.radius;
  json["faces"] = surface.faces;
  return json;
}

}  // namespace touchstone::sim
