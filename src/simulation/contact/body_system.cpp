// SPDX-License-Identifier: MIT
#include "contact/body_system.hpp"

#include <algorithm>
#include <cmath>

namespace touchstone::sim {

BodySystem::BodySystem(const Scene& scene) : gravity_(scene.settings.gravity), drag_(scene.settings.drag) {
  bodies_.reserve(scene.bodies.size());
  for (const Body& of_scene : scene.bodies) {
    RigidBody& body = bodies_.emplace_back();
    body.motion = of_scene.motion;
    body.path = of_scene.path;
    for (BodyWaypoint& point : body.path) point.pose.q = normalised(point.pose.q);
    body.start = {normalised(of_scene.pose.q), of_scene.pose.p};
    body.velocity = of_scene.velocity;
    body.angular_velocity = of_scene.angular_velocity;
    Vector3 centre = Vector3::Zero();
    if (body.is_free()) {
      const MassProperties mass = mass_properties(of_scene);
      body.mass = mass.mass;
      body.inertia = Inertia(mass.inertia);
      centre = mass.centre;
      body.start.p = placed(body.start, centre);
    }
    body.points.reserve(of_scene.vertices.size());
    for (const Vector3& vertex : of_scene.vertices) {
      body.points.emplace_back(vertex - centre);
      body.reach = std::max(body.reach, body.points.back().norm());
    }
    if (!body.path.empty()) body.start = body.path.front().pose;
  }
}

BodyStates BodySystem::initial() const {
  BodyStates states;
  for (const RigidBody& body : bodies_) {
    BodyState& state = states.emplace_back();
    state.pose = body.start;
    if (!body.is_free()) continue;
    state.velocity = body.velocity;
    state.momentum = angular_momentum(body.inertia, state.pose.q, body.angular_velocity);
  }
  return states;
}

Pose BodySystem::prescribed(std::size_t i, double time) const {
  const RigidBody& body = bodies_[i];
  if (body.motion == BodyMotion::fixed) return body.start;
  if (body.path.empty()) {
    return {normalised(product(rotation_by(time * body.angular_velocity), body.start.q)),
            body.start.p + time * body.velocity};
  }
  const auto after = std::upper_bound(body.path.begin(), body.path.end(), time,
                                      [](double t, const BodyWaypoint& point) { return t < point.time; });
  if (after == body.path.begin()) return body.path.front().pose;
  if (after == body.path.end()) return body.path.back().pose;
  const BodyWaypoint &from = *(after - 1), &to = *after;
  const double t = (time - from.time) / (to.time - from.time);
  const Vector3 turn = turn_between(from.pose.q, to.pose.q);
  return {normalised(product(rotation_by(t * turn), from.pose.q)), (1 - t) * from.pose.p + t * to.pose.p};
}

double BodySystem::prescribed_turn(std::size_t i, double from, double to) const {
  const RigidBody& body = bodies_[i];
  if (body.motion == BodyMotion::fixed) return 0;
  if (body.path.empty()) return (to - from) * body.angular_velocity.norm();
  double sum = 0;
  for (std::size_t k = 1; k < body.path.size(); ++k) {
    const BodyWaypoint &a = body.path[k - 1], &b = body.path[k];
    const double common = std::min(to, b.time) - std::max(from, a.time);
    if (common > 0) sum += common / (b.time - a.time) * turn_between(a.pose.q, b.pose.q).norm();
  }
  return sum;
}

void BodySystem::accelerate(BodyStates& states, double h) const {
  const double kept = std::exp(-drag_ * h);
  // (1 - exp(-d h)) / d, which is h without drag.
  const double span = drag_ > 0 ? -std::expm1(-drag_ * h) / drag_ : h;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (!bodies_[i].is_free()) continue;
    states[i].velocity = kept * states[i].velocity + span * gravity_;
    if (drag_ > 0) states[i].momentum *= kept;
  }
}

Energies BodySystem::energies(const BodyStates& states) const {
  Energies sum;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const RigidBody& body = bodies_[i];
    if (!body.is_free()) continue;
    sum.kinetic += 0.5 * body.mass * states[i].velocity.squaredNorm() +
                   spin_energy(body.inertia, states[i].pose.q, states[i].momentum);
    sum.load -= body.mass * gravity_.dot(states[i].pose.p);
  }
  return sum;
}

double BodySystem::most_turn(const BodyStates& states, double h) const {
  double most = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (bodies_[i].is_free()) most = std::max(most, sim::most_turn(bodies_[i].inertia, states[i].momentum, h));
  }
  return most;
}

}  // namespace touchstone::sim
