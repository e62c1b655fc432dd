// SPDX-License-Identifier: MIT
#include "scene/body_file.hpp"

#include <string_view>

#include <touchstone/error.hpp>

namespace touchstone::sim {
namespace {

using json::JsonNode;
using Json = nlohmann::ordered_json;

template <std::size_t N>
std::array<double, N> numbers_from(const JsonNode& node, const char* what) {
  const auto all = node.items();
  if (all.size() != N) node.fail("must be a list of " + std::to_string(N) + " numbers: " + what);
  std::array<double, N> numbers{};
  for (std::size_t i = 0; i < N; ++i) numbers[i] = all[i].number();
  return numbers;
}

template <std::size_t N>
void add_elements(const JsonNode& list, std::vector<std::array<std::uint32_t, N>>& elements) {
  for (const JsonNode& node : list.items()) {
    const auto all = node.items();
    if (all.size() != N) node.fail("must be a list of " + std::to_string(N) + " vertex numbers");
    auto& element = elements.emplace_back();
    for (std::size_t i = 0; i < N; ++i) element[i] = all[i].index();
  }
}

Quaternion orientation_or(const JsonNode& node, const Quaternion& otherwise) {
  return node.has("orientation") ? numbers_from<4>(node.at("orientation"), "w, x, y, z") : otherwise;
}

BodyMotion motion_from(const JsonNode& node) {
  const std::string name = node.text();
  for (const auto motion : {BodyMotion::free, BodyMotion::fixed, BodyMotion::driven}) {
    if (name == body_motion_name(motion)) return motion;
  }
  node.fail("must be free, fixed or driven");
}

bool is_identity(const Quaternion& q) { return q == Quaternion{1, 0, 0, 0}; }

}  // namespace

Body body_from(const JsonNode& node) {
  node.check_keys({"vertices", "edges", "faces", "density", "mass", "centre", "inertia", "position", "orientation",
                   "velocity", "angular_velocity", "motion", "path", "radius"});
  Body body;
  for (const JsonNode& vertex : node.at("vertices").items()) body.vertices.push_back(vector_from(vertex));
  if (const auto edges = node.find("edges")) add_elements(*edges, body.edges);
  if (const auto faces = node.find("faces")) add_elements(*faces, body.faces);
  if (const auto motion = node.find("motion")) body.motion = motion_from(*motion);
  if (const auto density = node.find("density")) {
    body.density = density->number();
    if (!(body.density > 0)) density->fail("must be positive");
  }
  if (const auto mass = node.find("mass")) {
    body.mass = mass->number();
    if (!(body.mass > 0)) mass->fail("must be positive");
    body.inertia = numbers_from<6>(node.at("inertia"), "xx, yy, zz, xy, xz, yz");
  } else if (node.has("inertia")) {
    node.at("inertia").fail("goes with mass");
  }
  body.centre = vector_or(node, "centre", body.centre);
  body.pose.p = vector_or(node, "position", body.pose.p);
  body.pose.q = orientation_or(node, body.pose.q);
  body.velocity = vector_or(node, "velocity", body.velocity);
  body.angular_velocity = vector_or(node, "angular_velocity", body.angular_velocity);
  if (const auto path = node.find("path")) {
    for (const JsonNode& point : path->items()) {
      point.check_keys({"time", "position", "orientation"});
      const Quaternion before = body.path.empty() ? body.pose.q : body.path.back().pose.q;
      body.path.push_back(
          {point.at("time").number(), {orientation_or(point, before), vector_from(point.at("position"))}});
    }
    if (body.path.empty()) path->fail("must have a waypoint");
  }
  body.radius = node.number_or("radius", 0);
  return body;
}

std::string body_to_json(const Body& body) {
  Json json;
  json["vertices"] = Json::array();
  for (const Vector3& vertex : body.vertices) json["vertices"].push_back(list(vertex));
  if (!body.edges.empty()) json["edges"] = body.edges;
  if (!body.faces.empty()) json["faces"] = body.faces;
  if (body.motion != BodyMotion::free) json["motion"] = body_motion_name(body.motion);
  if (body.density != 0) json["density"] = body.density;
  if (body.mass != 0) {
    json["mass"] = body.mass;
    json["inertia"] = body.inertia;
    if (!body.centre.isZero(0)) json["centre"] = list(body.centre);
  }
  json["position"] = list(body.pose.p);
  if (!is_identity(body.pose.q)) json["orientation"] = body.pose.q;
  if (!body.velocity.isZero(0)) json["velocity"] = list(body.velocity);
  if (!body.angular_velocity.isZero(0)) json["angular_velocity"] = list(body.angular_velocity);
  for (const BodyWaypoint& point : body.path) {
    json["path"].push_back({{"time", point.time}, {"position", list(point.pose.p)}, {"orientation", point.pose.q}});
  }
  if (body.radius != 0) json["radius"] = body.radius;
  return json.dump();
}

}  // namespace touchstone::sim
