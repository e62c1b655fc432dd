// Touchstone's drop-in for Tight-Inclusion: numbers and vectors.
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <tight_inclusion/config.hpp>

namespace ticcd {

using Scalar = double;                        ///< coordinates, times and distances
using Vector3 = Eigen::Matrix<Scalar, 3, 1>;  ///< a position
using Array3 = Eigen::Array<Scalar, 3, 1>;    ///< one number for each axis, or for each of t, u and v

}  // namespace ticcd
