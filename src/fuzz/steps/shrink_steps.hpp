// Makes a failing step of a mesh readable: few elements, vertices that stand still, small integers.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>

#include "families/step_scenes.hpp"

namespace touchstone::fuzz {

/// A smaller number is easier to read. An element weighs more than any number.
std::int64_t difficulty(const families::StepScene& scene);

/// A simpler scene for which `still_fails` holds, or `scene` itself. `still_fails` may throw InvalidQuery or
/// InvalidMesh for a scene without meaning, which then does not fail.
/// @param stop  called before each try; true ends the shrinking
families::StepScene shrink_steps(const families::StepScene& scene,
                                 const std::function<bool(const families::StepScene&)>& still_fails,
                                 const std::function<bool()>& stop = {});

}  // namespace touchstone::fuzz
