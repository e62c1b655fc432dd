// SPDX-License-Identifier: MIT
#include "fuzz/steps/pipe_steps.hpp"

#include <array>
#include <vector>

#include "fuzz/processes/line_process.hpp"
#include "fuzz/scenes/scene_json.hpp"

namespace touchstone::fuzz {
namespace {

std::vector<std::array<double, 3>> rows_of(const Positions& positions) {
  std::vector<std::array<double, 3>> rows;
  for (std::size_t v = 0; v < positions.count; ++v) {
    std::array<double, 3> row{};
    for (std::size_t k = 0; k < 3; ++k) {
      row[k] = positions.data[static_cast<std::ptrdiff_t>(v) * positions.vertex_stride +
                              static_cast<std::ptrdiff_t>(k) * positions.coordinate_stride];
    }
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

std::string step_line(const Mesh& mesh, const Positions& x0, const Positions& x1) {
  const MeshElements elements = mesh.elements();
  std::string line = "{\"vertices\":" + std::to_string(mesh.vertex_count());
  append_member(line, ",", "x0", rows_of(x0));
  append_member(line, ",", "x1", rows_of(x1));
  append_member(line, ",", "edges", mesh.edges());
  append_member(line, ",", "faces", mesh.faces());
  append_member(line, ",", "points", mesh.points());
  append_separation(line, elements.separation);
  if (!elements.rules.groups.empty()) {
    append_member(line, ",", "groups", elements.rules.groups);
    append_member(line, ",", "ignored_groups", elements.rules.group_pairs);
  }
  return line + "}\n";
}

StepReply read_step_reply(std::string_view line) {
  return read_reply<StepReply>(line, R"(["edge-edge", 0, 3])", read_index);
}

StepSolver run_step_command(const std::string& command_line, const Limits& limits) {
  return ask_program(command_start(command_line, limits), limits, step_line, read_step_reply);
}

}  // namespace touchstone::fuzz
