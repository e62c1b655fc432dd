// The distances that pairs of elements keep: the sums of their radii, but for neighbours.
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "rods/system.hpp"

namespace touchstone::sim {

/// The pairs of particles that are so near along the elements that these cannot be asked to keep their distance. A
/// round cable that bends as sharply as its radius r allows has an arc of pi r between points 2 r apart. So elements
/// that keep a distance d are neighbours when a way along edges and springs, as they are placed, leads from a corner of
/// one to a corner of the other and is shorter than pi/2 d.
class Neighbours {
 public:
  Neighbours() = default;

  /// @param edges   those that collide; springs that do not collide are ways, too
  /// @param radius  of each particle: the largest of its elements, m
  /// @param placed  the initial positions
  /// @throws Error when there are too many
  Neighbours(const Scene& scene, std::span<const Edge> edges, const std::vector<double>& radius, const VectorX& placed);

  std::size_t count() const noexcept { return others_.size(); }

  /// Whether the shortest way between two different particles is shorter than pi/2 d. d is at most the sum of their
  /// radii, rounded up.
  bool near(Index a, Index b, double d) const noexcept;

  /// Calls f(a, b) for each pair of particles that are near for some d.
  template <class F>
  void for_each(F&& f) const {
    for (Index a = 0; a + 1 < first_.size(); ++a) {
      for (std::size_t i = first_[a]; i < first_[a + 1]; ++i) f(a, others_[i].to);
    }
  }

 private:
  struct Way {
    Index to = 0;
    double length = 0;  // m
  };

  std::vector<std::size_t> first_;  // by particle: the first of others_; one more at the end
  std::vector<Way> others_;         // of each particle, by number: those with a higher number
};

/// The radii of elements in contacts, m.
struct Radii {
  std::vector<double> edge, face, particle;  ///< empty when every radius is 0

  Radii() = default;
  /// @param edges  those that collide, sorted, each once, its own particles in ascending order
  Radii(const Scene& scene, const std::vector<Edge>& edges);

  bool any() const noexcept { return !particle.empty(); }
};

}  // namespace touchstone::sim
