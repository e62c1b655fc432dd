// Answers about whole bodies, judged by the exact answers to all pairs of their elements.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <touchstone/bodies.hpp>

#include "families/body_scenes.hpp"
#include "fuzz/scenes/scene_search.hpp"

namespace touchstone::fuzz {

/// What is answered about bodies in a step.
struct BodyReply {
  FirstBodyContact first;
  std::vector<BodyContact> all;
  std::vector<BodyPair> candidates;
  FreeBodyStep step;
};

/// The function under test. The start is to be asked about, too.
using BodySolver = std::function<BodyReply(const Bodies&, const std::vector<RigidMotion>&)>;

/// The contacts of all pairs, each asked by itself with Method::exact: no box and no tree is used.
std::vector<BodyContact> exact_contacts(const Bodies& bodies, const std::vector<RigidMotion>& motions);

/// The answers of the library.
BodyReply library_body_reply(const Bodies& bodies, const std::vector<RigidMotion>& motions);

/// Asks, and compares with exact_contacts.
/// Whether a vertex is inside another body's closed surfaces is told by how often a ray from it meets them.
/// @return nothing when all of it is right
/// @throws InvalidQuery, InvalidMesh  for a scene without meaning
std::optional<SceneFailure> judge_bodies(const families::BodyScene& scene, const BodySolver& solver);

}  // namespace touchstone::fuzz
