// Elements that pass through each other before a run begins. A pair that is pierced never touches, so that no step
// would find it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "contact/colliders.hpp"

namespace touchstone::sim {

/// What is allowed at the start, and what a verdict tells.
struct StartFindings {
  std::size_t held = 0;                ///< pairs of elements that intersect and cannot move: no step asks about them
  std::size_t within_bodies = 0;       ///< pairs of elements of one body that intersect: they do so for ever
  std::size_t enclosed = 0;            ///< parts wholly inside closed surfaces: `insides` with ClosedParts::all
  std::size_t enclosed_in_bodies = 0;  ///< of these, those in a body
  std::size_t branching = 0;           ///< Insides
  std::size_t in_open = 0;             ///< likewise
  std::string
      enclosed_first;  ///< of the enclosed ones: "particle 3 in body 0", "particle 3 in the surface of face 5-6-7"
};

/// Asks `intersections` of all elements at once, at the start of a run or at its checkpoint. Corners of bodies are
/// rounded to doubles, and then decided exactly.
/// @throws Error "WHAT begins with elements that pierce each other: edge 0-1 and face 2-3-4 at (x, y, z)", or that
/// touch
StartFindings check_no_intersection(const Colliders& colliders, const VectorX& q, const BodyStates& bodies,
                                    std::string_view what, int threads);

}  // namespace touchstone::sim
