// Surfaces of cloth in a scene file.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "json/json_node.hpp"
#include "scene/scene.hpp"

namespace touchstone::sim {

/// Whether an object of `surfaces` is cloth, and not springs: it has a key that only cloth has.
bool is_cloth(const json::JsonNode& node);

/// @throws Error with the path of the offending key
Surface cloth_from(const json::JsonNode& node);

nlohmann::ordered_json json_of(const Surface& surface);

}  // namespace touchstone::sim
