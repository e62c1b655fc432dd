// SPDX-License-Identifier: MIT
#include "dynamics/energy_flows.hpp"

#include <algorithm>

namespace touchstone::sim {

FlowMeter::FlowMeter(const System& system, double drag, const State& before, double h)
    : system_(&system),
      energy_(system),
      drag_(drag),
      h_(h),
      before_(&before),
      elastic_(energy_.elastic()),
      damping_(energy_.damping()),
      moved_(before.q) {
  system.prescribe(before.time + h, moved_);
  moved_ -= before.q;
}

void FlowMeter::pass(double length, const State& from, const State& to) {
  const double time = length * h_;
  if (!damping_.isZero(0)) {
    const VectorX strained =
        energy_.strains(to.q, to.frames, to.time) - energy_.strains(from.q, from.frames, from.time);
    flows_.damping -= (damping_.array() * strained.array().square()).sum() / time;
  }
  if (drag_ == 0) return;
  for (Eigen::Index i = 0; i < to.q.size(); ++i) {
    const double moved = to.q[i] - from.q[i];
    if (!system_->fixed[static_cast<std::size_t>(i)]) flows_.drag -= drag_ * system_->mass[i] * moved * moved / time;
  }
}

void FlowMeter::drive(double weight, const State& at, const VectorX& rates) {
  if (!moved_.isZero(0)) {
    VectorX pull = VectorX::Zero(moved_.size());
    energy_.derivatives(at.q, at.frames, at.time, elastic_, Hessian::projected, pull, nullptr);
    // The damping force of strain s is -c ds/dt grad s: that of a spring of stiffness c, strained by ds/dt.
    Strains damped{damping_, energy_.strains(at.q, at.frames, at.time) - rates};
    damped.with_limits = false;  // their force is in the pull already
    energy_.derivatives(at.q, at.frames, at.time, damped, Hessian::projected, pull, nullptr);
    flows_.driven += weight * pull.dot(moved_);
  }
  const auto inserted = [](const Joint& joint, double time) {
    return joint.closing_rate * std::min(time, joint.closing_until);
  };
  for (std::size_t j = 0; j < system_->joints.size(); ++j) {
    const Joint& joint = system_->joints[j];
    const double turned = inserted(joint, before_->time + h_) - inserted(joint, before_->time);
    if (turned == 0) continue;
    // The frame of the second segment turns by itself.
    const JointStrain strain = system_->joint_strain(joint, at.q, at.frames, at.time);
    const auto row = static_cast<Eigen::Index>(system_->stretch_elements.size() + 3 * j);
    const Vector3 strains(strain.kappa1(), strain.kappa2(), strain.twist());
    const Vector3 stress = elastic_.stiffness.segment<3>(row).cwiseProduct(strains - elastic_.rest.segment<3>(row)) +
                           damping_.segment<3>(row).cwiseProduct(rates.segment<3>(row));
    JointVector k1, k2, m;
    strain.gradients(k1, k2, m);
    flows_.driven += weight * turned * stress.dot(Vector3(k1[7], k2[7], m[7]));
  }
}

EnergyFlows FlowMeter::finish(const State& after) {
  for (Eigen::Index i = 0; i < moved_.size(); ++i) {
    if (!system_->fixed[static_cast<std::size_t>(i)]) continue;
    const double inertia = 0.5 * system_->mass[i] * (after.v[i] * after.v[i] - before_->v[i] * before_->v[i]);
    flows_.driven += inertia - system_->force[i] * moved_[i];
  }
  return flows_;
}

}  // namespace touchstone::sim
