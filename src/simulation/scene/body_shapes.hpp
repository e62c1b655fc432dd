// Shapes of bodies of which several shipped scenes are built.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.hpp"

namespace touchstone::sim {

/// A mesh of twelve faces around the origin, with its sides along the axes. @param density  kg/m^3
Body box(const Vector3& size, double density);

/// The body as one that never moves, without mass. Its position is that of its origin.
Body fixed(Body body, const Vector3& position = Vector3::Zero());

}  // namespace touchstone::sim
