// The cause for which a substep was not taken, and the remedy.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "sim/response.hpp"

namespace touchstone::sim {

enum class Cause : std::uint8_t {
  not_converged,  ///< Newton's method, or the step is not finite
  not_resolved,   ///< the response found no way
  gained_energy,  ///< energy would have come from nothing
  overstretched,  ///< cloth would have reached its limit of stretch
  not_certified,  ///< the proof found a crossing
  inaccurate,     ///< its error was above the scene's tolerance
  turns_too_far   ///< a body, in one substep
};

/// Substeps that were tried and not taken.
struct RefusedCounts {
  std::uint64_t not_converged = 0, not_resolved = 0, gained_energy = 0, overstretched = 0, not_certified = 0;
  std::uint64_t inaccurate = 0, turns_too_far = 0;
};

struct Refusal {
  Cause cause = Cause::not_converged;
  std::optional<Pair> pair;         ///< not resolved: one that is left in contact; not certified: the one that crosses
  Vector3 point = Vector3::Zero();  ///< m, where it touches
  LargestChange largest_change;     ///< not converged
  bool with_contacts = false;       ///< not converged: in the response, and not before it
  double excess = 0;                ///< inaccurate: the error over what the tolerance allows
};

void count(RefusedCounts& counts, Cause cause) noexcept;

/// "12 did not converge, 1 found no response": of the tries since `before`.
std::string refused_for_person(const RefusedCounts& counts, const RefusedCounts& before);

/// Where the pair of the contact touches, at these positions.
Vector3 contact_point(const Contact& contact, const VectorX& q);

/// The elements in the way, their position and a remedy, in one line.
std::string refusal_for_person(const Refusal& refusal, const Scene& scene, const System& system,
                               const Colliders& colliders, const VectorX& q);

}  // namespace touchstone::sim
