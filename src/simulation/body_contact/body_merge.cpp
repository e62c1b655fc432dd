// Bodies that touch, and nothing parts them: in a short substep they move as one.
// SPDX-License-Identifier: MIT
#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "body_contact/body_attempt.hpp"
#include "geometry/union_find.hpp"

namespace touchstone::sim {

/// Bodies and particles that touch move on together, in this substep without turning, with the momentum that they have.
/// Their velocities afterwards are those of one rigid body with their momentum and angular momentum.
bool BodyResponse::Attempt::merge(Touches left) {
  geometry::UnionFind joined(nodes());
  const BodyStates before = result_.end.bodies;
  const VectorX x_before = result_.x1;
  while (!left.found.empty()) {
    bool grew = false;
    for (const auto& [pair, answer] : left.found) {
      const auto corners = r_->colliders_->corners(pair);
      for (std::size_t c = 1; c < corner_count(pair.kind); ++c) {
        merged_.emplace_back(node(corners[0]), node(corners[c]));
        grew |= joined.join(merged_.back().first, merged_.back().second);
      }
    }
    if (!grew) return false;
    result_.end.bodies = before;
    result_.x1 = x_before;
    result_.counts.zones = 0;
    carried_ = {};
    std::vector<std::vector<Index>> groups(nodes());
    for (Index n = 0; n < groups.size(); ++n) groups[joined.root(n)].push_back(n);
    for (const auto& members : groups) {
      if (members.size() < 2) continue;
      ++result_.counts.zones;
      if (!move_as_one(members, before, x_before)) return false;
    }
    left = touches();
    result_.counts.queries += left.pairs;
  }
  result_.counts.pairs = left.pairs;
  result_.counts.proof = left.levels;
  result_.counts.separations = left.separations;
  return true;
}

/// False when two of them are driven, and not alike.
bool BodyResponse::Attempt::move_as_one(const std::vector<Index>& members, const BodyStates& before,
                                        const VectorX& x_before) {
  const double h = step_->h;
  const auto velocity_of = [&](Index n) {
    if (n < bodies_ && !node_is_held(n)) return before[n].velocity;
    const Vector3 end = n < bodies_ ? before[n].pose.p : Vector3(x_before.segment<3>(at(n)));
    return Vector3((end - start_of(n)) / h);
  };
  double mass = 0;
  Vector3 momentum = Vector3::Zero(), centre = Vector3::Zero(), carrier = Vector3::Zero();
  bool carried = false;
  for (const Index n : members) {
    const Vector3 own = velocity_of(n);
    if (node_is_held(n)) {
      const bool turns = n < bodies_ && before[n].pose.q != start_->bodies[n].pose.q;
      if (turns || (carried && own != carrier)) return false;
      carried = true;
      carrier = own;
      continue;
    }
    mass += mass_of(n);
    momentum += mass_of(n) * own;
    centre += mass_of(n) * start_of(n);
  }
  const Vector3 velocity = carried ? carrier : Vector3(momentum / mass);
  if (carried) carried_.driven += (mass * carrier - momentum).dot(carrier);
  Vector3 spin = Vector3::Zero();
  if (!carried) {
    centre /= mass;
    Vector3 angular = Vector3::Zero();
    Matrix3 inertia = Matrix3::Zero();
    for (const Index n : members) {
      const Vector3 arm = start_of(n) - centre;
      angular += mass_of(n) * arm.cross(velocity_of(n) - velocity);
      inertia += mass_of(n) * (arm.squaredNorm() * Matrix3::Identity() - arm * arm.transpose());
      if (n >= bodies_) continue;
      angular += before[n].momentum;
      const Matrix3 turn = matrix_of(start_->bodies[n].pose.q);
      inertia += turn * system_->bodies()[n].inertia.moments * turn.transpose();
    }
    spin = inertia.ldlt().solve(angular);
    if (!spin.allFinite()) return false;
  }
  for (const Index n : members) {
    if (node_is_held(n)) continue;
    const Vector3 own = carried ? velocity : Vector3(velocity + spin.cross(start_of(n) - centre));
    if (n < bodies_) {
      BodyState& to = result_.end.bodies[n];
      const Pose& from = start_->bodies[n].pose;
      to.pose = {from.q, from.p + h * velocity};
      to.velocity = own;
      to.momentum = angular_momentum(system_->bodies()[n].inertia, from.q, spin);
      continue;
    }
    result_.x1.segment<3>(at(n)) = start_of(n) + h * velocity;
    result_.velocity_change.segment<3>(at(n)) = own - (step_->x1.segment<3>(at(n)) - start_of(n)) / h;
  }
  return true;
}

}  // namespace touchstone::sim
