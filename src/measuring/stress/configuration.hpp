// Elements that meet at a prescribed time and place. Their numbers are so short that doubles hold them exactly. The
// dials make them stiff.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <touchstone/query.hpp>

#include "seeded/rng.hpp"

namespace touchstone::stress {

using Corners = std::array<Vec3, 4>;

/// The corners at `time`, and their velocities. At that time the line of one element meets the line or plane of the
/// other: inside of both elements, on a border, or 1/64 outside of one.
struct Configuration {
  Kind kind = Kind::edge_edge;
  double time = 0;     ///< a multiple of 1/8 in [0, 1]
  Vec3 meeting;        ///< the point, three integers
  Corners at{};        ///< multiples of 2^-9 below 2^5
  Corners velocity{};  ///< integers from -4 to 4
};

/// Edge-edge or vertex-face.
Configuration random_configuration(Kind kind, seeded::Rng& rng);

/// The corners with x, y and z multiplied by those of `factors`.
Corners scaled(const Corners& corners, const Vec3& factors);

/// All corners times a matrix of small integers and determinant 1. Then large and small extents no longer lie along the
/// axes, and coordinates that doubles cannot hold are rounded.
Corners sheared(const Corners& corners);

/// x y z become y z x, `times` times.
Corners turned(const Corners& corners, int times);

/// The query whose corners are at the configuration's positions, rounded to doubles.
Query query_of(const Configuration& configuration);

}  // namespace touchstone::stress
