// SPDX-License-Identifier: MIT
#include "fuzz/bodies/pipe_bodies.hpp"

#include "fuzz/processes/line_process.hpp"
#include "fuzz/scenes/scene_json.hpp"

namespace touchstone::fuzz {
namespace {

void append_body(std::string& line, const Body& body) {
  const Mesh& mesh = body.mesh();
  append_member(line, "{", "points", body.points());
  append_member(line, ",", "faces", mesh.faces());
  append_member(line, ",", "edges", mesh.edges());
  append_member(line, ",", "loose_points", mesh.points());
  if (const auto radii = mesh.elements().radii; !radii.empty()) append_member(line, ",", "radii", radii);
  line.append("}");
}

void append_motion(std::string& line, const RigidMotion& motion) {
  append_member(line, "{", "q0", motion.q0);
  append_member(line, ",", "p0", motion.p0);
  append_member(line, ",", "q1", motion.q1);
  append_member(line, ",", "p1", motion.p1);
  line.append("}");
}

std::optional<BodyElement> read_body_element(const nlohmann::json& value) {
  if (!value.is_array() || value.size() != 2) return std::nullopt;
  const auto body = read_index(value[0]), element = read_index(value[1]);
  return body && element ? std::optional(BodyElement{*body, *element}) : std::nullopt;
}

}  // namespace

std::string bodies_line(const Bodies& bodies, const std::vector<RigidMotion>& motions) {
  std::string line;
  for (const Body& body : bodies.bodies) append_body(line.append(line.empty() ? "{\"bodies\":[" : ","), body);
  for (std::size_t b = 0; b < motions.size(); ++b) {
    append_motion(line.append(b == 0 ? "],\"motions\":[" : ","), motions[b]);
  }
  append_member(line, "],", "body_pairs", bodies.rules.body_pairs);
  append_separation(line, bodies.separation);
  return line + "}\n";
}

BodyStepReply read_body_reply(std::string_view line) {
  return read_reply<BodyStepReply>(line, R"(["edge-edge", [0, 3], [1, 5]])", read_body_element);
}

BodyStepSolver run_body_command(const std::string& command_line, const Limits& limits) {
  return ask_program(command_start(command_line, limits), limits, bodies_line, read_body_reply);
}

}  // namespace touchstone::fuzz
