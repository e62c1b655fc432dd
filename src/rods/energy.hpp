// Stored energy of a system and its derivatives, element by element.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "rods/system.hpp"

namespace touchstone::sim {

/// Takes the second derivatives of the elements.
class BlockSink {
 public:
  virtual void length(std::size_t element, const Eigen::Matrix3d& block) = 0;  ///< [block -block; -block block]
  virtual void joint(std::size_t element, const JointMatrix& block) = 0;

 protected:
  ~BlockSink() = default;
};

/// Stiffness and rest of every strain: of the scene, or with damping folded in. A strain s that is damped with c and
/// was s0 a time `span` ago has the incremental potential 1/2 k (s - rest)^2 + c / (2 span) (s - s0)^2, which is one
/// parabola.
struct Strains {
  VectorX stiffness, rest;
};

/// How second derivatives are made: as they are, or without the parts that may be negative.
enum class Curvature : std::uint8_t { exact, convex };

class Energy {
 public:
  explicit Energy(const System& system) : system_(&system) {}

  Strains elastic() const;
  /// @param base  strains at the beginning of the span  @param span  s
  Strains damped(const VectorX& base, double span) const;

  /// All strains: lengths, then kappa1, kappa2 and twist of each joint.
  VectorX strains(const VectorX& q, const Frames& frames, double time) const;

  /// Their rates for velocities v (frames as they are carried along).
  VectorX strain_rates(const VectorX& q, const VectorX& v, const Frames& frames, double time) const;

  /// The sum of 1/2 stiffness (strain - rest)^2. Not finite where an edge folds onto its neighbour.
  double value(const VectorX& q, const Frames& frames, double time, const Strains& strains) const;

  /// Adds to `gradient`, and gives the second derivatives to `sink` unless it is null.
  /// @param tensions  N, of each length: what its turning resists in the second derivatives; null: the stress it has
  void derivatives(const VectorX& q, const Frames& frames, double time, const Strains& strains, Curvature curvature,
                   VectorX& gradient, BlockSink* sink, const VectorX* tensions = nullptr) const;

  /// What the tension of each length becomes, to first order, when q changes by `step`, N.
  VectorX tensions_after(const VectorX& q, const Strains& strains, const VectorX& step) const;

 private:
  VectorX elastic_stiffness() const;
  const System* system_;
};

}  // namespace touchstone::sim
