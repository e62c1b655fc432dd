// The box of a point of a body during a step, to the last bit as docs/proofs.md defines it.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/curved_query.hpp>

namespace touchstone::proofs {

struct PointBox {
  Vec3 low, high;
};

/// Around the quotients of the Bernstein coefficients of the numerators and of |q|^2, rounded outwards to doubles.
/// @throws Error  when a coefficient of |q|^2 is not positive, as it is for quaternions with q0 . q1 >= 0, or when a
/// bound is beyond the doubles
PointBox box_on_body(const RigidMotion& motion, const Vec3& point);

}  // namespace touchstone::proofs
