// The pairs of a mesh that come near each other in a step.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <functional>
#include <vector>

#include "broad_phase/box_tree.hpp"
#include "mesh/mesh_elements.hpp"
#include "mesh/moving_vertices.hpp"

namespace touchstone::mesh {

/// @throws Stopped  when the flag is set
inline void check_stop(const std::atomic<bool>* stop) {
  if (stop != nullptr && stop->load(std::memory_order_relaxed)) throw Stopped("the call was stopped");
}

/// How far the boxes of elements reach.
struct Reach {
  double same = 0;                  ///< beyond each element, on all sides
  std::vector<double> of_vertices;  ///< in place of it: an element's is the greatest of its vertices'; empty without

  /// Beyond that. The greatest of an element's vertices counts by itself: another one than in the list above may have
  /// it. Empty without.
  std::vector<double> of_ways;

  /// Where it is not 0: boxes hold their elements' ways at all times of [0, 1], and reach so far in place of that at
  /// t = 1, evenly less before that and nowhere at t = 0.
  double swelling = 0;
};

/// The reach that finds every pair whose distance falls to its separation or below.
Reach reach_of_separations(const Mesh::Impl& mesh);

/// The reach that finds every pair whose distance may fall by the time `until` in [0, 1] from D0 at the start to
/// d + fraction (D0 - d) or below, for the separation d. 0 <= fraction < 1.
Reach reach_of_fraction(const Mesh::Impl& mesh, const Motion& motion, double fraction, double until);

/// That of the fraction, or of the separations where it is 0.
Reach reach_of(const Mesh::Impl& mesh, const Motion& motion, double kept_fraction, double until = 1);

/// Takes at most broad_phase::kPairBlock pairs of a kind. Several threads may call it at the same time.
using CandidateConsumer = std::function<void(Kind kind, const broad_phase::Pair* pairs, std::size_t count)>;

/// Hands out, once, each pair that may collide and whose boxes meet.
void for_each_candidate_block(const Mesh::Impl& mesh, const Motion& motion, const Reach& reach,
                              const broad_phase::PairSearch& search, const CandidateConsumer& take);

/// Takes at most broad_phase::kPairBlock pairs of elements of two sorts: the first one comes no later in MeshElement.
/// Several threads may call it at the same time.
using ElementConsumer =
    std::function<void(MeshElement first, MeshElement second, const broad_phase::Pair* pairs, std::size_t count)>;

/// Hands out, once, each pair of elements that `intersections` compares, whose boxes at t = 0 touch, and that may
/// intersect.
void for_each_resting_block(const Mesh::Impl& mesh, const Motion& motion, const broad_phase::PairSearch& search,
                            const ElementConsumer& take);

}  // namespace touchstone::mesh
