// Where two elements are nearest to each other, one of a body at least, as a contact for the response. In doubles: what
// is proved does not depend on it.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <touchstone/answer.hpp>

#include "contact/colliders.hpp"

namespace touchstone::sim {

/// The point of an element that is in contact: it moves with its body, or with its particles by their weights.
struct ContactSide {
  Index body = 0;                 ///< where it is one
  Vector3 arm = Vector3::Zero();  ///< from the body's origin to where impulses act, in the world's frame
  std::array<Index, 3> particles{};
  std::array<double, 3> weights{};
  std::size_t count = 0;  ///< of particles; 0 for a body

  bool is_body() const noexcept { return count == 0; }
};

struct BodyContact {
  Pair pair;
  ContactSide a, b;
  Vector3 normal = Vector3::Zero();  ///< of length 1, from b to a
  Vector3 point = Vector3::Zero();   ///< of b
  double gap = 0;                    ///< m, at the start of the substep: the distance less the separation
  bool at_touch = false;             ///< found where the exact solver says that they touch
};

/// The closest points at the start, when their gap is less than `reach` and no neighbours of the elements are nearer
/// still: those have contacts of their own.
std::optional<BodyContact> closest(const Colliders& colliders, const Pair& pair, const SceneMotion& motion,
                                   double reach);

/// Where the pair touches by the exact answer. The gap is not set.
BodyContact touching(const Colliders& colliders, const Pair& pair, const SceneMotion& motion, const Answer& answer);

}  // namespace touchstone::sim
