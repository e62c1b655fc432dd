// SPDX-License-Identifier: MIT
#include "sim/checkpoint.hpp"

#include <touchstone/error.hpp>

#include "io/times.hpp"
#include "scene/json_node.hpp"
#include "scene/scene_file.hpp"
#include "sim/state_check.hpp"

namespace touchstone::sim {
namespace {

double from_hexfloat(const JsonNode& node) {
  const auto value = io::parse_finite_double(node.text());
  if (!value) node.fail("is no finite hexfloat, such as \"0x1.8p-2\"");
  return *value;
}

nlohmann::json hexfloats(const double* values, std::size_t count) {
  nlohmann::json list = nlohmann::json::array();
  for (std::size_t i = 0; i < count; ++i) list.push_back(io::hexfloat(values[i]));
  return list;
}

VectorX vector_from(const JsonNode& node) {
  const auto items = node.items();
  VectorX values(static_cast<Eigen::Index>(items.size()));
  for (std::size_t i = 0; i < items.size(); ++i) values[static_cast<Eigen::Index>(i)] = from_hexfloat(items[i]);
  return values;
}

}  // namespace

std::string checkpoint_to_json(const Simulation& simulation) {
  const State& state = simulation.state();
  nlohmann::json json;
  json["touchstone_checkpoint"] = 1;
  json["steps"] = simulation.steps();
  json["time"] = io::hexfloat(state.time);
  json["q"] = hexfloats(state.q.data(), static_cast<std::size_t>(state.q.size()));
  json["v"] = hexfloats(state.v.data(), static_cast<std::size_t>(state.v.size()));
  json["directors"] = nlohmann::json::array();
  for (const Vector3& d : state.frames.director) {
    for (const double x : {d.x(), d.y(), d.z()}) json["directors"].push_back(io::hexfloat(x));
  }
  json["reference_twists"] = hexfloats(state.frames.reference_twist.data(), state.frames.reference_twist.size());
  json["scene"] = scene_to_json(simulation.scene());
  return json.dump(1) + "\n";
}

Checkpoint checkpoint_from_json(std::string_view text) {
  const nlohmann::json json = parse_json(text);
  const JsonNode root(json, "the checkpoint");
  root.check_keys({"touchstone_checkpoint", "steps", "time", "q", "v", "directors", "reference_twists", "scene"});
  root.at("touchstone_checkpoint").version(1);
  Checkpoint checkpoint;
  const std::string scene = root.at("scene").text();
  try {
    checkpoint.scene = scene_from_json(scene);
  } catch (const Error& error) {
    root.at("scene").fail(error.what());
  }
  checkpoint.steps = root.at("steps").whole_number(0, kMostSteps);
  checkpoint.state.time = from_hexfloat(root.at("time"));
  checkpoint.state.q = vector_from(root.at("q"));
  checkpoint.state.v = vector_from(root.at("v"));
  const VectorX directors = vector_from(root.at("directors"));
  if (directors.size() % 3 != 0) root.at("directors").fail("must be three numbers a segment");
  for (Eigen::Index i = 0; i < directors.size(); i += 3)
    checkpoint.state.frames.director.push_back(directors.segment<3>(i));
  const VectorX twists = vector_from(root.at("reference_twists"));
  checkpoint.state.frames.reference_twist.assign(twists.data(), twists.data() + twists.size());
  return checkpoint;
}

}  // namespace touchstone::sim
