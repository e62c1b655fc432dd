// The strains of cloth among those of a system, and their energy.
// SPDX-License-Identifier: MIT
#pragma once

#include "rods/energy.hpp"

namespace touchstone::sim {

/// Calls row_of(row, stiffness, rest, damping) for each strain of cloth.
template <class RowOf>
void for_each_cloth_strain(const System& system, RowOf row_of) {
  for (std::size_t m = 0; m < system.cloth.membranes.size(); ++m) {
    const Membrane& membrane = system.cloth.membranes[m];
    for (std::size_t k = 0; k < 3; ++k) {
      row_of(static_cast<Eigen::Index>(system.membrane_row(m) + k), membrane.stiffness[k], 0.0, membrane.damping);
    }
  }
  for (std::size_t h = 0; h < system.cloth.hinges.size(); ++h) {
    const Hinge& hinge = system.cloth.hinges[h];
    row_of(static_cast<Eigen::Index>(system.hinge_row(h)), hinge.stiffness, hinge.rest, hinge.damping);
  }
}

/// Sets the strains of cloth in `strains`.
void measure_cloth(const System& system, const VectorX& q, VectorX& strains);

/// Sets the rates of these strains for velocities v.
void measure_cloth_rates(const System& system, const VectorX& q, const VectorX& v, VectorX& rates);

/// The energy of the limits of stretch at these strains, J; infinite where one is reached.
double stretch_limit_energy(const System& system, const VectorX& strains);

/// As Energy::derivatives, of the cloth alone.
void cloth_derivatives(const System& system, const VectorX& q, const Strains& strains, Hessian hessian,
                       VectorX& gradient, BlockSink* sink);

/// Whether each triangle's principal stretches are below its limit.
bool within_stretch_limits(const System& system, const VectorX& q);

}  // namespace touchstone::sim
