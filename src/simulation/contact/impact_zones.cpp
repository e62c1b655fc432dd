// SPDX-License-Identifier: MIT
#include "contact/impact_zones.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <map>

namespace touchstone::sim {
namespace {

// Fraction of the greatest moment of inertia. Particles on a line have no moment about it, but for rounding.
constexpr double kNoMoment = 1e-9;

// Radians, in a substep. Below half a turn the map (1 - t) + t R is regular for every t; this leaves room for rounding.
constexpr double kMostTurn = 1.0;

}  // namespace

bool ImpactZones::join(const Contact& contact) {
  bool joined = false;
  for (std::size_t c = 1; c < contact.corners; ++c) joined |= joined_.join(contact.particles[0], contact.particles[c]);
  return joined;
}

std::vector<std::vector<Index>> ImpactZones::zones() {
  std::map<Index, std::vector<Index>> by_root;
  for (Index p = 0; p < joined_.size(); ++p) {
    if (zone(p) != p) by_root[zone(p)].push_back(p);
  }
  std::vector<std::vector<Index>> all;
  for (auto& [root, members] : by_root) {
    members.insert(members.begin(), root);
    all.push_back(std::move(members));
  }
  return all;
}

bool move_rigidly(const std::vector<Index>& zone, const System& system, const VectorX& inverse_mass, const VectorX& x0,
                  VectorX& x1, Turning turning) {
  const auto at = [](Index p) { return 3 * static_cast<Eigen::Index>(p); };
  // A particle that is held in one coordinate only counts as held: it does not move at all then.
  const Index* held = nullptr;
  Vector3 displacement = Vector3::Zero();
  for (const Index& p : zone) {
    if ((inverse_mass.segment<3>(at(p)).array() > 0).all()) continue;
    const bool driven = (inverse_mass.segment<3>(at(p)).array() == 0).all();
    const Vector3 own = driven ? Vector3(position(x1, p) - position(x0, p)) : Vector3::Zero();
    if (held != nullptr && own != displacement) return false;
    held = &p;
    displacement = own;
  }
  if (held != nullptr) {
    for (const Index p : zone) {
      if (!(inverse_mass.segment<3>(at(p)).array() == 0).all()) x1.segment<3>(at(p)) = position(x0, p) + displacement;
    }
    return true;
  }

  double mass = 0;
  Vector3 centre = Vector3::Zero(), momentum = Vector3::Zero();
  for (const Index p : zone) {
    const double m = system.mass[at(p)];
    mass += m;
    centre += m * (position(x0, p) - position(x0, zone[0]));
    momentum += m * (position(x1, p) - position(x0, p));
  }
  centre = position(x0, zone[0]) + centre / mass;
  const Vector3 shift = momentum / mass;
  if (turning == Turning::none) {
    for (const Index p : zone) x1.segment<3>(at(p)) = position(x0, p) + shift;
    return true;
  }
  Vector3 angular = Vector3::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  for (const Index p : zone) {
    const double m = system.mass[at(p)];
    const Vector3 arm = position(x0, p) - centre;
    angular += m * arm.cross(Vector3(position(x1, p) - position(x0, p) - shift));
    inertia += m * (arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose());
  }
  // Particles on a line have no angular momentum about it either.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(inertia);
  Vector3 turn = Vector3::Zero();
  for (Eigen::Index k = 0; k < 3; ++k) {
    const double moment = axes.eigenvalues()[k];
    if (moment > kNoMoment * axes.eigenvalues()[2])
      turn += axes.eigenvectors().col(k).dot(angular) / moment * axes.eigenvectors().col(k);
  }
  const double angle = std::min(turn.norm(), kMostTurn);
  const Eigen::Matrix3d rotation =
      angle > 0 ? Eigen::AngleAxisd(angle, turn.normalized()).toRotationMatrix() : Eigen::Matrix3d::Identity();
  for (const Index p : zone) {
    const Vector3 arm = position(x0, p) - centre;
    x1.segment<3>(at(p)) = position(x0, p) + (shift + (rotation * arm - arm));
  }
  return true;
}

}  // namespace touchstone::sim
