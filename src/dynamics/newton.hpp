// The incremental potential of an implicit step, and its minimum by Newton's method.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>

#include "contact/contact_potential.hpp"
#include "rods/energy.hpp"
#include "linear/sparse_pattern.hpp"

namespace touchstone::sim {

/// One implicit stage: q = base + span v with v = base_velocity + span a(q). Its q is where the derivative vanishes of
///   1/2 |q - base - span base_velocity|^2_M / span^2 + drag / (2 span) |q - base|^2_M - force . q + energy(q).
struct Stage {
  VectorX base, base_velocity;
  double span = 0;                        ///< s
  double time = 0;                        ///< at its end, s
  Strains strains;                        ///< with the damping of this span
  std::span<const ContactTerm> contacts;  ///< relative to base
  double tolerance = 0;                   ///< m/s; 0: the settings' one
};

/// What changed most in the last iteration.
struct Mover {
  Eigen::Index coordinate = -1;  ///< -1: there was none
  double speed = 0;              ///< m/s or rad/s
};

struct NewtonResult {
  bool converged = false;
  int iterations = 0;
  int convex = 0;        ///< iterations whose exact second derivatives were not positive definite
  double last_step = 0;  ///< m/s: the largest change in the last iteration, as a velocity
  Mover mover;           ///< when it did not converge
};

class NewtonMatrix;

class Newton {
 public:
  Newton(const System& system, const Settings& settings, linear::PatternCache& patterns);
  ~Newton();
  Newton(const Newton&) = delete;
  Newton& operator=(const Newton&) = delete;

  /// `q` and `frames` belong together; `guess` says where to begin, its prescribed coordinates where they end. They are
  /// the solution when the result says that it converged, and of no use otherwise.
  NewtonResult minimise(const Stage& stage, const VectorX& guess, VectorX& q, Frames& frames);

 private:
  struct Place;
  struct Excursion;
  struct Potential {
    double value = 0;
    double noise = 0;  ///< how much of it may be rounding
  };
  /// A place along the line that is searched.
  struct Trial {
    double share = 0;  ///< of the direction
    VectorX q;
    Frames frames;
    Potential potential;
  };
  Potential potential(const Stage& stage, const VectorX& q, const Frames& frames) const;
  /// Where the potential is lower: at the guess, or where nothing has moved but what must.
  Place start(const Stage& stage, const VectorX& guess, const VectorX& q, const Frames& frames) const;
  NewtonResult descend(const Stage& stage, Place& here);

  const System* system_;
  Energy energy_;
  double drag_, tolerance_;
  std::unique_ptr<NewtonMatrix> matrix_;
};

}  // namespace touchstone::sim
