// One body of a scene file.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "json/json_node.hpp"
#include "scene/body.hpp"

namespace touchstone::sim {

/// A list of three numbers.
inline Vector3 vector_from(const json::JsonNode& node) {
  const auto numbers = node.three_numbers();
  return {numbers[0], numbers[1], numbers[2]};
}

inline Vector3 vector_or(const json::JsonNode& node, std::string_view key, const Vector3& otherwise) {
  return node.has(key) ? vector_from(node.at(key)) : otherwise;
}

inline nlohmann::ordered_json list(const Vector3& v) { return nlohmann::ordered_json::array({v.x(), v.y(), v.z()}); }

/// @throws Error naming the key that is missing, unknown or of a wrong type
Body body_from(const json::JsonNode& node);

std::string body_to_json(const Body& body);

}  // namespace touchstone::sim
