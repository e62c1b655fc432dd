// SPDX-License-Identifier: MIT
#include "sim/contact_potential.hpp"

#include <algorithm>

namespace touchstone::sim {

Vector3 relative_motion(const ContactTerm& term, const VectorX& x0, const VectorX& x) {
  Vector3 u = Vector3::Zero();
  for (std::size_t c = 0; c < term.corners; ++c) {
    u += term.omega[c] * (position(x, term.particles[c]) - position(x0, term.particles[c]));
  }
  return u;
}

double normal_force(const ContactTerm& term, const VectorX& x0, const VectorX& x) {
  return term.stiffness * std::max(0.0, term.goal - term.normal.dot(relative_motion(term, x0, x)));
}

double contact_value(const ContactTerm& term, const VectorX& x0, const VectorX& x) {
  const Vector3 u = relative_motion(term, x0, x);
  const double along = term.normal.dot(u), missing = std::max(0.0, term.goal - along);
  double value = 0.5 * term.stiffness * missing * missing;
  if (term.slip > 0) {
    const double y = (u - along * term.normal).norm(), e = term.stick;
    value += term.slip * (y < e ? y * y / e - y * y * y / (3 * e * e) + e / 3 : y);
  }
  return value;
}

ContactDerivatives contact_derivatives(const ContactTerm& term, const VectorX& x0, const VectorX& x) {
  const Vector3& n = term.normal;
  const Vector3 u = relative_motion(term, x0, x);
  const double along = n.dot(u);
  ContactDerivatives d{Vector3::Zero(), Eigen::Matrix3d::Zero()};
  if (along < term.goal) {
    d.gradient = term.stiffness * (along - term.goal) * n;
    d.hessian = term.stiffness * n * n.transpose();
  }
  if (term.slip > 0) {
    const Vector3 across = u - along * n;
    const double y = across.norm(), e = term.stick;
    const Eigen::Matrix3d plane = Eigen::Matrix3d::Identity() - n * n.transpose();
    // slope / y, and the second derivative along the slip.
    const double ratio = y < e ? 2 / e - y / (e * e) : 1 / y;
    d.gradient += term.slip * ratio * across;
    if (y > 0) {
      const Vector3 t = across / y;
      const double second = y < e ? 2 / e - 2 * y / (e * e) : 0;
      d.hessian += term.slip * (ratio * (plane - t * t.transpose()) + second * t * t.transpose());
    } else {
      d.hessian += term.slip * ratio * plane;
    }
  }
  return d;
}

}  // namespace touchstone::sim
