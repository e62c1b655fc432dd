// One contact: its normal and weights, and the impulse that ends the approach.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/answer.hpp>

#include "contact/colliders.hpp"

namespace touchstone::sim {

/// Signed weights omega over the corners sum to zero: sum omega_i x_i is the vector from the touched point of the first
/// element to that of the second (edges), or from the second to the first (a point against something).
struct Contact {
  Pair pair;
  std::array<Index, 4> particles{};
  std::size_t corners = 0;
  std::array<double, 4> omega{};
  Vector3 normal = Vector3::Zero();  ///< of length 1, towards the side that sum omega_i x_i was on before
  double time = 0;                   ///< of the step, in [0, 1]; 0 for what was only close at its start
  double gap = 0;                    ///< m, along the normal, at the start of the step
};

/// The contact that `answer` reports for this pair. @param exact_weights  whether the answer has weights and not only
/// a time, as other people's solvers do
Contact contact_of(const Elements& elements, const Pair& pair, const VectorX& x0, const VectorX& x1,
                   const Answer& answer, bool exact_weights);

/// The same for two elements that are close at x0; the normal is along their shortest connection. False when they are
/// `thickness` apart or more.
bool proximity(const Elements& elements, const Pair& pair, const VectorX& x0, double thickness, Contact& contact);

/// What a response needs to know beside the positions.
struct ImpulseRule {
  double restitution = 0, friction = 0;
  double thickness = 0;  ///< m
  double rest = 0;       ///< m: an approach of no more than this in the step does not bounce
  double recovery = 0;   ///< share of a missing distance that is made good
};

/// A step's displacements, on which impulses act; over the step's length they are velocities.
struct Motion {
  const VectorX* x0 = nullptr;
  VectorX* x1 = nullptr;
  VectorX* pushed = nullptr;              ///< the part of x1 that is no velocity
  const VectorX* inverse_mass = nullptr;  ///< of each coordinate; 0 for what is held
  double* driven = nullptr;               ///< what is held and moves all the same gives by its impulses, kg m^2
};

/// Applies the corrected impulse when the elements approach: with K = sum omega_i^2 / m_i the normal velocity v_n
/// becomes -e v_n and the tangential one shrinks by at most mu |dv_n| (Bridson et al. 2002). Elements closer than the
/// thickness are then pushed apart a little, which adds no velocity. @returns whether x1 changed
bool resolve(const Contact& contact, const ImpulseRule& rule, const Motion& motion);

}  // namespace touchstone::sim
