// Positions and velocities of a system at one time.
// SPDX-License-Identifier: MIT
#pragma once

#include "rods/system.hpp"

namespace touchstone::sim {

struct State {
  double time = 0;  ///< s
  VectorX q, v;     ///< m and m/s; rad and rad/s for angles
  Frames frames;    ///< of q
};

}  // namespace touchstone::sim
