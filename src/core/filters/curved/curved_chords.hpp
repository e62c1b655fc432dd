// Corners of curved queries as straight motion: the chords of their paths, with a bound on how far they leave them.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/curved_query.hpp>
#include <touchstone/separation.hpp>

namespace touchstone::filters {

/// The straight motion from each corner's start to its end, seen from an origin that moves with one of the elements.
struct Chords {
  bool known = false;  ///< false where nothing is known: the other members then mean nothing
  Query query;
  double deviation = 0;  ///< at no time are both elements together farther than this from those of `query`
};

/// Known only where bodies turn little, with quaternions of one length, and other corners move straight.
/// @param query  valid, of two edges or of a vertex and a face
Chords chords_of(const CurvedQuery& query) noexcept;

/// Whether the lines of two edges, or a vertex and a face's plane, are so far apart along the chords that the elements
/// are certainly farther than a separation >= 0 from each other all over the step. This is faster than hulls.
bool chords_certainly_farther(const CurvedQuery& query, const Separation& separation) noexcept;

}  // namespace touchstone::filters
