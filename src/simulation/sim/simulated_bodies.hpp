// The bodies of a simulation, beside its particles: their state, their response, and what a run says about them.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "body_contact/body_response.hpp"
#include "dynamics/state.hpp"
#include "sim/refusal.hpp"

namespace touchstone::sim {

class SimulatedBodies {
 public:
  SimulatedBodies(const Scene& scene, const System& system, const Colliders& colliders,
                  const linear::Cancellation& cancel);

  const BodySystem& system() const noexcept { return colliders_->bodies(); }
  const BodiesState& state() const noexcept { return state_; }
  double thickness() const noexcept { return response_.thickness(); }
  Energies energies() const { return system().energies(state_.bodies); }

  /// The results of steps have their contacts from now on.
  void keep_contacts() noexcept { keeps_contacts_ = true; }

  /// @throws Error when an element of a body touches another one
  void check_start(const BodiesState& bodies, const VectorX& q, std::string_view what) const;

  /// Moves on by h seconds, from these particles to `next`, which it changes where bodies push them. The state is that
  /// at the end only after `take`.
  BodyResult step(const State& start, double h, double end_time, bool may_merge, const System& system,
                  State& next) const;

  void take(BodiesState state) { state_ = std::move(state); }

  /// @throws Error by the keys of a checkpoint, for a state that no run comes to
  void check_state(const BodiesState& state, double time) const;

 private:
  const Colliders* colliders_;
  BodyResponse response_;
  BodiesState state_;
  bool keeps_contacts_ = false;
};

}  // namespace touchstone::sim
