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

std::string_view placement_name(Placement placement) noexcept {
  switch (placement) {
    case Placement::as_built: return "as-built";
    case Placement::turned: return "turned";
    case Placement::turned_90: return "turned-90";
    case Placement::turned_45: return "turned-45";
    case Placement::float32: return "float32";
    case Placement::moved: return "moved";
    case Placement::far_corners: return "far-corners";
  }
  return {};
}

std::optional<Placement> placement_from_name(std::string_view name) noexcept {
  for (const Placement placement : kAllPlacements) {
    if (name == placement_name(placement)) return placement;
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

std::unique_ptr<MovingMesh> make_moving_mesh(SceneName scene, std::uint64_t seed, std::size_t edges,
                                             Placement placement) {
  std::unique_ptr<MovingMesh> mesh = make(scene, seed, edges);
  return placement == Placement::as_built ? std::move(mesh) : placed(std::move(mesh), placement, seed);
}

}  // namespace touchstone::generators
