// Whether a surface of cloth makes sense.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.hpp"

namespace touchstone::sim {

/// @throws Error naming the key of scene.surfaces[number] that is wrong
void check_surface(const Scene& scene, std::size_t number);

}  // namespace touchstone::sim
