// The last resort of the response: groups of particles that move as one rigid body for a step (Bridson et al. 2002).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "contact/contact.hpp"
#include "geometry/union_find.hpp"

namespace touchstone::sim {

/// A partition of the particles into zones.
class ImpactZones {
 public:
  explicit ImpactZones(std::size_t particles) : joined_(particles) {}

  Index zone(Index particle) { return joined_.root(particle); }

  /// Joins the contact's particles into one zone. @returns false when they were in one already
  bool join(const Contact& contact);

  /// Zones of more than one particle, each in ascending order, by their first particle.
  std::vector<std::vector<Index>> zones();

 private:
  geometry::UnionFind joined_;
};

/// Whether a zone may turn. On the straight paths of a rotation by an angle a, distances shrink by up to cos(a / 2), so
/// a turn may bring elements within their separation. A shift keeps all distances.
enum class Turning : std::uint8_t { free, none };

/// Gives the zone's particles the rigid motion with their momentum and, unless it may not turn, angular momentum, or
/// the motion of the held or driven ones among them. All positions in between are images of x0 under one affine map
/// that is never singular, so no two of them meet. False when held particles among them move in different ways.
bool move_rigidly(const std::vector<Index>& zone, const System& system, const VectorX& inverse_mass, const VectorX& x0,
                  VectorX& x1, Turning turning = Turning::free);

}  // namespace touchstone::sim
