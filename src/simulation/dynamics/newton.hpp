// The incremental potential of an implicit step, and its minimum by Newton's method.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>

#include "contact/contact_potential.hpp"
#include "contact/outcome.hpp"
#include "linear/cancellation.hpp"
#include "linear/sparse_pattern.hpp"
#include "rods/energy.hpp"

namespace touchstone::sim {

/// One implicit stage: q = base + span v with v = base_velocity + span a(q). Its q is where the derivative vanishes of
///   1/2 |q - base - span base_velocity|^2_M / span^2 + drag / (2 span) |q - base|^2_M - force . q + energy(q).
struct Stage {
  VectorX base, base_velocity;
  double span = 0;                        ///< s
  double time = 0;                        ///< at its end, s
  Strains strains;                        ///< with the damping of this span
  std::span<const ContactTerm> contacts;  ///< relative to base
  double tolerance = 0;                   ///< m/s; 0: the tolerance of the settings
};

struct NewtonResult {
  bool converged = false;
  int iterations = 0;
  int projected = 0;             ///< iterations with the projected Hessian, as the exact one was not positive definite
  double last_step = 0;          ///< m/s: the largest change in the last iteration, as a velocity
  LargestChange largest_change;  ///< when it did not converge
};

class NewtonMatrix;

class Newton {
 public:
  /// @param cancel  is checked in each iteration, and lives as long as this
  Newton(const System& system, const Settings& settings, linear::PatternCache& patterns,
         const linear::Cancellation& cancel = linear::Cancellation::never());
  ~Newton();
  Newton(const Newton&) = delete;
  Newton& operator=(const Newton&) = delete;

  /// `q` and `frames` belong together; `guess` is the first iterate, with the prescribed coordinates at their ends.
  /// They are the solution when the result says that it converged, and of no use otherwise.
  NewtonResult minimise(const Stage& stage, const VectorX& guess, VectorX& q, Frames& frames);

 private:
  class Descent;

  const System* system_;
  Energy energy_;
  double drag_, tolerance_;
  const linear::Cancellation* cancel_;
  std::unique_ptr<NewtonMatrix> matrix_;
};

}  // namespace touchstone::sim
