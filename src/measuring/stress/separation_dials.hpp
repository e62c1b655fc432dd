// Two roots of the coplanarity cubic as near to each other as coordinates in doubles can bring them.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/query.hpp>

#include "seeded/rng.hpp"

namespace touchstone::stress {

/// A query whose V has the factors h(t) and g(t), linear in t, with roots that are different and about 2^-bits apart,
/// bits from 4 to 200. At the root of h most of the elements meet. At the root of g the edges are parallel, or the face
/// is flat, and the elements do not meet. Edge-edge or vertex-face.
Query separated_roots(Kind kind, int bits, seeded::Rng& rng);

}  // namespace touchstone::stress
