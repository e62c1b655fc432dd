// The elements of bodies and of particles, and the pairs of them, one of a body at least, that come close in a substep.
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <string>
#include <vector>

#include <touchstone/curved_query.hpp>

#include "body_contact/body_system.hpp"
#include "body_contact/clusters.hpp"
#include "body_contact/element_set.hpp"
#include "contact/colliders.hpp"

namespace touchstone::sim {

constexpr Index kParticles = ~Index{0};  ///< in the place of a body's number

/// An element, or a corner of one, of a body or of the particles.
struct OfBody {
  Index body = kParticles;
  Index number = 0;  ///< of the vertex, edge or face within the body; of the particle

  auto operator<=>(const OfBody&) const = default;
};

/// As Pair: edge and edge, vertex and face, particle and edge of a wire frame. Where a body pushes particles onto
/// others, also any Pair of the particles' Colliders, with its numbers.
struct BodyPair {
  Kind kind = Kind::edge_edge;
  OfBody a, b;

  auto operator<=>(const BodyPair&) const = default;
};

/// The stored motion of a substep: bodies move by touchstone::RigidMotion between their poses, particles straight.
struct BodyMotions {
  const BodyStates* start = nullptr;
  const BodyStates* end = nullptr;
  const VectorX* x0 = nullptr;
  const VectorX* x1 = nullptr;
};

/// By how much, m, a point of a body may at most leave the straight line between the ends of its path, along an axis,
/// at any time of the motion from one orientation to the other. @param q0, q1  of length 1, with q0 . q1 >= 0
/// @param reach  m: no point is farther from the origin
double bulge(const Quaternion& q0, const Quaternion& q1, double reach) noexcept;

class BodyColliders {
 public:
  BodyColliders(const Scene& scene, const System& system, const Colliders& particles, const BodySystem& bodies);

  const BodySystem& bodies() const noexcept { return *bodies_; }
  const ElementSet& surface(Index body) const noexcept { return body == kParticles ? particles_ : surfaces_[body]; }
  const std::vector<ElementSet>& surfaces() const noexcept { return surfaces_; }

  std::array<OfBody, 4> corners(const BodyPair& pair) const noexcept;
  CurvedQuery query(const BodyPair& pair, const BodyMotions& motions) const noexcept;

  /// Every pair whose elements may come within its separation and `margin` of each other, and in which something can
  /// move. The order depends on the arguments only.
  std::vector<BodyPair> candidates(const BodyMotions& motions, double margin) const;

  /// Pairs of particles alone, which may come within their separation, and of which `moved` has a corner.
  /// @param moved  by particle
  std::vector<BodyPair> particle_candidates(const BodyMotions& motions, const std::vector<char>& moved) const;

  bool can_move(Index body) const noexcept;

  /// Whether a body has a radius, or an element of the particles.
  bool has_separations() const noexcept { return has_separations_; }
  double radius(Index body) const noexcept { return radii_[body]; }  ///< m, in contacts

  /// The distance that the pair is to stay farther apart than, m: the sum of the radii of its elements, rounded up.
  double separation(const BodyPair& pair) const noexcept { return has_separations_ ? separation_of(pair) : 0; }

  /// "edge 3-4 of body 1 and edge 10-11 of body 2"; without "of body" for particles.
  std::string describe(const BodyPair& pair) const;

  double shortest_edge() const noexcept { return shortest_; }  ///< m, of bodies
  Vector3 at(const OfBody& corner, const BodyStates& states, const VectorX& x) const noexcept;

  /// Of a body. The particles have no clusters, as they move against each other.
  struct Clusters {
    std::vector<std::array<Index, 1>> singles;  ///< its vertices, as elements of one corner
    std::vector<Cluster> vertices, edges, faces;
  };

 private:
  double separation_of(const BodyPair& pair) const noexcept;

  const BodySystem* bodies_;
  const Colliders* of_particles_;
  ElementSet particles_;
  std::vector<ElementSet> surfaces_;
  std::vector<Clusters> clusters_;  // by body
  Clusters no_clusters_;            // of the particles
  std::vector<char> moves_;         // by particle
  double shortest_ = 0;
  std::vector<double> radii_;  // of bodies
  bool has_separations_ = false;
};

}  // namespace touchstone::sim
