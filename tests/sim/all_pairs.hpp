// All pairs of a small scene, found without boxes, and scenes to compare them on.
// SPDX-License-Identifier: MIT
#pragma once

#include <tuple>
#include <vector>

#include "contact/colliders.hpp"
#include "seeded/rng.hpp"

namespace touchstone::sim {

using PairKey = std::tuple<Kind, Index, Index>;
inline PairKey key(const Pair& pair) { return {pair.kind, pair.i, pair.j}; }

/// Every pair that could touch in a scene whose particles all collide and all may move.
std::vector<Pair> all_pairs(const Scene& scene, const Colliders& colliders);

/// Edges, faces, folds and loose particles. On a grid boxes touch more often than they overlap.
Scene random_scene(seeded::Rng& random, bool on_grid);

}  // namespace touchstone::sim
