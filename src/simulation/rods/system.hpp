// The system of the integrators: generalised coordinates, masses, and the elements that store energy.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "rods/frames.hpp"
#include "rods/joint.hpp"
#include "scene/scene.hpp"
#include "shells/surface_elements.hpp"

namespace touchstone::sim {

using VectorX = Eigen::VectorXd;

/// A spring, or the stretching of a segment of a cable: 1/2 stiffness (|x_b - x_a| - rest)^2.
struct StretchElement {
  Index a = 0, b = 0;
  double stiffness = 0, damping = 0, rest = 0;
  bool cable = false;
};

/// A segment of a cable that bends: it has one tangent and one material frame.
struct RodEdge {
  Index a = 0, b = 0;
  bool twists = false;
};

/// Where two rod edges e and f meet, in particle p[1]. Bending is 1/2 bend |kappa - rest|^2, torsion 1/2 twist m^2.
struct Joint {
  std::array<Index, 3> p{};
  Index e = 0, f = 0;
  double bend = 0, twist = 0;  ///< E I and G J over the length that belongs to the joint, N m
  double damping = 0;          ///< s
  std::array<double, 2> rest{};
  double closing_rate = 0, closing_until = 0;  ///< rad/s and s: a ring's inserted twist
};

/// Prescribed angle of a clamped end's frame.
struct DrivenAngle {
  Index edge = 0;
  double rate = 0, until = 0;
};

/// Numbers of some of a system's elements, and of all particles and edges that these refer to.
struct SystemSubset {
  std::vector<Index> particles, edges, stretch_elements, joints, membranes, hinges;
};

/// Coordinates q: three for each particle, then an angle for each rod edge.
class System {
 public:
  explicit System(const Scene& scene);

  /// A system of these elements alone, in this order. It has all that Newton's method asks for; it has no paths and no
  /// initial values.
  /// @param local_particle, local_edge  the number of each particle and edge in the subset
  System subset(const SystemSubset& members, const std::vector<Index>& local_particle,
                const std::vector<Index>& local_edge) const;

  std::size_t particle_count() const noexcept { return particle_count_; }
  Eigen::Index size() const noexcept { return static_cast<Eigen::Index>(3 * particle_count_ + edges.size()); }
  Eigen::Index angle(Index edge) const noexcept { return static_cast<Eigen::Index>(3 * particle_count_ + edge); }
  std::size_t strain_count() const noexcept { return hinge_row(cloth.hinges.size()); }
  // Of strains: the first of an element, in the order of Energy::strains.
  std::size_t joint_row(std::size_t joint) const noexcept { return stretch_elements.size() + 3 * joint; }
  std::size_t membrane_row(std::size_t membrane) const noexcept { return joint_row(joints.size()) + 3 * membrane; }
  std::size_t hinge_row(std::size_t hinge) const noexcept { return membrane_row(cloth.membranes.size()) + hinge; }

  /// Sets the coordinates that are prescribed at this time: driven particles and driven angles.
  void prescribe(double time, VectorX& q) const;

  /// Curvature and twist of one of `joints`. The twist that is inserted into a ring depends on the time.
  JointStrain joint_strain(const Joint& joint, const VectorX& q, const Frames& frames, double time) const;

  /// Reference frames for `q` at the start of a run: without twist between neighbours, except where a ring closes.
  Frames initial_frames(const VectorX& q) const;

  /// `frames` of `from`, carried along to `to`.
  Frames transported(const Frames& frames, const VectorX& from, const VectorX& to) const;

  std::vector<StretchElement> stretch_elements;
  std::vector<RodEdge> edges;
  std::vector<Joint> joints;
  SurfaceElements cloth;
  std::vector<DrivenAngle> driven_angles;
  VectorX mass;             ///< of each coordinate: kg, and kg m^2 for angles
  VectorX force;            ///< constant: gravity and the particles' own, N
  std::vector<char> fixed;  ///< of each coordinate; not solved for
  VectorX initial_position, initial_velocity;
  std::vector<Index> ghosts;  ///< particles that only hold a clamped end's direction; they do not collide

 private:
  /// A ghost whose clamped end is driven. It follows the end, so that the direction stays.
  struct Follower {
    Index ghost = 0, leader = 0;
    Vector3 offset;
  };

  System() = default;
  void add_cable(const Cable& cable);
  void add_clamp(const Cable& cable, const CableEnd& end, bool at_start, Index edge);
  void add_joint(const Cable& cable, Index e, Index f, double fraction);

  std::size_t particle_count_ = 0;
  std::vector<std::pair<Index, std::vector<Waypoint>>> paths_;  // of driven particles
  std::vector<Follower> followers_;
  // Used by the constructor only:
  std::vector<Vector3> placed_;  // initial positions, ghosts included
  std::vector<double> particle_mass_;
  std::vector<double> inertia_;                // by edge
  std::vector<double> length_;                 // by edge: at rest
  std::vector<Index> bent_;                    // joints whose bends at rest are the initial ones
  std::vector<std::pair<Index, Index>> runs_;  // joints of each cable, from the first to one past the last
};

inline Vector3 position(const VectorX& q, Index particle) {
  return q.segment<3>(3 * static_cast<Eigen::Index>(particle));
}

}  // namespace touchstone::sim
