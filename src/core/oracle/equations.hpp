// The polynomials whose signs say whether two elements touch.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "oracle/motion.hpp"

namespace touchstone::oracle {

/// Twice the signed area of the triangle P Q R seen along a coordinate axis: the 3 x 3 determinant with rows
/// (1, P_i, P_j), (1, Q_i, Q_j), (1, R_i, R_j). Degree at most 2.
Polynomial orientation(std::size_t axis, const Corner& P, const Corner& Q, const Corner& R);

/// All of these vanish whenever the elements touch: V of an edge-edge or vertex-face query as a 4 x 4 determinant
/// (six times the signed volume), the three areas of point and edge, the three differences of two points.
std::vector<Polynomial> contact_equations(Kind kind, const Corners& corners);

/// Polynomials such that, while the contact equations hold, `touch` looks at no other signs to decide whether the
/// elements touch: between neighbouring roots of these nothing changes.
std::vector<Polynomial> deciding_polynomials(Kind kind, const Corners& corners);

}  // namespace touchstone::oracle
