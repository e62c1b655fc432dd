// The elements of a scene with their radii, and the distances of all their pairs. It is made from the scene alone, and
// shares no code with the simulator: every pair, the shortest ways between all particles, and exact distances by the
// formulas of tests/oracle.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "contact/colliders.hpp"

namespace touchstone::sim {

struct ThickPair {
  Kind kind = Kind::edge_edge;
  std::array<Index, 4> particles{};
  double first_radius = 0, second_radius = 0;
};

/// How pairs stand at some times of a straight motion.
struct Nearness {
  std::uint64_t exact = 0;       ///< distances that were compared exactly
  std::uint64_t violations = 0;  ///< of these, those that are not greater than the sum of two radii
  double least_gap = 1e300;      ///< m: the least distance beyond the sum of the radii; in doubles
};

class ThickElements {
 public:
  explicit ThickElements(const Scene& scene);

  /// Pairs of elements of which at least one has a radius, and which are no neighbours and share no particle.
  const std::vector<ThickPair>& pairs() const noexcept { return pairs_; }

  /// Whether a way along edges and springs that is shorter than pi/2 times the sum of the radii joins the pair.
  bool are_neighbours(const ThickPair& pair) const;

  /// All pairs at these times of the straight motion from x0 to x1.
  void measure(const VectorX& x0, const VectorX& x1, const std::vector<double>& times, Nearness& nearness) const;

 private:
  std::size_t count_;
  std::vector<double> ways_;  // lengths of the shortest ones, by two particles
  std::vector<ThickPair> pairs_;
};

}  // namespace touchstone::sim
