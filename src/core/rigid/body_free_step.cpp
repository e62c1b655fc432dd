// The longest step of bodies whose stored, rounded end poses are reached without contact.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <vector>

#include <touchstone/bodies.hpp>
#include <touchstone/curved.hpp>
#include <touchstone/error.hpp>

#include "mesh/candidates.hpp"
#include "mesh/obstacles.hpp"
#include "numbers/doubles/between.hpp"
#include "numbers/doubles/decimal_text.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "numbers/roots/vanishing.hpp"
#include "rigid/body_search.hpp"

namespace touchstone::rigid {
namespace {

using mesh::Tried;

/// The motion to the rounded pose after a length. The quaternions keep their lengths, so the path is that of the whole
/// motion, but for the rounding.
RigidMotion path_of(const RigidMotion& motion, double length) noexcept {
  RigidMotion path = motion;
  for (std::size_t i = 0; i < 4; ++i) path.q1[i] = numbers::between(motion.q0[i], motion.q1[i], length);
  path.p1 = {numbers::between(motion.p0.x, motion.p1.x, length), numbers::between(motion.p0.y, motion.p1.y, length),
             numbers::between(motion.p0.z, motion.p1.z, length)};
  return path;
}

bool moves(const RigidMotion& motion) noexcept {
  return motion.q0 != motion.q1 || motion.p0.x != motion.p1.x || motion.p0.y != motion.p1.y ||
         motion.p0.z != motion.p1.z;
}

std::vector<Pose> ends_of(const std::vector<RigidMotion>& motions) {
  std::vector<Pose> poses;
  for (const RigidMotion& motion : motions) poses.push_back({motion.q1, motion.p1});
  return poses;
}

FreeBodyStep find_step(const Bodies& bodies, const CollidingBodies& colliding, const std::vector<RigidMotion>& motions,
                       const BodyStepOptions& options) {
  FreeBodyStep result;
  result.first_contact = find_first(bodies, colliding, motions, options);
  result.proofs = 1;
  const FirstBodyContact& contact = result.first_contact;
  if (!contact.at_start.empty() || !contact.start_intersections.empty()) {
    result.outcome = contact.at_start.empty() ? StepOutcome::intersects_at_start : StepOutcome::contact_at_start;
    result.length = 0;
    result.poses = starts_of(motions);
    return result;
  }
  if (!contact.contact) {
    result.poses = ends_of(motions);
    return result;
  }
  const auto path_of_pair = [](CurvedQuery query, double length) {
    for (std::size_t m = 0; m < 2; ++m) query.motions[m] = path_of(query.motions[m], length);
    return query;
  };
  mesh::Obstacles<CurvedQuery, decltype(path_of_pair)> obstacles(path_of_pair);
  const auto add = [&](const std::vector<BodyContact>& contacts) {
    for (const BodyContact& one : contacts) obstacles.add(query_between(bodies, one.pair, motions), one.separation);
  };
  add(contact.earliest);
  std::vector<RigidMotion> path(motions.size());
  const auto attempt = [&](double length) {
    mesh::check_stop(options.stop);
    std::transform(motions.begin(), motions.end(), path.begin(),
                   [length](const RigidMotion& motion) { return path_of(motion, length); });
    if (length == 0 || std::none_of(path.begin(), path.end(), moves)) return Tried::no_room;
    const auto vanishes = [](const RigidMotion& motion) {  // components near the least double are rounded to 0
      return motion.q1 == std::array<double, 4>{} || numbers::zero_between(motion.q0, motion.q1).has_value();
    };
    if (std::any_of(path.begin(), path.end(), vanishes)) return Tried::no_room;
    const std::vector<BodyContact> met = find_all(bodies, colliding, path, options);
    ++result.proofs;
    add(met);
    return met.empty() ? Tried::free : Tried::blocked;
  };
  Tried tried;
  result.length = mesh::shortened(obstacles, contact, attempt, tried);
  const bool is_free = tried == Tried::free;
  result.outcome = is_free ? StepOutcome::shortened : StepOutcome::no_room;
  result.poses = is_free ? ends_of(path) : starts_of(motions);
  return result;
}

}  // namespace
}  // namespace touchstone::rigid

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

FreeBodyStep free_step(const Bodies& bodies, const std::vector<RigidMotion>& motions, const BodyStepOptions& options) {
  const numbers::DefaultFloatEnvironment environment;
  const rigid::CollidingBodies colliding(bodies);
  rigid::validate(bodies, motions, options.threads);
  if (options.t_max != 1) {
    throw InvalidQuery("t_max is " + numbers::decimal_text(options.t_max) + "; a free step is asked about with 1");
  }
  return rigid::find_step(bodies, colliding, motions, options);
}

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
