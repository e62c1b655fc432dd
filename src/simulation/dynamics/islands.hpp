// Newton's method on each island of a scene: nothing ties an island to the rest in a substep, neither springs nor
// contacts.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "dynamics/components.hpp"
#include "dynamics/newton.hpp"

namespace touchstone::sim {

/// An island that is slow to converge costs no iterations elsewhere, and only one island's matrices are in memory.
class Islands {
 public:
  /// @param cancel  is checked in each iteration, and lives as long as this
  Islands(const System& system, const Settings& settings,
          const linear::Cancellation& cancel = linear::Cancellation::never());

  /// As Newton::minimise, with the iterations of the island that needed most.
  NewtonResult minimise(const Stage& stage, const VectorX& guess, VectorX& q, Frames& frames);

 private:
  using Island = std::vector<Index>;  // components, ascending

  std::vector<Island> islands_of(std::span<const ContactTerm> contacts, std::vector<Index>& island_of) const;
  struct Begin {
    const Stage* stage;
    const VectorX *guess, *q;
    const Frames* frames;
  };
  NewtonResult minimise_island(const Island& island, bool with_loose, const std::vector<Index>& contacts,
                               const Begin& begin, VectorX& q, Frames& frames);
  SystemSubset members_of(const Island& island, bool with_loose, const std::vector<Index>& contacts,
                          const Stage& stage);

  const System* system_;
  Settings settings_;
  const linear::Cancellation* cancel_;
  linear::PatternCache patterns_;
  std::unique_ptr<Newton> whole_;  // once it is needed
  Components components_;
  std::vector<Index> local_particle_, local_edge_;
};

}  // namespace touchstone::sim
