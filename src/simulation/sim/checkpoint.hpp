// The state of a run as a file, from which it goes on as if it had never stopped, to the last bit.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "sim/simulation.hpp"

namespace touchstone::sim {

struct Checkpoint {
  Scene scene;
  std::uint64_t steps = 0;
  State state;
  BodiesState bodies;
};

/// Scene and state; numbers of the state are C hexfloats. The text carries a digest of itself (io/sealed_json.hpp).
std::string checkpoint_to_json(const Simulation& simulation);

/// @throws Error when the digest does not match the text, and naming the key that is missing or makes no sense
Checkpoint checkpoint_from_json(std::string_view text);

}  // namespace touchstone::sim
