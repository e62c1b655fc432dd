// SPDX-License-Identifier: MIT
#include "sim/checkpoint.hpp"

#include <algorithm>

#include <touchstone/error.hpp>

#include "geometry/kind_traits.hpp"
#include "io/sealed_json.hpp"
#include "io/times.hpp"
#include "json/json_node.hpp"
#include "scene/scene_file.hpp"
#include "sim/state_check.hpp"

namespace touchstone::sim {
namespace {

using json::JsonDocument;
using json::JsonNode;

constexpr std::uint32_t kVersion = 2;

/// A run must not go on from a state that is not the one that was written: a changed bit is other physics.
void check_seal(std::string_view text) {
  if (io::seal_holds(text)) return;
  // Checkpoints of version 1 have no digest. No single changed bit makes the 2 of this version a 1.
  if (text.find("\"touchstone_checkpoint\": 1,") != std::string_view::npos) {
    throw Error("the checkpoint has no digest, as an older version wrote it; start the run again from its scene");
  }
  throw Error("the checkpoint's digest does not match its content: the file is damaged or no checkpoint");
}

double from_hexfloat(const JsonNode& node) {
  const auto value = io::parse_finite_double(node.text());
  if (!value) node.fail("is no finite hexfloat, such as \"0x1.8p-2\"");
  return *value;
}

/// Appends to a list of a document: a list by itself could not be destroyed when memory runs out.
void append_hexfloats(nlohmann::json& list, const double* values, std::size_t count) {
  if (list.is_null()) list = nlohmann::json::array();
  for (std::size_t i = 0; i < count; ++i) list.push_back(io::hexfloat(values[i]));
}

// Of a body's state: position 3, orientation 4, velocity 3, angular momentum 3.
constexpr std::size_t kNumbersOfBody = 13;

// In the place of a body's number, of an element of particles.
constexpr Index kNoBody = ~Index{0};

void append_bodies(nlohmann::json& json, const BodiesState& state, const Colliders& colliders) {
  append_hexfloats(json["bodies"], nullptr, 0);
  for (const BodyState& body : state.bodies) {
    append_hexfloats(json["bodies"], body.pose.p.data(), 3);
    append_hexfloats(json["bodies"], body.pose.q.data(), 4);
    append_hexfloats(json["bodies"], body.velocity.data(), 3);
    append_hexfloats(json["bodies"], body.momentum.data(), 3);
  }
  append_hexfloats(json["contact_forces"], nullptr, 0);
  json["contact_pairs"] = nlohmann::json::array();
  for (const ContactForce& force : state.forces) {
    append_hexfloats(json["contact_forces"], force.force.data(), 3);
    nlohmann::json& pair = json["contact_pairs"].emplace_back(nlohmann::json{static_cast<int>(force.pair.kind)});
    const auto append = [&](MeshElement sort, Index number) {
      const Index group = colliders.group_of(sort, number);
      pair.push_back(group == kParticles ? kNoBody : group - 1);
      pair.push_back(number - colliders.before(group).of(sort));
    };
    append(geometry::traits_of(force.pair.kind).first.sort, force.pair.i);
    append(geometry::traits_of(force.pair.kind).second.sort, force.pair.j);
  }
}

VectorX vector_from(const JsonNode& node) {
  const auto items = node.items();
  VectorX values(static_cast<Eigen::Index>(items.size()));
  for (std::size_t i = 0; i < items.size(); ++i) values[static_cast<Eigen::Index>(i)] = from_hexfloat(items[i]);
  return values;
}

BodiesState bodies_from(const JsonNode& root, const Scene& scene) {
  BodiesState state;
  const VectorX numbers = vector_from(root.at("bodies"));
  if (static_cast<std::size_t>(numbers.size()) % kNumbersOfBody != 0) {
    root.at("bodies").fail("must be 13 numbers a body: position, orientation, velocity, angular momentum");
  }
  for (Eigen::Index i = 0; i < numbers.size(); i += kNumbersOfBody) {
    BodyState& body = state.bodies.emplace_back();
    body.pose.p = numbers.segment<3>(i);
    for (Eigen::Index k = 0; k < 4; ++k) body.pose.q[static_cast<std::size_t>(k)] = numbers[i + 3 + k];
    body.velocity = numbers.segment<3>(i + 7);
    body.momentum = numbers.segment<3>(i + 10);
  }
  const Colliders colliders(scene, System(scene));
  const auto pairs = root.at("contact_pairs").items();
  const VectorX forces = vector_from(root.at("contact_forces"));
  if (static_cast<std::size_t>(forces.size()) != 3 * pairs.size()) {
    root.at("contact_forces").fail("must be three numbers for each of contact_pairs");
  }
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto numbers_of_pair = pairs[i].items();
    if (numbers_of_pair.size() != 5) pairs[i].fail("must be five numbers: kind, body, element, body, element");
    ContactForce& force = state.forces.emplace_back();
    force.pair.kind = static_cast<Kind>(numbers_of_pair[0].whole_number(0, kKinds.size() - 1));
    const auto number_of = [&](MeshElement sort, std::size_t at) {
      const Index body = numbers_of_pair[at].index(), number = numbers_of_pair[at + 1].index();
      const Index group = body == kNoBody ? kParticles : body + 1;
      if (group >= colliders.group_count() ||
          number >= colliders.before(group + 1).of(sort) - colliders.before(group).of(sort)) {
        numbers_of_pair[at].fail("and the number after it name an element that the scene does not have");
      }
      return colliders.before(group).of(sort) + number;
    };
    force.pair.i = number_of(geometry::traits_of(force.pair.kind).first.sort, 1);
    force.pair.j = number_of(geometry::traits_of(force.pair.kind).second.sort, 3);
    force.force = forces.segment<3>(3 * static_cast<Eigen::Index>(i));
  }
  std::sort(state.forces.begin(), state.forces.end(),
            [](const ContactForce& a, const ContactForce& b) { return a.pair < b.pair; });
  return state;
}

}  // namespace

std::string checkpoint_to_json(const Simulation& simulation) {
  const State& state = simulation.state();
  JsonDocument document;
  nlohmann::json& json = document.value();
  json["touchstone_checkpoint"] = kVersion;
  json["steps"] = simulation.steps();
  json["time"] = io::hexfloat(state.time);
  append_hexfloats(json["q"], state.q.data(), static_cast<std::size_t>(state.q.size()));
  append_hexfloats(json["v"], state.v.data(), static_cast<std::size_t>(state.v.size()));
  append_hexfloats(json["directors"], nullptr, 0);
  for (const Vector3& d : state.frames.director) append_hexfloats(json["directors"], d.data(), 3);
  append_hexfloats(json["reference_twists"], state.frames.reference_twist.data(), state.frames.reference_twist.size());
  if (simulation.bodies() != nullptr) append_bodies(json, simulation.bodies()->state(), simulation.colliders());
  json["scene"] = scene_to_json(simulation.scene());
  return io::sealed_json(json.dump(1) + "\n");
}

Checkpoint checkpoint_from_json(std::string_view text) {
  check_seal(text);
  const JsonDocument document = json::parse_json(text);
  const JsonNode root(document.value(), "the checkpoint");
  root.check_keys({"sha256", "touchstone_checkpoint", "steps", "time", "q", "v", "directors", "reference_twists",
                   "scene", "bodies", "contact_pairs", "contact_forces"});
  root.at("touchstone_checkpoint").version(kVersion);
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
  if (!checkpoint.scene.bodies.empty()) checkpoint.bodies = bodies_from(root, checkpoint.scene);
  return checkpoint;
}

}  // namespace touchstone::sim
