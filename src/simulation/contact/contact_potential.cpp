// SPDX-License-Identifier: MIT
#include "contact/contact_potential.hpp"

#include <algorithm>

#include "scene/features.hpp"

namespace touchstone::sim {
namespace {

/// The slip u_T and, with f the smoothed |u_T|: ratio = f' / |u_T|, and bend = the derivative of 1 / ratio, in [0, 1].
struct Slip {
  Vector3 across;
  double length, ratio, bend;

  Slip(const ContactTerm& term, const VectorX& x0, const VectorX& x) {
    const Vector3 u = relative_motion(term, x0, x);
    across = u - term.normal.dot(u) * term.normal;
    length = across.norm();
    const double e = term.stick;
    ratio = length < e ? (2 - length / e) / e : 1 / length;
    bend = length < e ? 1 / ((2 - length / e) * (2 - length / e)) : 1;
  }

  Vector3 direction() const { return length > 0 ? Vector3(across / length) : Vector3::Zero(); }
};

}  // namespace

Vector3 relative_motion(const ContactTerm& term, const VectorX& x) {
  Vector3 u = Vector3::Zero();
  for (std::size_t c = 0; c < term.corners; ++c) u += term.omega[c] * position(x, term.particles[c]);
  return u;
}

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
  if (kFriction && term.slip > 0) {
    const double y = (u - along * term.normal).norm(), e = term.stick;
    value += term.slip * (y < e ? y * y / e - y * y * y / (3 * e * e) + e / 3 : y);
  }
  return value;
}

Vector3 friction_pull(const ContactTerm& term, const VectorX& x0, const VectorX& x) {
  const Slip slip(term, x0, x);
  return slip.ratio * slip.across;
}

ContactDerivatives contact_derivatives(const ContactTerm& term, const VectorX& x0, const VectorX& x,
                                       const Vector3& pull) {
  const Vector3& n = term.normal;
  const double along = n.dot(relative_motion(term, x0, x));
  ContactDerivatives d{Vector3::Zero(), Eigen::Matrix3d::Zero()};
  if (along < term.goal) {
    d.gradient = term.stiffness * (along - term.goal) * n;
    d.hessian = term.stiffness * n * n.transpose();
  }
  if (kFriction && term.slip > 0) {
    const Slip slip(term, x0, x);
    d.gradient += term.slip * slip.ratio * slip.across;
    const Vector3 bent = 0.5 * slip.bend * slip.ratio * pull;
    const Vector3 t = slip.direction();
    d.hessian += term.slip * (slip.ratio * (Eigen::Matrix3d::Identity() - n * n.transpose()) - bent * t.transpose() -
                              t * bent.transpose());
  }
  return d;
}

Vector3 next_pull(const ContactTerm& term, const VectorX& x0, const VectorX& x, const Vector3& pull, const Vector3& du,
                  double step_length) {
  const Slip slip(term, x0, x);
  const Vector3 moved = du - term.normal.dot(du) * term.normal;
  const Vector3 whole = slip.ratio * (slip.across + moved - slip.bend * slip.direction().dot(moved) * pull);
  const Vector3 next = pull + step_length * (whole - pull);
  return next / std::max(1.0, next.norm());
}

}  // namespace touchstone::sim
