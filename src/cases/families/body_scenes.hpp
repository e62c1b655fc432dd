// Scenes of whole bodies that turn, built to be degenerate: for `fuzz` and the tests.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include <touchstone/bodies.hpp>

#include "seeded/rng.hpp"

namespace touchstone::families {

/// What a body is made of.
struct BodyShape {
  MeshElements elements;
  std::vector<Vec3> points;
};

/// Bodies that can still be changed, and their motions.
struct BodyScene {
  std::vector<BodyShape> shapes;
  std::vector<RigidMotion> motions;  ///< one for each shape
  BodyRules rules;
  Separation separation;

  Bodies bodies() const;
};

enum class BodyFamily : std::uint8_t {
  bodies_random,   ///< faces, edges, loose points and boxes in random poses; numbers of few bits or of all
  bodies_quarter,  ///< boxes with small integers that make quarter and third turns
  bodies_touch,    ///< a box comes to another one's side or separation at exactly 0, 1/2 or 1, or misses it by an ulp
  bodies_inside,   ///< a box inside another one, which it may leave
  bodies_gears,    ///< two gears in mesh
  bodies_far       ///< those of another family, far from the origin
};
inline constexpr std::array kEveryBodyFamily = {BodyFamily::bodies_random, BodyFamily::bodies_quarter,
                                                BodyFamily::bodies_touch,  BodyFamily::bodies_inside,
                                                BodyFamily::bodies_gears,  BodyFamily::bodies_far};

std::string_view name_of(BodyFamily family) noexcept;
std::optional<BodyFamily> body_family_named(std::string_view name) noexcept;

/// The scene of a family. Equal seeds and indices make equal scenes.
BodyScene body_scene(BodyFamily family, std::uint64_t seed, std::uint64_t index);

/// A scene of BodyFamily::bodies_random, of two or three bodies.
BodyScene random_body_scene(seeded::Rng& random);

/// Faces, edges in no face and loose points, or a box. @param radii  whether vertices may have radii
BodyShape random_shape(seeded::Rng& random, bool coarse, bool radii);

/// A point within `size` along each axis. @param coarse  whether its coordinates have few bits
Vec3 some_point(seeded::Rng& random, bool coarse, double size);

/// A motion that turns, to a distance along each axis; the quaternions have any length.
RigidMotion some_motion(seeded::Rng& random, bool coarse, double distance);

/// A box about the origin, with these half widths.
BodyShape box_shape(double x, double y, double z);

/// All pairs that are asked about, from the words of BodyPair and of BodyRules::body_pairs, in ascending order.
std::vector<BodyPair> every_pair(const Bodies& bodies);

}  // namespace touchstone::families
