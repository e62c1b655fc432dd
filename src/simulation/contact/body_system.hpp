// The bodies of a scene as they are simulated: shapes about their centres of mass, states, and motion without contacts.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "bodies/spin.hpp"
#include "rods/energy.hpp"
#include "scene/scene.hpp"

namespace touchstone::sim {

struct RigidBody {
  BodyMotion motion = BodyMotion::free;
  std::vector<Vector3> points;  ///< in the body's frame; the origin of a free body's is its centre of mass
  double reach = 0;             ///< m: no point is farther from the origin
  double mass = 0;              ///< kg, of a free body
  Inertia inertia;              ///< of a free body
  Pose start;
  Vector3 velocity = Vector3::Zero(), angular_velocity = Vector3::Zero();  ///< at the start; of a driven body: always
  std::vector<BodyWaypoint> path;

  bool is_free() const noexcept { return motion == BodyMotion::free; }
};

/// The pose is that of the centre of mass. The angular momentum is in the world's frame, about the centre of mass.
struct BodyState {
  Pose pose;                           ///< of a quaternion of length 1
  Vector3 velocity = Vector3::Zero();  ///< m/s; of a body that is not free 0
  Vector3 momentum = Vector3::Zero();  ///< angular, kg m^2/s; of a body that is not free 0

  bool operator==(const BodyState&) const = default;
};
using BodyStates = std::vector<BodyState>;

class BodySystem {
 public:
  explicit BodySystem(const Scene& scene);

  const std::vector<RigidBody>& bodies() const noexcept { return bodies_; }
  BodyStates initial() const;

  /// Of a body that is not free.
  Pose prescribed(std::size_t body, double time) const;

  /// By how much a body that is not free turns between two times, rad: also by whole turns, which its poses do not
  /// show.
  double prescribed_turn(std::size_t body, double from, double to) const;

  /// The velocities h seconds later, by gravity and drag.
  void accelerate(BodyStates& states, double h) const;

  Energies energies(const BodyStates& states) const;
  const Vector3& gravity() const noexcept { return gravity_; }
  bool has_drag() const noexcept { return drag_ > 0; }

  /// No less than the angle by which a body turns in h seconds, rad: the largest of all.
  double most_turn(const BodyStates& states, double h) const;

 private:
  std::vector<RigidBody> bodies_;
  Vector3 gravity_;
  double drag_;
};

}  // namespace touchstone::sim
