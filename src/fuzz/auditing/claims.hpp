// The questions that an engine claims to answer, and the query among them that is nearest to another one.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>

#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

namespace touchstone::fuzz {

enum class ClaimedMotion : std::uint8_t {
  straight,      ///< each corner moves on a line of its own
  translations,  ///< each element moves as a whole
  cast,          ///< the first element moves as a whole, and the second stands still
  still          ///< nothing moves
};

struct Claims {
  ClaimedMotion motion = ClaimedMotion::straight;
  bool in_plane = false;      ///< z = 0
  bool floats = false;        ///< coordinates and motions are floats
  bool starts_apart = false;  ///< the elements are not in contact at t = 0
  /// The least length of an edge and height of a face, as a part of the query's extent.
  double least_element = 0;
  /// The range of a query's greatest coordinate.
  double least = 0, greatest = std::numeric_limits<double>::infinity();
};

/// The query itself where it is claimed, as far as this function can see. Otherwise z is dropped, motions of
/// corners become motions of elements, numbers are rounded so that motions are exact, and all is scaled by a power of
/// two. Each of its own results is the nearest to itself.
Query nearest_claimed(const Query& query, const Claims& claims);

/// Whether the engine claims a query that nearest_claimed gave: no element is degenerate, a query of translations
/// moves, and the elements start apart where that is claimed. @param separation  what the query asks about
bool is_claimed(const Query& nearest, const Claims& claims, const Separation& separation);

}  // namespace touchstone::fuzz
