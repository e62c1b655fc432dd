// The contacts of bodies in a step.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <utility>
#include <vector>

#include <touchstone/bodies.hpp>

#include "mesh/earliest.hpp"
#include "rigid/arc.hpp"
#include "rigid/body_data.hpp"
#include "rigid/near_elements.hpp"

namespace touchstone::rigid {

using BodyPairs = std::vector<std::array<BodyIndex, 2>>;

/// The pairs of bodies whose elements may come near each other in a step, in ascending order.
/// @param whole  by body: its motion over the whole step
BodyPairs near_bodies(const Bodies& bodies, const CollidingBodies& colliding, const std::vector<Arc>& whole);

/// The arcs of all bodies from one time to another one. @param motions  valid
std::vector<Arc> arcs_of(const Bodies& bodies, const std::vector<RigidMotion>& motions, double from, double to);

/// Two bodies, and their arcs in a piece of a step.
struct PairOnArcs {
  std::array<BodyIndex, 2> bodies;
  std::array<Arc, 2> arcs;
};

/// @param arcs  by body
std::vector<PairOnArcs> on_arcs(const BodyPairs& pairs, const std::vector<Arc>& arcs);

/// The pairs of elements that come near each other in pieces of a step, each of them once.
class Candidates {
 public:
  Candidates(const Bodies& bodies, const MeshOptions& options) : bodies_(bodies), options_(options) {}

  /// Those of a piece that were in none before it, in ascending order.
  /// @param near  the pairs of bodies to ask about
  std::vector<BodyPair> on(const std::vector<PairOnArcs>& near);

 private:
  const Bodies& bodies_;
  const MeshOptions& options_;
  std::vector<BodyPair> known_;  // ascending
};

/// The pair of elements that are near each other.
BodyPair pair_of(const NearElements& near) noexcept;

/// The whole answers for pairs, in ascending order.
std::vector<BodyContact> with_answers(const Bodies& bodies, const std::vector<RigidMotion>& motions,
                                      std::vector<mesh::Found<BodyPair>>& found, const StepOptions& options);

/// Every pair of elements in contact in the step, in the order of all_contacts.
std::vector<BodyContact> find_all(const Bodies& bodies, const CollidingBodies& colliding,
                                  const std::vector<RigidMotion>& motions, const StepOptions& options);

FirstBodyContact find_first(const Bodies& bodies, const CollidingBodies& colliding,
                            const std::vector<RigidMotion>& motions, const BodyStepOptions& options);

/// @param poses     valid
/// @param left_out  null, or becomes what was not found out; it is empty before
std::vector<BodyIntersection> find_intersections(const Bodies& bodies, const CollidingBodies& colliding,
                                                 const std::vector<Pose>& poses, const MeshOptions& options,
                                                 BodiesLeftOut* left_out = nullptr);

std::vector<Pose> starts_of(const std::vector<RigidMotion>& motions);

/// The motions that rest in these poses.
std::vector<RigidMotion> resting(const std::vector<Pose>& poses);

}  // namespace touchstone::rigid
