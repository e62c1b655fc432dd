// Deforming surfaces and cables in motion, as closed formulas of time.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include <touchstone/query.hpp>

#include "generators/mesh.hpp"

namespace touchstone::generators {

enum class SceneName : std::uint8_t {
  cloth,   ///< a cloth that is draped over a deforming, turning sphere and slides on it
  sheets,  ///< two crumpled sheets, pressed together and sliding along each other
  cables,  ///< two bundles of whipping cables, one across the other; no faces
  drape    ///< a cloth that waves above a deforming sphere; no two elements ever meet
};

/// The scenes in which elements meet.
inline constexpr std::array<SceneName, 3> kScenes{SceneName::cloth, SceneName::sheets, SceneName::cables};
/// Those, and the one in which none do.
inline constexpr std::array<SceneName, 4> kAllScenes{SceneName::cloth, SceneName::sheets, SceneName::cables,
                                                     SceneName::drape};

std::string_view scene_name(SceneName scene) noexcept;  ///< "cloth", "sheets", "cables", "drape"
std::optional<SceneName> scene_from_name(std::string_view name) noexcept;
bool has_faces(SceneName scene) noexcept;

/// A mesh whose corners are closed formulas of time. They move at about one unit of length a unit of time, within a
/// ball of radius 2 around the origin. There is no contact response: in kScenes, elements in contact pass through each
/// other. So there is as much contact at the end as at the start.
class MovingMesh {
 public:
  virtual ~MovingMesh() = default;

  const Mesh& mesh() const noexcept { return mesh_; }
  double edge_length() const noexcept { return edge_length_; }  ///< about that of most edges

  /// The positions of the corners: `corners` gets mesh().corner_count of them, the same bits on every machine.
  virtual void place_corners(double time, std::vector<Vec3>& corners) const = 0;

  /// Moves one of the `corners` that place_corners gave for this time through a face of another part. Only the scene
  /// `drape` does so. The corner is the same at every time.
  /// @returns its number; nothing for another scene
  virtual std::optional<Index> plant_crossing(double /*time*/, std::vector<Vec3>& /*corners*/) const { return {}; }

 protected:
  Mesh mesh_;
  double edge_length_ = 0;
};

inline constexpr std::size_t kFewestEdges = 100;
inline constexpr std::size_t kMostEdges = 2'000'000;

/// @param edges  the approximate number of edges, in [kFewestEdges, kMostEdges]
std::unique_ptr<MovingMesh> make_moving_mesh(SceneName scene, std::uint64_t seed, std::size_t edges);

// One function for each SceneName.
std::unique_ptr<MovingMesh> make_cloth(std::uint64_t seed, std::size_t edges);
std::unique_ptr<MovingMesh> make_sheets(std::uint64_t seed, std::size_t edges);
std::unique_ptr<MovingMesh> make_cables(std::uint64_t seed, std::size_t edges);
std::unique_ptr<MovingMesh> make_drape(std::uint64_t seed, std::size_t edges);

}  // namespace touchstone::generators
