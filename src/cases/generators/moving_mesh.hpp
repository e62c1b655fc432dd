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

#include "generators/shapes.hpp"

namespace touchstone::generators {

enum class SceneName : std::uint8_t {
  cloth,   ///< a cloth that is draped over a deforming, turning sphere and slides on it
  sheets,  ///< two crumpled sheets, pressed together and sliding along each other
  cables,  ///< two bundles of whipping cables, one across the other; no faces
  drape,   ///< a cloth that waves above a deforming sphere; no two elements ever meet
  boxes,   ///< layers of cubes that slide on each other
  bricks,  ///< a wall of bricks, at rest
  plane,   ///< two bundles of cables that bend within the plane z = 0, one across the other; no faces
  grid,    ///< two plates on a grid, in one plane, one sliding over the other
  lying    ///< a cloth that lies on a box and hangs down on both sides, at rest
};

/// The scenes in which elements meet.
inline constexpr std::array<SceneName, 3> kScenes{SceneName::cloth, SceneName::sheets, SceneName::cables};
/// The scenes along the axes: elements meet in them, too, in common planes, and most coordinates have few bits.
inline constexpr std::array<SceneName, 5> kAlignedScenes{SceneName::boxes, SceneName::bricks, SceneName::plane,
                                                         SceneName::grid, SceneName::lying};
/// All of them, and the one in which no elements meet.
inline constexpr std::array<SceneName, 9> kAllScenes{SceneName::cloth, SceneName::sheets, SceneName::cables,
                                                     SceneName::drape, SceneName::boxes,  SceneName::bricks,
                                                     SceneName::plane, SceneName::grid,   SceneName::lying};

std::string_view scene_name(SceneName scene) noexcept;  ///< "cloth", "sheets", ...
std::optional<SceneName> scene_from_name(std::string_view name) noexcept;
bool has_faces(SceneName scene) noexcept;

/// A mesh whose corners are closed formulas of time. They move at about one unit of length a unit of time, or rest,
/// within a ball of radius 2 around the origin, as they are built. There is no contact response: in kScenes, elements in
/// contact pass through each other. So there is as much contact at the end as at the start.
class MovingMesh {
 public:
  virtual ~MovingMesh() = default;

  const Mesh& mesh() const noexcept { return mesh_; }
  double edge_length() const noexcept { return edge_length_; }  ///< about that of most edges

  /// The positions of the corners: `corners` gets mesh().corner_count of them, the same bits on every machine.
  virtual void set_corners(double time, std::vector<Vec3>& corners) const = 0;

  /// Moves one of the `corners` that set_corners gave for this time through a face of another object. Only the scene
  /// `drape` does so. The corner is the same at every time.
  /// @returns its number; nothing for another scene
  virtual std::optional<Index> plant_crossing(double /*time*/, std::vector<Vec3>& /*corners*/) const { return {}; }

 protected:
  Mesh mesh_;
  double edge_length_ = 0;
};

inline constexpr std::size_t kFewestEdges = 100;
inline constexpr std::size_t kMostEdges = 2'000'000;

/// What was done to a whole scene after it was built, as people's files have it. A scene along the axes gets noise in
/// the last bits of its coordinates so, or coordinates of two sizes.
enum class Placement : std::uint8_t {
  as_built,
  turned,      ///< by a rotation that depends on the seed; other scenes than kAlignedScenes have one already
  turned_90,   ///< about the z axis and then about the x axis by 90 degrees, with cos = 6.1e-17 as in doubles
  turned_45,   ///< the same by 45 degrees
  float32,     ///< moved by about a hundred, and rounded to float32: what a game or a scanner writes
  moved,       ///< rounded to float32, and moved by about a thousand in doubles
  far_corners  ///< one corner in seventeen is a thousand times as far from the origin
};
inline constexpr std::array<Placement, 7> kAllPlacements{
    Placement::as_built, Placement::turned, Placement::turned_90,  Placement::turned_45,
    Placement::float32,  Placement::moved,  Placement::far_corners};

std::string_view placement_name(Placement placement) noexcept;  ///< "as-built", "turned", "turned-90", ...
std::optional<Placement> placement_from_name(std::string_view name) noexcept;

/// @param edges  the approximate number of edges, in [kFewestEdges, kMostEdges]
std::unique_ptr<MovingMesh> make_moving_mesh(SceneName scene, std::uint64_t seed, std::size_t edges,
                                             Placement placement = Placement::as_built);

// One function for each SceneName.
std::unique_ptr<MovingMesh> make_cloth(std::uint64_t seed, std::size_t edges);
std::unique_ptr<MovingMesh> make_sheets(std::uint64_t seed, std::size_t edges);
std::unique_ptr<MovingMesh> make_cables(std::uint64_t seed, std::size_t edges);
std::unique_ptr<MovingMesh> make_drape(std::uint64_t seed, std::size_t edges);
std::unique_ptr<MovingMesh> make_boxes(std::uint64_t seed, std::size_t edges);
std::unique_ptr<MovingMesh> make_bricks(std::uint64_t seed, std::size_t edges);
std::unique_ptr<MovingMesh> make_plane(std::uint64_t seed, std::size_t edges);
std::unique_ptr<MovingMesh> make_grid(std::uint64_t seed, std::size_t edges);
std::unique_ptr<MovingMesh> make_lying(std::uint64_t seed, std::size_t edges);

/// The scene, placed in another way than as it was built.
std::unique_ptr<MovingMesh> placed(std::unique_ptr<MovingMesh> scene, Placement placement, std::uint64_t seed);

}  // namespace touchstone::generators
