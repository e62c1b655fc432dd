// The pairs and times that a run says nothing about.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "sim/simulation.hpp"

namespace touchstone::sim {

/// "from 0 s to 10 s, with no intersection at the start: 613 edges, 202 faces and 2 bodies". @param steps  of this run
std::string checked_for_person(const Simulation& simulation, std::uint64_t steps);

/// For the end of the verdict's line: "", or "; left out: 1 particle and 12 springs that do not collide", or
/// "; warning: nothing that collides can move, so no pair was asked about". @param steps  of this run
std::string left_out_for_person(const Simulation& simulation, std::uint64_t steps);

}  // namespace touchstone::sim
