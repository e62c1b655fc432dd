// A substep of bodies: their free motion, impulses where they meet, and the exact answers about the motion that is
// left.
// SPDX-License-Identifier: MIT
#pragma once

#include "body_contact/contact_solver.hpp"
#include "contact/narrow_phase.hpp"
#include "contact/outcome.hpp"

namespace touchstone::sim {

/// The contact forces of the substep before, from which the solver starts. N
struct ContactForce {
  Pair pair;
  Vector3 force = Vector3::Zero();

  bool operator==(const ContactForce&) const = default;
};

/// All that a run needs to go on: the states of the bodies, and the contact forces in the order of their pairs.
struct BodiesState {
  BodyStates bodies;
  std::vector<ContactForce> forces;

  bool operator==(const BodiesState&) const = default;
};

struct BodyCounts {
  std::uint64_t close = 0;       ///< contacts that the impulses see
  std::uint64_t contacts = 0;    ///< pairs that would touch, over all passes
  std::uint64_t queries = 0;     ///< of the passes whose motion was not taken
  LevelCounts levels;            ///< of these
  std::uint64_t pairs = 0;       ///< proved: the candidates of the motion that is taken
  LevelCounts proof;             ///< of these
  SeparationCounts separations;  ///< of these
  int passes = 0, sweeps = 0, zones = 0;
};

/// A substep of the bodies.
struct BodyStep {
  double h = 0;                 ///< s
  double end_time = 0;          ///< s
  const VectorX* x0 = nullptr;  ///< of particles, at its start
  VectorX x1;                   ///< of particles, at its end without contacts with bodies
  const VectorX* v0 = nullptr;  ///< of particles, at its start: for the flows of energy
  bool may_merge = false;       ///< the substep is short: bodies that still touch move as one
  bool keep_contacts = false;   ///< whether the result has them
};

struct BodyResult : ContactOutcome {
  BodiesState end;
  VectorX x1;                 ///< of particles, at the end
  VectorX velocity_change;    ///< of particles, m/s
  bool strains_gain = false;  ///< pushes store more in springs, cables and cloth than bodies lose: see SimulatedBodies
  BodyCounts counts;
  std::vector<BodyContact> contacts;  ///< with keep_contacts: those that push
};

class BodyResponse {
 public:
  BodyResponse(const Colliders& colliders, const System& system, const Settings& settings,
               const linear::Cancellation& cancel = linear::Cancellation::never());

  BodyResult step(const BodiesState& start, BodyStep step) const;

  /// The pairs that touch in a motion, each with its answer, and how many were asked.
  struct Touches {
    std::vector<std::pair<Pair, Answer>> found;
    std::uint64_t pairs = 0;
    LevelCounts levels;
    SeparationCounts separations;
  };
  /// Pairs that touch, or come within their separation, in a motion; the earliest first.
  Touches touches(const SceneMotion& motion) const { return touches(colliders_->body_candidates(motion, 0), motion); }

  double thickness() const noexcept { return thickness_; }

 private:
  class Attempt;
  Touches touches(const std::vector<Pair>& pairs, const SceneMotion& motion) const;

  const Colliders* colliders_;
  ContactSettings contact_;
  double time_step_;
  double thickness_;
  VectorX inverse_mass_, force_;  // of each coordinate of a particle; N: gravity and its own
  mutable PairSolver solver_;     // its memory
};

}  // namespace touchstone::sim
