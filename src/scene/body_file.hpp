// One body of a scene file.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "json/json_node.hpp"
#include "scene/body.hpp"

namespace touchstone::sim {

/// @throws Error naming the key that is missing, unknown or of a wrong type
Body body_from(const json::JsonNode& node);

std::string body_to_json(const Body& body);

}  // namespace touchstone::sim
