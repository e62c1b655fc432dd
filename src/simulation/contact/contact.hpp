// One contact: its normal and weights, and the impulse that ends the approach.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/answer.hpp>

#include "contact/colliders.hpp"

namespace touchstone::sim {

/// The signed weights omega of the corners sum to zero. The vector sum omega_i x_i leads from the touched point of the
/// first element to that of the second for two edges, and from the second to the first for a point and an element.
struct Contact {
  Pair pair;
  std::array<Index, 4> particles{};
  std::size_t corners = 0;
  std::array<double, 4> omega{};
  Vector3 normal = Vector3::Zero();  ///< of length 1, towards the side that sum omega_i x_i was on before
  double time = 0;                   ///< in [0, 1], the substep; 0 for elements that were only close at its start
  double gap = 0;                    ///< m, along the normal, at the start of the substep, beyond the pair's separation
};

/// The contact that `answer` reports for this pair.
/// @param exact_weights  whether the answer has weights; those of the baselines have only a time
Contact contact_of(const Colliders& colliders, const Pair& pair, const VectorX& x0, const VectorX& x1,
                   const Answer& answer, bool exact_weights);

/// The same for two elements that are close at x0; the normal is along their shortest connection. False when their
/// distance exceeds their separation by `thickness` or more, or they touch.
bool proximity(const Colliders& colliders, const Pair& pair, const VectorX& x0, double thickness, Contact& contact);

/// Where the pair of the contact touches, at these positions.
Vector3 contact_point(const Contact& contact, const VectorX& q);

/// How impulses answer a contact in one substep.
struct ImpulseRule {
  double restitution = 0, friction = 0;
  double thickness = 0;  ///< m
  double rest = 0;       ///< m: an approach of no more than this in the substep does not bounce
  double recovery = 0;   ///< fraction of a missing distance that one impulse corrects
};

/// The impulses of a substep's contacts on each coordinate of a particle, held ones included, times the substep's
/// length: kg m.
struct ContactImpulses {
  VectorX normal, friction;

  /// All 0, for so many coordinates.
  void reset(Eigen::Index size) { normal = friction = VectorX::Zero(size); }

  /// @param impulse  on the second element of two, or on a point against an element
  static void add(const Contact& contact, const Vector3& impulse, VectorX& to) {
    for (std::size_t c = 0; c < contact.corners; ++c) {
      to.segment<3>(3 * static_cast<Eigen::Index>(contact.particles[c])) += contact.omega[c] * impulse;
    }
  }
};

/// The displacements of a substep, on which impulses act. Divided by its length they are velocities.
struct Displacements {
  const VectorX* x0 = nullptr;
  VectorX* x1 = nullptr;
  VectorX* correction = nullptr;          ///< the position corrections in x1, which are no velocity
  const VectorX* inverse_mass = nullptr;  ///< of each coordinate; 0 where it is held
  double* driven = nullptr;               ///< work of driven particles by impulses, times h^2, kg m^2; may be null
  ContactImpulses* impulses = nullptr;    ///< to which they are added; may be null
};

/// Applies the corrected impulse when the elements approach: with K = sum omega_i^2 / m_i the normal velocity v_n
/// becomes -e v_n and the tangential one shrinks by at most mu |dv_n| (Bridson et al. 2002). Elements closer than the
/// thickness then get a position correction, which adds no velocity. @returns whether x1 changed
bool apply_impulse(const Contact& contact, const ImpulseRule& rule, const Displacements& motion);

}  // namespace touchstone::sim
