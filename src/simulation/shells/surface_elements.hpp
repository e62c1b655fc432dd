// The elements of a surface of cloth: a membrane for each triangle, and a hinge for each edge that two triangles share.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "shells/hinge.hpp"
#include "shells/membrane.hpp"

namespace touchstone::sim {

struct SurfaceElements {
  std::vector<Membrane> membranes;
  std::vector<Hinge> hinges;
};

/// Appends the elements of a checked surface, and adds its mass to that of its particles.
/// @param placed  positions at rest, of all particles
void append_elements(const Surface& surface, const std::vector<Vector3>& placed, std::vector<double>& particle_mass,
                     SurfaceElements& elements);

}  // namespace touchstone::sim
