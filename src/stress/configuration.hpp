// Elements that meet at a prescribed time and place, in numbers so plain that doubles hold them exactly: what the dials
// make stiff.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <touchstone/query.hpp>

#include "seeded/rng.hpp"

namespace touchstone::stress {

using Corners = std::array<Vec3, 4>;

/// Where the corners are at `time`, and how they move. The line of one element then meets the line or plane of the
/// other; inside of both elements, on a border, or 1/64 outside of one.
struct Configuration {
  Kind kind = Kind::edge_edge;
  double time = 0;     ///< a multiple of 1/8 in [0, 1]
  Vec3 meeting;        ///< the place, three integers
  Corners at{};        ///< multiples of 2^-9 below 2^5
  Corners velocity{};  ///< integers from -4 to 4
};

/// Edge-edge or vertex-face.
Configuration random_configuration(Kind kind, seeded::Rng& rng);

/// Each coordinate times the same one of `factors`.
Corners scaled(const Corners& corners, const Vec3& factors);

/// All corners by a matrix of small integers and determinant 1: what was large and small along the axes becomes so
/// along directions of no account, and is rounded where doubles do not hold both.
Corners sheared(const Corners& corners);

/// x y z become y z x, so many times.
Corners turned(const Corners& corners, int times);

/// The query in which the corners are where the configuration says, as near as doubles come.
Query query_of(const Configuration& configuration);

}  // namespace touchstone::stress
