// What the last columns of the table of energies follow: a particle, a body, or a vertex of a body.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/simulation.hpp"

namespace touchstone::sim {

/// A body as a whole is followed by its centre of mass and its orientation; one that is not free by its origin.
struct Followed {
  std::optional<Index> particle, body, vertex;  ///< a vertex only with its body

  bool operator==(const Followed&) const = default;
};

/// Reads "12", a particle; "body:3"; or "body:3:7", its vertex 7. Nothing for other texts.
std::optional<Followed> followed_from(const std::string& text);

/// Why the scene has nothing of this number; empty if it has.
std::string missing_in(const Scene& scene, const Followed& followed);

/// The names of its columns, each after a comma: x, y and z, and of a whole body its quaternion qw, qx, qy and qz.
std::string header_of(const Followed& followed);

/// m, and of the two quaternions of an orientation that whose first coordinate other than 0 is positive.
std::vector<double> values_of(const Simulation& simulation, const Followed& followed);

}  // namespace touchstone::sim
