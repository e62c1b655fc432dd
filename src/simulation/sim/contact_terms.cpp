// SPDX-License-Identifier: MIT
#include "sim/contact_terms.hpp"

#include <algorithm>
#include <cmath>

#include "scene/features.hpp"

namespace touchstone::sim {
namespace {

// Stiffness of a contact over that of the elements that it touches. A contact yields a twentieth as far as they do, and
// the matrix stays well conditioned.
constexpr double kStiffer = 20;

// m/s: slower slip is friction at rest.
constexpr double kStickSpeed = 5e-3;

// Fraction of the largest limit of friction. Limits that change by less count as settled.
constexpr double kSettledFriction = 0.2;

// m^2: keeps a division finite where a joint's neighbours coincide, and is lost beside any other square.
constexpr double kTiny = 1e-300;

/// Adds the blocks of the cloth's particles: those of its second derivatives without stress.
void hold_cloth(const System& system, const VectorX& q, std::vector<Eigen::Matrix3f>& hold) {
  const auto add = [&hold](const auto& particles, const auto& gradient, double stiffness) {
    for (std::size_t i = 0; i < particles.size(); ++i) {
      const Vector3 own = gradient.template segment<3>(3 * static_cast<Eigen::Index>(i));
      hold[particles[i]] += (stiffness * own * own.transpose()).template cast<float>();
    }
  };
  for (const Membrane& membrane : system.cloth.membranes) {
    const MembraneStrain strain(membrane, position(q, membrane.p[0]), position(q, membrane.p[1]),
                                position(q, membrane.p[2]));
    const auto gradients = strain.gradients();
    for (Eigen::Index k = 0; k < 3; ++k)
      add(membrane.p, gradients.col(k), membrane.stiffness[static_cast<std::size_t>(k)]);
  }
  for (const Hinge& hinge : system.cloth.hinges) {
    const HingeStrain strain(position(q, hinge.p[0]), position(q, hinge.p[1]), position(q, hinge.p[2]),
                             position(q, hinge.p[3]));
    add(hinge.p, strain.gradient(), hinge.stiffness);
  }
}

}  // namespace

ContactTerms::ContactTerms(const ResponseModel& model, const State& start, double h, double tolerance,
                           const std::vector<Contact>& contacts)
    : model_(&model), start_(&start), h_(h), tolerance_(tolerance) {
  measure_hold();
  terms_.reserve(contacts.size() + contacts.size() / 4);
  term_of_pair_.reserve(terms_.capacity());
  for (const Contact& contact : contacts) add(contact);
}

void ContactTerms::measure_hold() {
  const System& system = model_->system();
  const VectorX& q = start_->q;
  hold_.assign(system.particle_count(), Eigen::Matrix3f::Zero());
  for (const StretchElement& element : system.stretch_elements) {
    const Vector3 along = (position(q, element.b) - position(q, element.a)).normalized();
    const Eigen::Matrix3f stiffness = (element.stiffness * along * along.transpose()).cast<float>();
    hold_[element.a] += stiffness;
    hold_[element.b] += stiffness;
  }
  hold_cloth(system, q, hold_);
  for (const Joint& joint : system.joints) {
    // A bend of one segment's length: the middle moves against both of its neighbours.
    const double length = 0.5 * (position(q, joint.p[2]) - position(q, joint.p[0])).norm();
    const double across = joint.bend / (length * length + kTiny);
    for (std::size_t k = 0; k < 3; ++k)
      hold_[joint.p[k]] += static_cast<float>((k == 1 ? 4 : 1) * across) * Eigen::Matrix3f::Identity();
  }
}

ContactTerm ContactTerms::term_of(const Contact& contact) const {
  ContactTerm term;
  term.particles = contact.particles;
  term.corners = contact.corners;
  term.omega = contact.omega;
  term.normal = contact.normal;
  term.stick = kStickSpeed * h_;
  double softness = 0;
  for (std::size_t c = 0; c < contact.corners; ++c) {
    const Index p = contact.particles[c];
    const double inverse = model_->inverse_mass(p);
    if (inverse > 0) {
      // A cable is stiff along itself and soft across, which is where it is mostly touched.
      const double hold = 1 / (inverse * h_ * h_) + contact.normal.dot(hold_[p].cast<double>() * contact.normal);
      softness += contact.omega[c] * contact.omega[c] / hold;
    }
  }
  term.stiffness = softness > 0 ? kStiffer / softness : 0;
  // Elements may come as near as the thickness; those that are nearer already move out slowly.
  const double missing = model_->thickness() - contact.gap;
  term.goal = missing > 0 ? model_->position_correction(missing, h_) : missing;
  // The speed of impact is that before the substep: at its end, elements that lean on a contact seem to fly into it.
  const double approach = h_ * contact.normal.dot(relative_motion(term, start_->v));
  if (approach < -model_->resting_approach(h_))
    term.goal = std::max(term.goal, -model_->contact().restitution * approach);
  return term;
}

void ContactTerms::add(const Contact& contact) {
  terms_.push_back(term_of(contact));
  if (contact.gap < model_->thickness()) {
    const double out = model_->position_correction(model_->thickness() - contact.gap, h_);
    tolerance_ += 0.5 * terms_.back().stiffness * out * out;
  }
  term_of_pair_.emplace_back(key(contact.pair), terms_.size() - 1);
}

EnergyFlows ContactTerms::flows(const State& end) const {
  EnergyFlows flows;
  for (const ContactTerm& term : terms_) {
    const Vector3 before = relative_motion(term, start_->v), after = relative_motion(term, end.v);
    Vector3 response = Vector3::Zero();  // to a unit impulse along each axis
    for (std::size_t c = 0; c < term.corners; ++c) {
      const auto at = 3 * static_cast<Eigen::Index>(term.particles[c]);
      response += term.omega[c] * term.omega[c] * model_->inverse_mass().segment<3>(at);
    }
    // A force works along the way of the substep, which is that of the velocities at its end. Of an impulse that
    // changes these velocities, half of the change is lost on the way: that much of the impulse as the inertia of the
    // corners takes. The rest pushes against their elements.
    const auto work = [&](const Vector3& impulse) {
      const double size = impulse.norm();
      if (size == 0) return 0.0;
      const Vector3 along = impulse / size;
      const double change = std::max(0.0, along.dot(after - before));
      const double inertia = 1 / (response.dot(along.cwiseProduct(along)) + kTiny);
      return size * along.dot(after) - 0.5 * std::min(size, inertia * change) * change;
    };
    const Vector3 normal = h_ * normal_force(term, start_->q, end.q) * term.normal;
    Vector3 friction = Vector3::Zero();
    if (kFriction && term.slip > 0) friction = -h_ * term.slip * friction_pull(term, start_->q, end.q);
    const double by_normal = work(normal);
    (term.goal > 0 && by_normal > 0 ? flows.corrections : flows.impacts) += by_normal;
    flows.friction += work(friction);
    for (std::size_t c = 0; c < term.corners; ++c) {
      const auto at = 3 * static_cast<Eigen::Index>(term.particles[c]);
      for (Eigen::Index k = 0; k < 3; ++k) {
        if (model_->inverse_mass()[at + k] == 0)
          flows.driven -= term.omega[c] * (normal[k] + friction[k]) * end.v[at + k];
      }
    }
  }
  return flows;
}

bool ContactTerms::update_friction(const VectorX& end) {
  double most = 0, change = 0;
  if (kFriction && model_->contact().friction > 0) {
    for (ContactTerm& term : terms_) {
      const double slip = model_->contact().friction * normal_force(term, start_->q, end);
      most = std::max(most, slip);
      change = std::max(change, std::abs(slip - term.slip));
      term.slip = slip;
    }
  }
  return change <= kSettledFriction * most;
}

void ContactTerms::take(const std::vector<Contact>& found) {
  std::sort(term_of_pair_.begin(), term_of_pair_.end());
  const auto known = static_cast<std::ptrdiff_t>(term_of_pair_.size());
  for (const Contact& contact : found) {
    const PairKey sought = key(contact.pair);
    const auto known_end = term_of_pair_.begin() + known;
    const auto same = std::lower_bound(term_of_pair_.begin(), known_end, std::pair{sought, std::size_t{0}});
    if (same == known_end || same->first != sought) {
      add(contact);
    } else {
      // It turned on the way: where it touches now says more than where it would have touched.
      ContactTerm& term = terms_[same->second];
      const double slip = term.slip;
      term = term_of(contact);
      term.slip = slip;
    }
  }
}

}  // namespace touchstone::sim
