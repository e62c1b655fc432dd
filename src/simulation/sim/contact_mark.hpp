// Where a substep's response saw a contact.
// SPDX-License-Identifier: MIT
#pragma once

#include "contact/colliders.hpp"

namespace touchstone::sim {

struct ContactMark {
  Pair pair;
  /// True: the pair would have touched in a motion that was tried. False: it was closer than the thickness at the
  /// start.
  bool touches = false;
  double time = 0;                  ///< in [0, 1], of the substep: of the touch
  Vector3 point = Vector3::Zero();  ///< m: on the first element, at the end of the substep
};

}  // namespace touchstone::sim
