// SPDX-License-Identifier: MIT
#include "body_contact/body_response.hpp"

#include <algorithm>
#include <cmath>

#include "body_contact/body_attempt.hpp"

namespace touchstone::sim {
namespace {

constexpr double kEdgesPerThickness = 50;  // the default thickness, as a fraction of the shortest edge that moves

}  // namespace

BodyResponse::BodyResponse(const Colliders& colliders, const System& system, const Settings& settings,
                           const linear::Cancellation& cancel)
    : colliders_(&colliders),
      contact_(settings.contact),
      time_step_(settings.time_step),
      thickness_(settings.contact.thickness),
      inverse_mass_(VectorX::Zero(static_cast<Eigen::Index>(3 * system.particle_count()))),
      force_(system.force.head(inverse_mass_.size())),
      solver_(colliders, NarrowPhase::exact, 1, cancel) {
  if (!(thickness_ > 0)) {
    thickness_ = colliders.shortest_edge_of_bodies() / kEdgesPerThickness;
    if (!std::isfinite(thickness_)) thickness_ = 1.0 / kEdgesPerThickness;
  }
  for (Eigen::Index i = 0; i < inverse_mass_.size(); ++i) {
    if (!system.fixed[static_cast<std::size_t>(i)]) inverse_mass_[i] = 1 / system.mass[i];
  }
}

BodyResult BodyResponse::step(const BodiesState& start, BodyStep step) const {
  return Attempt(*this, start, step).run();
}

BodyResponse::Touches BodyResponse::touches(const std::vector<Pair>& pairs, const SceneMotion& motion) const {
  Touches touches;
  touches.pairs = pairs.size();
  touches.separations = separations_of(*colliders_, pairs);
  touches.levels = solver_.contacts(
      pairs, motion, [&](std::size_t i, const Answer& answer) { touches.found.emplace_back(pairs[i], answer); });
  std::stable_sort(touches.found.begin(), touches.found.end(),
                   [](const auto& a, const auto& b) { return a.second.toi < b.second.toi; });
  return touches;
}

}  // namespace touchstone::sim
