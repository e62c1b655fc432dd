// The cause for which a substep was not taken, and the remedy.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>

#include "sim/response.hpp"

namespace touchstone::sim {

/// Substeps that were tried and not taken, by cause.
using RefusedCounts = std::array<std::uint64_t, kCauses>;

/// "12 did not converge, 1 found no response": of the tries since `before`.
std::string refused_for_person(const RefusedCounts& counts, const RefusedCounts& before);

/// The elements in the way, their position and a remedy, in one line.
std::string refusal_for_person(const Refusal& refusal, const Scene& scene, const System& system,
                               const Colliders& colliders, const VectorX& q);

}  // namespace touchstone::sim
