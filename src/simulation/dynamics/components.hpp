// The particles and elements that springs and cables tie together, contacts left aside.
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <vector>

#include "rods/system.hpp"

namespace touchstone::sim {

constexpr Index kNone = std::numeric_limits<Index>::max();

/// Numbers of elements, by component.
struct Members {
  std::vector<Index> first, all;

  /// @param component_of  the component of each of `count` elements, or kNone
  template <class Component>
  void sort(std::size_t components, std::size_t count, Component component_of);

  void append(Index component, std::vector<Index>& to) const;
};

/// Held particles tie nothing, and are in no component.
struct Components {
  explicit Components(const System& system);

  std::vector<Index> of_particle;
  Members particles, stretch_elements, edges, joints, membranes, hinges;
  std::vector<Index> unknowns;     ///< of each component
  std::vector<Index> loose_edges;  ///< held ones, which have frames all the same
};

}  // namespace touchstone::sim
