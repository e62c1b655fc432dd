// Scenes as JSON. The schema is in the README.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "scene/scene.hpp"

namespace touchstone::sim {

/// The scene that `text` describes, checked. @throws Error with the path of the offending key, "cables[2].radius",
/// and what it may be; a text that is no JSON is told with line and column
Scene scene_from_json(std::string_view text);

/// Text from which scene_from_json makes the same scene, to the last bit.
std::string scene_to_json(const Scene& scene);

}  // namespace touchstone::sim
