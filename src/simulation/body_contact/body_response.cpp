// SPDX-License-Identifier: MIT
#include "body_contact/body_response.hpp"

#include <touchstone/curved.hpp>

#include <algorithm>
#include <cmath>

#include "body_contact/body_attempt.hpp"

namespace touchstone::sim {
namespace {

constexpr double kEdgesPerThickness = 50;  // the default thickness, as a fraction of the shortest edge that moves

void count_level(Level level, LevelCounts& counts) noexcept {
  switch (level) {
    case Level::filter: ++counts.filter; break;
    case Level::bracket: ++counts.bracket; break;
    case Level::exact: ++counts.exact; break;
    case Level::oracle: ++counts.oracle; break;
  }
}

}  // namespace

BodyResponse::BodyResponse(const BodyColliders& colliders, const System& system, const Settings& settings,
                           const linear::Cancellation& cancel)
    : colliders_(&colliders),
      contact_(settings.contact),
      time_step_(settings.time_step),
      thickness_(settings.contact.thickness),
      inverse_mass_(VectorX::Zero(static_cast<Eigen::Index>(3 * system.particle_count()))),
      force_(system.force.head(inverse_mass_.size())),
      cancel_(&cancel) {
  if (!(thickness_ > 0)) {
    thickness_ = colliders.shortest_edge() / kEdgesPerThickness;
    if (!std::isfinite(thickness_)) thickness_ = 1.0 / kEdgesPerThickness;
  }
  for (Eigen::Index i = 0; i < inverse_mass_.size(); ++i) {
    if (!system.fixed[static_cast<std::size_t>(i)]) inverse_mass_[i] = 1 / system.mass[i];
  }
}

BodyResult BodyResponse::step(const BodiesState& start, BodyStep step) const {
  return Attempt(*this, start, step).run();
}

BodyResponse::Touches BodyResponse::touches(const std::vector<BodyPair>& pairs, const BodyMotions& motions) const {
  Touches touches;
  touches.pairs = pairs.size();
  constexpr std::size_t kBlock = 256;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (i % kBlock == 0) cancel_->check();
    const CurvedQuery query = colliders_->query(pairs[i], motions);
    const double d = colliders_->separation(pairs[i]);
    const Answer answer = d > 0 ? solve(query, {.separation = Separation{d, Metric::euclidean}}) : solve(query);
    if (d > 0) {
      SeparationCounts& kept = touches.separations;
      kept.least = kept.pairs == 0 ? d : std::min(kept.least, d);
      kept.largest = std::max(kept.largest, d);
      ++kept.pairs;
    }
    count_level(answer.level, touches.levels);
    if (answer.contact) touches.found.emplace_back(pairs[i], answer);
  }
  std::stable_sort(touches.found.begin(), touches.found.end(),
                   [](const auto& a, const auto& b) { return a.second.toi < b.second.toi; });
  return touches;
}

}  // namespace touchstone::sim
