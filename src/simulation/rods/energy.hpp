// Stored energy of a system and its derivatives, element by element.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "rods/system.hpp"

namespace touchstone::sim {

/// Takes the second derivatives of the elements.
class BlockSink {
 public:
  virtual void stretch(std::size_t element, const Eigen::Matrix3d& block) = 0;  ///< [block -block; -block block]
  virtual void joint(std::size_t element, const JointMatrix& block) = 0;
  virtual void membrane(std::size_t element, const MembraneMatrix& block) = 0;
  virtual void hinge(std::size_t element, const HingeMatrix& block) = 0;

 protected:
  ~BlockSink() = default;
};

/// J, by kind. Potential energies of gravity and of the particles' forces are zero at the origin.
struct Energies {
  double kinetic = 0, stretch = 0, bend = 0, twist = 0, load = 0;
  double total() const noexcept { return kinetic + stretch + bend + twist + load; }
};

/// Stiffness and rest of every strain: those of the scene, or with damping folded in. A strain s with damping c that
/// was s0 a time `span` ago has the incremental potential 1/2 k (s - rest)^2 + c / (2 span) (s - s0)^2. The sum is one
/// parabola again.
struct Strains {
  VectorX stiffness, rest;
  bool with_limits = true;  ///< of stretch, which have an energy beside these parabolas
};

/// The second derivatives as they are, or projected: without their terms that may be negative.
enum class Hessian : std::uint8_t { exact, projected };

class Energy {
 public:
  explicit Energy(const System& system) : system_(&system) {}

  Strains elastic() const;
  /// @param base  strains at the beginning of the span  @param span  s
  Strains damped(const VectorX& base, double span) const;

  /// The damping of each strain: its damping force is -c ds/dt grad s.
  VectorX damping() const;

  /// All strains: the lengths of stretch elements, then kappa1, kappa2 and twist of each joint, then
  /// three of each membrane, and the bend of each hinge.
  VectorX strains(const VectorX& q, const Frames& frames, double time) const;

  /// The rates of the strains for velocities v, with frames that are carried along, and the twist that is inserted.
  VectorX strain_rates(const VectorX& q, const VectorX& v, const Frames& frames, double time) const;

  /// The sum of 1/2 stiffness (strain - rest)^2 and of the limits of stretch. Not finite where an edge or triangle
  /// folds onto its neighbour, or a limit is reached.
  double value(const VectorX& q, const Frames& frames, double time, const Strains& strains) const;

  /// Adds to `gradient`, and gives the second derivatives to `sink` unless it is null.
  /// @param tensions  N, of each stretch element: its resistance to turning in the second derivatives; null: its stress
  void derivatives(const VectorX& q, const Frames& frames, double time, const Strains& strains, Hessian hessian,
                   VectorX& gradient, BlockSink* sink, const VectorX* tensions = nullptr) const;

  /// The tension of each stretch element after q changes by `step`, to first order, N.
  VectorX tensions_after(const VectorX& q, const Strains& strains, const VectorX& step) const;

 private:
  VectorX elastic_stiffness() const;
  const System* system_;
};

}  // namespace touchstone::sim
