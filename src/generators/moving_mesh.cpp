// SPDX-License-Identifier: MIT
#include "generators/moving_mesh.hpp"

namespace touchstone::generators {

std::string_view scene_name(SceneName scene) noexcept {
  switch (scene) {
    case SceneName::cloth: return "cloth";
    case SceneName::sheets: return "sheets";
    case SceneName::cables: return "cables";
    case SceneName::drape: return "drape";
  }
  return {};
}

std::optional<SceneName> scene_from_name(std::string_view name) noexcept {
  for (const SceneName scene : kAllScenes) {
    if (name == scene_name(scene)) return scene;
  }
  return std::nullopt;
}

bool has_faces(SceneName scene) noexcept { return scene != SceneName::cables; }

std::unique_ptr<MovingMesh> make_moving_mesh(SceneName scene, std::uint64_t seed, std::size_t edges) {
  switch (scene) {
    case SceneName::cloth: return make_cloth(seed, edges);
    case SceneName::sheets: return make_sheets(seed, edges);
    case SceneName::cables: return make_cables(seed, edges);
    case SceneName::drape: return make_drape(seed, edges);
  }
  return nullptr;
}

}  // namespace touchstone::generators
