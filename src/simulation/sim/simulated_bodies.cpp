// SPDX-License-Identifier: MIT
#include "sim/simulated_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <touchstone/error.hpp>

#include "dynamics/energy_budget.hpp"
#include "geometry/kind_traits.hpp"

namespace touchstone::sim {
namespace {

// The quaternion of a state is normalised: each component is good to a few epsilon.
constexpr double kUnitLength = 1e-14;

// m, m/s, kg m^2/s, N: what no run with numbers that make sense comes to.
constexpr double kMost = 1e30;

/// What the weight of all that is free does on gravity's displacement in a substep, J: forces that carry it store and
/// release as much in each.
double energy_of_carrying(const BodySystem& bodies, const System& system, double h) {
  double sum = 0;
  for (const RigidBody& body : bodies.bodies()) {
    if (body.is_free()) sum += body.mass * bodies.gravity().squaredNorm();
  }
  for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(3 * system.particle_count()); ++i) {
    if (!system.fixed[static_cast<std::size_t>(i)]) sum += system.force[i] * system.force[i] / system.mass[i];
  }
  return h * h * sum;
}

bool sensible(const Vector3& x) { return x.allFinite() && x.lpNorm<Eigen::Infinity>() <= kMost; }

}  // namespace

SimulatedBodies::SimulatedBodies(const Scene& scene, const System& system, const Colliders& colliders,
                                 const linear::Cancellation& cancel)
    : colliders_(&colliders),
      response_(colliders, system, scene.settings, cancel),
      state_{colliders.bodies().initial(), {}} {}

void SimulatedBodies::check_start(const BodiesState& bodies, const VectorX& q, std::string_view what) const {
  const auto touches = response_.touches({&q, &q, &bodies.bodies, &bodies.bodies});
  if (touches.found.empty()) return;
  const Pair& pair = touches.found.front().first;
  if (const double d = colliders_->separation(pair); d > 0) {
    throw Error(fmt::format(
        "{} begins with elements that are too near: the radii of {} ask for more than {:.9g} m between them; smaller "
        "radii, or elements farther apart, would be right",
        what, colliders_->describe(pair), d));
  }
  throw Error(fmt::format("{} begins with elements that touch: {}", what, colliders_->describe(pair)));
}

BodyResult SimulatedBodies::step(const State& start, double h, double end_time, bool may_merge, const System& system,
                                 State& next) const {
  const auto count = static_cast<Eigen::Index>(3 * system.particle_count());
  const VectorX x0 = start.q.head(count);
  const VectorX v0 = start.v.head(count);
  BodyStep step{h, end_time, &x0, next.q.head(count), &v0, may_merge, keeps_contacts_};
  BodyResult result = response_.step(state_, std::move(step));
  if (result.x1.size() == 0) return result;
  if ((result.x1.array() == next.q.head(count).array()).all()) return result;
  const VectorX before = next.q;
  const Energies uncorrected = sim::energies(system, next);
  next.q.head(count) = result.x1;
  next.v.head(count) += result.velocity_change;
  next.frames = system.transported(next.frames, before, next.q);
  const Energies corrected = sim::energies(system, next);
  const Energies from = energies(), to = colliders_->bodies().energies(result.end.bodies);
  // A push moves a particle and none of its neighbours: what that stores must come from somewhere. Under a body at rest
  // the integrator relaxes the strains that carry it, and pushes restore them.
  const double gained = (corrected.total() - uncorrected.total()) + (to.kinetic - from.kinetic) + (to.load - from.load);
  const double given = std::max(result.flows.driven, 0.0) + std::max(result.flows.corrections, 0.0);
  result.strains_gain =
      gained > given + energy_tolerance(uncorrected, corrected) + energy_of_carrying(colliders_->bodies(), system, h);
  return result;
}

void SimulatedBodies::check_state(const BodiesState& state, double time) const {
  const auto fail = [](std::size_t i, std::string_view key, std::string_view reason) {
    throw Error(fmt::format("bodies[{}].{}: {}", i, key, reason));
  };
  if (state.bodies.size() != colliders_->bodies().bodies().size()) {
    throw Error(fmt::format("bodies: there are {}, and this scene has {}", state.bodies.size(),
                            colliders_->bodies().bodies().size()));
  }
  for (std::size_t i = 0; i < state.bodies.size(); ++i) {
    const BodyState& body = state.bodies[i];
    if (!sensible(body.pose.p)) fail(i, "position", "must be three finite numbers of at most 1e30");
    if (!(std::abs(dot(body.pose.q, body.pose.q) - 1) <= kUnitLength)) {
      fail(i, "orientation", "must be a quaternion of length 1");
    }
    if (!sensible(body.velocity)) fail(i, "velocity", "must be three finite numbers of at most 1e30");
    if (!sensible(body.momentum)) fail(i, "angular_momentum", "must be three finite numbers of at most 1e30");
    if (colliders_->bodies().bodies()[i].is_free()) continue;
    if (body.velocity != Vector3::Zero() || body.momentum != Vector3::Zero()) {
      fail(i, "velocity", "a body that is not free has none");
    }
    Pose must = colliders_->bodies().prescribed(i, time);
    if (dot(must.q, body.pose.q) < 0) must.q = negated(must.q);
    if (time > 0 && must != body.pose) fail(i, "position", "the body is not free: it must be where its motion leads");
  }
  const Colliders::Counts& all = colliders_->before(colliders_->group_count());
  for (std::size_t i = 0; i < state.forces.size(); ++i) {
    const ContactForce& force = state.forces[i];
    const auto& [first, second] = geometry::traits_of(force.pair.kind);
    const bool known =
        force.pair.kind != Kind::point_point && force.pair.i < all.of(first.sort) && force.pair.j < all.of(second.sort);
    if (!known) throw Error(fmt::format("contact_forces[{}]: the scene has no such pair of elements", i));
    if (!sensible(force.force))
      throw Error(fmt::format("contact_forces[{}]: the force must be finite, at most 1e30", i));
    if (i > 0 && !(state.forces[i - 1].pair < force.pair)) {
      throw Error(fmt::format("contact_forces[{}]: must come after the one before it, and be of another pair", i));
    }
  }
}

}  // namespace touchstone::sim
