// SPDX-License-Identifier: MIT
#include "sim/response_model.hpp"

#include <algorithm>

namespace touchstone::sim {
namespace {

// The fraction of a missing distance that position corrections restore in a whole step of the scene. A shorter substep
// restores less in proportion, so that the speed is the same. A missing distance is gone in some ten steps, and nothing
// jumps.
constexpr double kRecovery = 0.2;

// Impulses restore this part of that fraction in each of their many sweeps.
constexpr double kImpulseRecovery = 0.5;

// m/s: the greatest speed of a position correction. Elements that begin far too near do not fly apart.
constexpr double kFastestCorrection = 1.0;

// In units of gravity's displacement in a step. A shorter approach is that of elements at rest.
constexpr double kResting = 2;

// The default thickness, as a fraction of the shortest edge that moves.
constexpr double kEdgesPerThickness = 50;

}  // namespace

ResponseModel::ResponseModel(const Colliders& colliders, const System& system, const Settings& settings)
    : colliders_(&colliders),
      system_(&system),
      contact_(settings.contact),
      gravity_(settings.gravity.norm()),
      time_step_(settings.time_step),
      thickness_(settings.contact.thickness > 0 ? settings.contact.thickness
                                                : colliders.shortest_edge() / kEdgesPerThickness),
      inverse_mass_(VectorX::Zero(static_cast<Eigen::Index>(3 * system.particle_count()))),
      stiffness_(VectorX::Zero(static_cast<Eigen::Index>(system.particle_count()))),
      damping_(stiffness_) {
  for (Eigen::Index i = 0; i < inverse_mass_.size(); ++i) {
    if (!system.fixed[static_cast<std::size_t>(i)]) inverse_mass_[i] = 1 / system.mass[i];
  }
  for (const StretchElement& element : system.stretch_elements) {
    for (const Index p : {element.a, element.b}) {
      stiffness_[p] += element.stiffness;
      damping_[p] += element.damping;
    }
  }
  for (const Membrane& membrane : system.cloth.membranes) {
    for (Eigen::Index i = 0; i < 3; ++i) {
      const double stiffness = (membrane.stiffness[0] + membrane.stiffness[1]) * membrane.weights.row(i).squaredNorm();
      stiffness_[membrane.p[static_cast<std::size_t>(i)]] += stiffness;
      damping_[membrane.p[static_cast<std::size_t>(i)]] += membrane.damping * stiffness;
    }
  }
}

double ResponseModel::inverse_mass(Index particle) const {
  return inverse_mass_.segment<3>(3 * static_cast<Eigen::Index>(particle)).maxCoeff();
}

bool ResponseModel::is_held(Index particle) const {
  return (inverse_mass_.segment<3>(3 * static_cast<Eigen::Index>(particle)).array() == 0).all();
}

bool ResponseModel::is_stiff(const Contact& contact, double h) const {
  for (std::size_t c = 0; c < contact.corners; ++c) {
    const Index p = contact.particles[c];
    if (contact.omega[c] != 0 && (stiffness_[p] * h + damping_[p]) * h * inverse_mass(p) > 1) return true;
  }
  return false;
}

ImpulseRule ResponseModel::impulse_rule(double h) const {
  return {contact_.restitution, contact_.friction, thickness_, resting_approach(h), kImpulseRecovery * recovery(h)};
}

double ResponseModel::resting_approach(double h) const { return kResting * gravity_ * h * h; }

double ResponseModel::position_correction(double missing, double h) const {
  return std::min(recovery(h) * missing, kFastestCorrection * h);
}

double ResponseModel::recovery(double h) const { return kRecovery * std::min(1.0, h / time_step_); }

}  // namespace touchstone::sim
