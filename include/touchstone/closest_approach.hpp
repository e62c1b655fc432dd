// Touchstone: how near do the elements of a mesh come to each other?
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include <touchstone/mesh.hpp>

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

/// The least distance of a mesh's elements, at rest or during a step.
struct ClosestApproach {
  /// The least distance, rounded up to a double: some pair comes within it, and none within the next lesser double. It
  /// is 0 where the mesh intersects itself at the start. Infinity where no two elements may collide, or where all that
  /// may are farther apart than the greatest double.
  double distance = std::numeric_limits<double>::infinity();

  /// The answer of `first_contact`, with check_start, of the same mesh without radii and with this distance as the
  /// separation of every pair: when two elements come within the distance first, and which pairs. As the distance is
  /// rounded up, that may be a little before the time at which they are nearest. A mesh that is so near all along has
  /// its pairs in at_start.
  FirstContact first_contact;
};

/// The least distance in a step of two elements that may collide. Each vertex moves on a straight line from its
/// position in x0 to that in x1. Distances are measured in the mesh's metric, between the elements as they are:
/// separations and radii do not count. The pairs are those of first_contact: so of one surface all elements count that
/// share no vertex, and neighbours along a wire count only where they touch. To ask between parts only, give the parts
/// groups in CollisionRules.
///
/// The result is the same for every number of threads.
/// @param mesh     the mesh
/// @param x0       the positions at t = 0
/// @param x1       the positions at t = 1
/// @param options  the end of the step, and how the question is answered
/// @return the closest approach
/// @throws InvalidQuery  as first_contact
ClosestApproach closest_approach(const Mesh& mesh, const Positions& x0, const Positions& x1,
                                 const StepOptions& options = {});

/// The same at rest, at the positions x: how far are the elements from each other?
/// @throws InvalidQuery  as first_contact
ClosestApproach distance(const Mesh& mesh, const Positions& x, const MeshOptions& options = {});

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
