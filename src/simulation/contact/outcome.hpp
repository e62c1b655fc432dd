// What became of a substep whose contacts were answered.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "contact/colliders.hpp"
#include "contact/phase_times.hpp"

namespace touchstone::sim {

/// Why a substep was not taken.
enum class Cause : std::uint8_t {
  not_converged,  ///< Newton's method, or the step is not finite
  not_resolved,   ///< the response found no way
  gained_energy,  ///< energy would have come from nothing
  overstretched,  ///< cloth would have reached its limit of stretch
  not_certified,  ///< the proof found a crossing
  inaccurate,     ///< its error was above the scene's tolerance
  turns_too_far   ///< a body, in one substep
};
constexpr std::size_t kCauses = 7;

/// The coordinate that changed most in the last iteration of Newton's method, and how fast.
struct LargestChange {
  Eigen::Index coordinate = -1;  ///< -1: there was none
  double speed = 0;              ///< m/s or rad/s
};

struct Refusal {
  Cause cause = Cause::not_converged;
  std::optional<Pair> pair = {};      ///< not resolved: one that is left; not certified: the one that crosses
  Vector3 point = Vector3::Zero();    ///< m, where it touches
  LargestChange largest_change = {};  ///< not converged
  bool with_contacts = false;         ///< not converged: in the response, and not before it
  double excess = 0;                  ///< inaccurate: the error over what the tolerance allows
};

/// J, by the force: positive where it gives energy to the system, negative where it takes energy away. What a substep
/// gains beyond the sum is the gain of its integrator.
struct EnergyFlows {
  double driven = 0;       ///< of driven coordinates and bodies, and of the twist that is inserted into a ring
  double drag = 0;         ///< of the settings
  double damping = 0;      ///< of springs and cables
  double friction = 0;     ///< of contacts, as the next two
  double impacts = 0;      ///< of the forces along the normals
  double corrections = 0;  ///< of position corrections

  double total() const noexcept { return driven + drag + damping + friction + impacts + corrections; }
  EnergyFlows& operator+=(const EnergyFlows& other) noexcept {
    driven += other.driven;
    drag += other.drag;
    damping += other.damping;
    friction += other.friction;
    impacts += other.impacts;
    corrections += other.corrections;
    return *this;
  }
};

/// Of particles or of bodies.
struct ContactOutcome {
  std::optional<Refusal> refused;  ///< the substep must be shorter, or should be where energy was gained
  EnergyFlows flows;               ///< of the substep, when they are measured
  PhaseTimes times;                ///< of the response
};

}  // namespace touchstone::sim
