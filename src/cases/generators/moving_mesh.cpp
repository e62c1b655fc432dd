// SPDX-License-Identifier: MIT
#include "generators/moving_mesh.hpp"

#include <utility>

namespace touchstone::generators {

std::string_view scene_name(SceneName scene) noexcept {
  switch (scene) {
    case SceneName::cloth: return "cloth";
    case SceneName::sheets: return "sheets";
    case SceneName::cables: return "cables";
    case SceneName::drape: return "drape";
    case SceneName::boxes: return "boxes";
    case SceneName::bricks: return "bricks";
    case SceneName::plane: return "plane";
    case SceneName::grid: return "grid";
    case SceneName::lying: return "lying";
  }
  return {};
}

std::optional<SceneName> scene_from_name(std::string_view name) noexcept {
  for (const SceneName scene : kAllScenes) {
    if (name == scene_name(scene)) return scene;
  }
  return std::nullopt;
}

bool has_faces(SceneName scene) noexcept { return scene != SceneName::cables && scene != SceneName::plane; }

namespace {

std::unique_ptr<MovingMesh> make(SceneName scene, std::uint64_t seed, std::size_t edges) {
  switch (scene) {
    case SceneName::cloth: return make_cloth(seed, edges);
    case SceneName::sheets: return make_sheets(seed, edges);
    case SceneName::cables: return make_cables(seed, edges);
    case SceneName::drape: return make_drape(seed, edges);
    case SceneName::boxes: return make_boxes(seed, edges);
    case SceneName::bricks: return make_bricks(seed, edges);
    case SceneName::plane: return make_plane(seed, edges);
    case SceneName::grid: return make_grid(seed, edges);
    case SceneName::lying: return make_lying(seed, edges);
  }
  return nullptr;
}

}  // namespace

std::unique_ptr<MovingMesh> make_moving_mesh(SceneName scene, std::uint64_t seed, std::size_t edges, bool is_turned) {
  std::unique_ptr<MovingMesh> mesh = make(scene, seed, edges);
  return is_turned ? turned(std::move(mesh), seed) : std::move(mesh);
}

}  // namespace touchstone::generators
