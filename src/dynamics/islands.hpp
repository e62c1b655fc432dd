// Newton's method on each part of a scene that nothing ties to the rest in a step: neither springs nor contacts.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "dynamics/components.hpp"
#include "dynamics/newton.hpp"

namespace touchstone::sim {

/// A part of a pile that is slow to converge costs no iterations elsewhere, and only one part's matrices are in memory.
class Islands {
 public:
  Islands(const System& system, const Settings& settings);

  /// As Newton::minimise, with the iterations of the part that needed most.
  NewtonResult minimise(const Stage& stage, const VectorX& guess, VectorX& q, Frames& frames);

 private:
  using Part = std::vector<Index>;  // components, ascending

  std::vector<Part> parts_of(std::span<const ContactTerm> contacts, std::vector<Index>& part_of) const;
  struct Begin {
    const Stage* stage;
    const VectorX *guess, *q;
    const Frames* frames;
  };
  NewtonResult minimise_part(const Part& part, bool with_loose, const std::vector<Index>& contacts, const Begin& begin,
                             VectorX& q, Frames& frames);
  SystemPart members_of(const Part& part, bool with_loose, const std::vector<Index>& contacts, const Stage& stage);

  const System* system_;
  Settings settings_;
  linear::PatternCache patterns_;
  std::unique_ptr<Newton> whole_;  // once it is needed
  Components components_;
  std::vector<Index> local_particle_, local_edge_;
};

}  // namespace touchstone::sim
