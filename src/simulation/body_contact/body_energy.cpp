// The angular momentum and the energy of a substep of bodies.
// SPDX-License-Identifier: MIT
#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "body_contact/body_attempt.hpp"
#include "geometry/union_find.hpp"

namespace touchstone::sim {
namespace {

// Relative: rounding of energies, and what the sweeps leave.
constexpr double kEnergyRounding = 1e-9;
constexpr double kSmallEnergy = 1e-12;  // J

}  // namespace

bool BodyResponse::Attempt::node_is_held(Index node) const {
  if (node < bodies_) return !system_->bodies()[node].is_free();
  return !(r_->inverse_mass_.segment<3>(at(node)).array() > 0).all();
}

double BodyResponse::Attempt::mass_of(Index node) const {
  return node < bodies_ ? system_->bodies()[node].mass : 1 / r_->inverse_mass_[at(node)];
}

Vector3 BodyResponse::Attempt::start_of(Index node) const {
  return node < bodies_ ? start_->bodies[node].pose.p : Vector3(step_->x0->segment<3>(at(node)));
}

/// Impulses act in pairs at one point of the start, which changes no angular momentum. But a position correction moves
/// elements aside that pass each other, and an impulse at the time of a touch acts where they are then. What this
/// changes is given back to each group of bodies that push each other, and that nothing holds, as the velocities of a
/// rotation of the group as a whole: these change neither its momentum nor the velocities at its contacts.
void BodyResponse::Attempt::restore_angular_momentum() {
  geometry::UnionFind joined(nodes());
  std::vector<char> pushes(nodes(), 0);
  for (const SolverContact& c : contacts_) {
    if (c.correction == 0 && c.impulse().isZero(0)) continue;
    Index first = 0;
    bool any = false;
    const auto join = [&](Index n) {
      pushes[n] = 1;
      if (any) joined.join(first, n);
      first = n;
      any = true;
    };
    for (const ContactSide* side : {&c.contact.a, &c.contact.b}) {
      if (side->is_body()) join(side->body);
      for (std::size_t i = 0; i < side->count; ++i) join(particle_node(side->particles[i]));
    }
  }
  for (const auto& [a, b] : merged_) {
    pushes[a] = pushes[b] = 1;
    joined.join(a, b);
  }
  std::vector<std::vector<Index>> groups(nodes());
  for (Index n = 0; n < groups.size(); ++n) {
    if (pushes[n]) groups[joined.root(n)].push_back(n);
  }
  const BodyStates& end = result_.end.bodies;
  const auto velocity_before = [&](Index n) {
    return n < bodies_ ? free_movers_.bodies[n].velocity : Vector3(free_movers_.particles.segment<3>(at(n)));
  };
  const auto velocity_after = [&](Index n) {
    return n < bodies_ ? end[n].velocity : Vector3(velocity_before(n) + result_.velocity_change.segment<3>(at(n)));
  };
  const auto position_after = [&](Index n) {
    return n < bodies_ ? end[n].pose.p : Vector3(result_.x1.segment<3>(at(n)));
  };
  for (const auto& group : groups) {
    const auto held = [&](Index n) { return node_is_held(n); };
    if (group.size() < 2 || std::any_of(group.begin(), group.end(), held)) continue;
    double mass = 0;
    Vector3 centre_before = Vector3::Zero(), centre = centre_before, momentum = centre_before;
    for (const Index n : group) {
      const double m = mass_of(n);
      mass += m;
      centre_before += m * start_of(n);
      centre += m * position_after(n);
      momentum += m * velocity_after(n);
    }
    centre_before /= mass;
    centre /= mass;
    const Vector3 together = momentum / mass;
    Vector3 missing = Vector3::Zero();
    Matrix3 inertia = Matrix3::Zero();
    for (const Index n : group) {
      const double m = mass_of(n);
      const Vector3 arm = position_after(n) - centre;
      missing += m * (start_of(n) - centre_before).cross(velocity_before(n) - together);
      missing -= m * arm.cross(velocity_after(n) - together);
      inertia += m * (arm.squaredNorm() * Matrix3::Identity() - arm * arm.transpose());
      if (n >= bodies_) continue;
      missing += free_[n].momentum - end[n].momentum;
      const Matrix3 turn = matrix_of(end[n].pose.q);
      inertia += turn * system_->bodies()[n].inertia.moments * turn.transpose();
    }
    const Vector3 spin = inertia.ldlt().solve(missing);
    if (!spin.allFinite()) continue;
    const auto particles = [&] { return kinetic({}, free_movers_.particles + result_.velocity_change); };
    const double of_bodies = kinetic(end, {}), of_particles = particles();
    for (const Index n : group) {
      const Vector3 by = spin.cross(position_after(n) - centre);
      if (n < bodies_) {
        BodyState& to = result_.end.bodies[n];
        to.velocity += by;
        to.momentum += angular_momentum(system_->bodies()[n].inertia, to.pose.q, spin);
      } else {
        result_.velocity_change.segment<3>(at(n)) += by;
      }
    }
    restored_particles_ += particles() - of_particles;
    restored_ += kinetic(end, {}) - of_bodies + particles() - of_particles;
  }
}

double BodyResponse::Attempt::kinetic(const BodyStates& states, const VectorX& velocity) const {
  double sum = system_->energies(states).kinetic;
  for (Eigen::Index i = 0; i < velocity.size(); ++i) {
    if (r_->inverse_mass_[i] > 0) sum += 0.5 * velocity[i] * velocity[i] / r_->inverse_mass_[i];
  }
  return sum;
}

bool BodyResponse::Attempt::is_held(const ContactSide& side) const {
  if (side.is_body()) return node_is_held(side.body);
  for (std::size_t i = 0; i < side.count; ++i) {
    if (r_->inverse_mass_.segment<3>(3 * static_cast<Eigen::Index>(side.particles[i])).maxCoeff() > 0) return false;
  }
  return true;
}

/// Of bodies, and of the particles that they touch: gravity's work on bodies is in their potential energy, and that of
/// driven ones counts as given.
bool BodyResponse::Attempt::gained_energy() const {
  const double h = step_->h;
  const auto before = system_->energies(start_->bodies), after = system_->energies(result_.end.bodies);
  double work = 0, lift = 0;
  for (const SolverContact& c : contacts_) {
    const Vector3 impulse = c.impulse();
    if (is_held(c.contact.a)) work += std::max(0.0, -impulse.dot(movers_.velocity(c.contact.a)));
    if (is_held(c.contact.b)) work += std::max(0.0, impulse.dot(movers_.velocity(c.contact.b)));
  }
  for (std::size_t i = 0; i < bodies_; ++i) {
    if (!system_->bodies()[i].is_free() || pushes_.bodies.empty()) continue;
    lift += system_->bodies()[i].mass * std::abs(system_->gravity().dot(pushes_.bodies[i].velocity)) * h;
  }
  const VectorX free_velocity = free_movers_.particles;
  const double particles_before = kinetic({}, free_velocity);
  const double particles_after = kinetic({}, free_velocity + result_.velocity_change);
  const double scale = before.kinetic + after.kinetic + std::abs(before.load) + std::abs(after.load) + particles_before;
  return after.kinetic + after.load + particles_after > before.kinetic + before.load + particles_before + work + lift +
                                                            std::max(0.0, restored_) + kEnergyRounding * scale +
                                                            kSmallEnergy;
}

/// The work of an impulse is that impulse times the mean of the relative velocities at the start of the substep and
/// after all impulses, as an impulse acts for the whole substep: the sum over the contacts is the kinetic energy that
/// they give, and a body at rest gets none. Turning is measured at the orientation of the start,
/// where the impulses act, with the angular velocities that belong to the momenta.
void BodyResponse::Attempt::measure_flows() {
  EnergyFlows& flows = result_.flows;
  const BodyStates& start = start_->bodies;
  const auto total = [&](const BodyStates& states) { return system_->energies(states).total(); };
  if (system_->has_drag()) flows.drag = total(free_) - total(start);
  if (contacts_.empty()) return;
  Movers before = free_movers_, after = movers_;
  if (step_->v0 != nullptr) before.particles = *step_->v0;
  for (std::size_t i = 0; i < bodies_; ++i) {
    const RigidBody& body = system_->bodies()[i];
    if (!body.is_free()) continue;
    before.bodies[i].velocity = start[i].velocity;
    before.bodies[i].spin = angular_velocity(body.inertia, start[i].pose.q, start[i].momentum);
    after.bodies[i].spin = angular_velocity(body.inertia, start[i].pose.q, free_[i].momentum) + movers_.bodies[i].spin -
                           free_movers_.bodies[i].spin;
  }
  for (const SolverContact& c : contacts_) {
    const Vector3 impulse = c.impulse(), &normal = c.contact.normal;
    const Vector3 across = impulse - impulse.dot(normal) * normal;
    const Vector3 mean = 0.5 * (before.approach(c.contact) + after.approach(c.contact));
    flows.friction += across.dot(mean);
    flows.impacts += impulse.dot(normal) * normal.dot(mean);
    // What is driven gives what the contact takes from it, or gains.
    const auto drive = [&](const ContactSide& side, const Vector3& on_it) {
      if (side.is_body()) {
        if (node_is_held(side.body)) flows.driven -= on_it.dot(movers_.velocity(side));
        return;
      }
      for (std::size_t i = 0; i < side.count; ++i) {
        const auto first = 3 * static_cast<Eigen::Index>(side.particles[i]);
        for (Eigen::Index k = 0; k < 3; ++k) {
          if (r_->inverse_mass_[first + k] > 0) continue;
          flows.driven -= side.weights[i] * on_it[k] * movers_.particles[first + k];
        }
      }
    };
    drive(c.contact.a, impulse);
    drive(c.contact.b, -impulse);
  }
  if (result_.counts.zones > 0) {
    // Impulses moved bodies that then moved as one: what they do not explain is the impact of these.
    flows.corrections = restored_;
    flows.impacts += total(result_.end.bodies) - total(unpushed_) - carried_.driven - (restored_ - restored_particles_);
    flows.driven += carried_.driven;
    return;
  }
  flows.corrections = total(result_.end.bodies) - total(unpushed_) + restored_particles_;
  for (Eigen::Index i = 0; i < pushes_.particles.size(); ++i) {
    flows.corrections -= step_->h * pushes_.particles[i] * r_->force_[i];
  }
}

}  // namespace touchstone::sim
