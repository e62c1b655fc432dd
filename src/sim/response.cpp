// SPDX-License-Identifier: MIT
#include "sim/response.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "scene/features.hpp"
#include "contact/impact_zones.hpp"

namespace touchstone::sim {
namespace {

constexpr int kSweeps = 4;            // over all contacts known so far, in each pass
constexpr int kSolves = 4;            // implicit steps, each with the contacts that the one before it left
constexpr double kStiffer = 20;       // contact stiffness over that of the elements
constexpr double kLimitKnown = 0.2;   // by which share of the largest one limits of friction may still change
constexpr double kFastestOut = 1.0;   // m/s at which what is too near is pushed apart
constexpr double kStickSpeed = 5e-3;  // m/s: slower slip is friction at rest

using PairKey = std::tuple<Kind, Index, Index>;
PairKey key(const Pair& pair) { return {pair.kind, pair.i, pair.j}; }

}  // namespace

/// One response under way.
struct Response::Work {
  const State* state;
  double h;
  VectorX wanted;  // where the integrator, without contacts or with them, wants to be: next.v belongs to it
  State* next;
  VectorX pushed;  // the part of next.q - wanted that is no velocity
  double energy;   // the larger of those before the step and after it without contacts
  double slack;    // how much more is no gain
  double driven;   // work of driven particles by impulses and impact zones, which is no gain either, J
  ResponseCounts* counts;
  PhaseTimes* times;
};

Response::Response(const Elements& elements, const System& system, const Settings& settings, NarrowPhase narrow_phase,
                   int threads)
    : elements_(&elements),
      system_(&system),
      contact_(settings.contact),
      gravity_(settings.gravity),
      time_step_(settings.time_step),
      thickness_(settings.contact.thickness > 0 ? settings.contact.thickness : elements.shortest_edge() / 50),
      inverse_mass_(VectorX::Zero(static_cast<Eigen::Index>(3 * system.particle_count()))),
      stiffness_(VectorX::Zero(static_cast<Eigen::Index>(system.particle_count()))),
      repels_(narrow_phase == NarrowPhase::exact),
      finder_(elements, narrow_phase, threads) {
  for (Eigen::Index i = 0; i < inverse_mass_.size(); ++i) {
    if (!system.fixed[static_cast<std::size_t>(i)]) inverse_mass_[i] = 1 / system.mass[i];
  }
  for (const Length& element : system.lengths) {
    stiffness_[element.a] += element.stiffness;
    stiffness_[element.b] += element.stiffness;
  }
}

Response::Outcome Response::respond(Stepper& stepper, const State& state, double h, State& next, ResponseCounts& counts,
                                    PhaseTimes& times) {
  const PhaseClock clock(times.response);
  trouble_ = {};
  const auto& passes = elements_->passes();
  if (!passes.edge_edge && !passes.vertex_face && !passes.joints && !passes.points) return Outcome::done;
  finder_.begin(state.q, next.q, thickness_);
  // The paper has no repulsion: what its solver does not find, nothing holds.
  std::vector<Contact> known, found;
  if (repels_) known = finder_.close(thickness_);
  counts.close = known.size();
  finder_.find(next.q, found, counts);
  if (known.empty() && found.empty()) return Outcome::done;
  known.insert(known.end(), found.begin(), found.end());
  found = {};

  const Energies before = energies(*system_, state), without = energies(*system_, next);
  constexpr double kShare = 2e-3;
  const double slack = kShare * std::max(before.total() - before.load, without.total() - without.load) +
                       1e-12 * (std::abs(before.load) + 1e-3);
  Work work{&state, h, next.q,  &next, VectorX::Zero(inverse_mass_.size()), std::max(before.total(), without.total()),
            slack,  0, &counts, &times};
  const bool stiff = std::any_of(known.begin(), known.end(), [&](const Contact& c) { return is_stiff(c, h); });
  if (!stiff) {
    const State free = next;
    if (impulses(work, known, contact_.passes)) {
      take_velocities(work, next);
      if (!gained_energy(work, next)) return Outcome::done;
    }
    next = free;
    work.wanted = free.q;
    work.pushed.setZero();
    work.driven = 0;
  }
  if (!solve_with_contacts(work, stepper, std::move(known))) return Outcome::not_converged;
  if (!impulses(work, {}, contact_.passes)) {
    finder_.find(next.q, found, counts);
    if (!freeze_zones(work, found)) return Outcome::not_resolved;
  }
  take_velocities(work, next);
  return gained_energy(work, next) ? Outcome::gained_energy : Outcome::done;
}

double Response::recovery(double h) const { return 0.2 * std::min(1.0, h / time_step_); }

double Response::pushed_out(double room, double h) const { return std::min(recovery(h) * room, kFastestOut * h); }

bool Response::is_stiff(const Contact& contact, double h) const {
  for (std::size_t c = 0; c < contact.corners; ++c) {
    const auto p = static_cast<Eigen::Index>(contact.particles[c]);
    if (contact.omega[c] != 0 && stiffness_[p] * h * h * inverse_mass_.segment<3>(3 * p).maxCoeff() > 1) return true;
  }
  return false;
}

void Response::take_velocities(const Work& work, State& next) const {
  const auto n = inverse_mass_.size();
  if (next.q.head(n) == work.wanted.head(n)) return;
  for (Eigen::Index i = 0; i < n; ++i) {
    if (next.q[i] != work.wanted[i]) next.v[i] += (next.q[i] - work.wanted[i] - work.pushed[i]) / work.h;
  }
  next.frames = system_->transported(next.frames, work.wanted, next.q);
}

bool Response::gained_energy(const Work& work, const State& next) const {
  // Contacts take energy away, but for what driven particles give; what gains without them was refused before.
  // Pushing apart what was too near lifts weight; that is not the contacts' doing.
  const double lifted = (system_->force.head(work.pushed.size()).array() * work.pushed.array()).abs().sum();
  return energies(*system_, next).total() > work.energy + work.slack + lifted + std::max(work.driven, 0.0);
}

bool Response::impulses(Work& work, std::vector<Contact> known, int passes) {
  const ImpulseRule rule{contact_.restitution, contact_.friction, thickness_, 2 * gravity_.norm() * work.h * work.h,
                         0.5 * recovery(work.h)};
  VectorX& x1 = work.next->q;
  double driven = 0;
  const Motion motion{&work.state->q, &x1, &work.pushed, &inverse_mass_, &driven};
  std::vector<char> touched(system_->particle_count(), 0);
  const auto resolve_all = [&](const std::vector<Contact>& contacts) {
    bool any = false;
    for (const Contact& contact : contacts) {
      if (!resolve(contact, rule, motion)) continue;
      any = true;
      for (std::size_t c = 0; c < contact.corners; ++c) touched[contact.particles[c]] = 1;
    }
    return any;
  };
  std::vector<Contact> found;
  for (int pass = 0;; ++pass) {
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      if (!resolve_all(known)) break;
    }
    finder_.moved(x1, touched);
    std::fill(touched.begin(), touched.end(), char{0});
    finder_.find(x1, found, *work.counts);
    if (found.empty() || pass == passes) {
      work.driven += driven / (work.h * work.h);
      return found.empty();
    }
    ++work.counts->passes;
    known.insert(known.end(), found.begin(), found.end());
  }
}

void Response::measure_hold(const VectorX& q) {
  hold_.assign(system_->particle_count(), Eigen::Matrix3f::Zero());
  for (const Length& element : system_->lengths) {
    const Vector3 along = (position(q, element.b) - position(q, element.a)).normalized();
    const Eigen::Matrix3f stiffness = (element.stiffness * along * along.transpose()).cast<float>();
    hold_[element.a] += stiffness;
    hold_[element.b] += stiffness;
  }
  for (const Joint& joint : system_->joints) {
    // A bend of one segment's length: the middle moves against both of its neighbours.
    const double length = 0.5 * (position(q, joint.p[2]) - position(q, joint.p[0])).norm();
    const double across = joint.bend / (length * length + 1e-300);
    for (std::size_t k = 0; k < 3; ++k)
      hold_[joint.p[k]] += static_cast<float>((k == 1 ? 4 : 1) * across) * Eigen::Matrix3f::Identity();
  }
}

ContactTerm Response::term_of(const Contact& contact, const Work& work) const {
  ContactTerm term;
  term.particles = contact.particles;
  term.corners = contact.corners;
  term.omega = contact.omega;
  term.normal = contact.normal;
  term.stick = kStickSpeed * work.h;
  double softness = 0;
  for (std::size_t c = 0; c < contact.corners; ++c) {
    const Index p = contact.particles[c];
    const double inverse = inverse_mass_.segment<3>(3 * static_cast<Eigen::Index>(p)).maxCoeff();
    if (inverse > 0) {
      // A cable is stiff along itself and soft across, which is where it is mostly touched.
      const double hold =
          1 / (inverse * work.h * work.h) + contact.normal.dot(hold_[p].cast<double>() * contact.normal);
      softness += contact.omega[c] * contact.omega[c] / hold;
    }
  }
  term.stiffness = softness > 0 ? kStiffer / softness : 0;
  // Elements may come as near as the thickness; what is nearer already moves out slowly.
  const double room = thickness_ - contact.gap;
  term.goal = room > 0 ? pushed_out(room, work.h) : room;
  // The speed of impact is that before the step: at its end, what leans on a contact would seem to fly into it.
  const double approach = work.h * contact.normal.dot(relative_motion(term, work.state->v));
  if (approach < -2 * gravity_.norm() * work.h * work.h)
    term.goal = std::max(term.goal, -contact_.restitution * approach);
  return term;
}

bool Response::solve_with_contacts(Work& work, Stepper& stepper, std::vector<Contact> contacts) {
  measure_hold(work.state->q);
  std::vector<ContactTerm> terms;
  std::vector<std::pair<PairKey, std::size_t>> term_of_pair;  // sorted whenever it is searched
  const auto add = [&](const Contact& contact) {
    terms.push_back(term_of(contact, work));
    // What its spring holds where elements are nearer than the thickness.
    if (contact.gap < thickness_) {
      const double out = pushed_out(thickness_ - contact.gap, work.h);
      work.slack += 0.5 * terms.back().stiffness * out * out;
    }
    term_of_pair.emplace_back(key(contact.pair), terms.size() - 1);
  };
  terms.reserve(contacts.size() + contacts.size() / 4);
  term_of_pair.reserve(terms.capacity());
  for (const Contact& contact : contacts) add(contact);
  contacts = {};
  work.wanted = {};
  const std::vector<char> all(system_->particle_count(), 1);
  std::vector<Contact> found;
  double driven = 0;
  for (int solve = 0; solve < kSolves; ++solve) {
    // What is left of the last try only takes room.
    const VectorX near = std::move(work.next->q);
    *work.next = {};
    const double before = work.times->contacts;
    Advance advance = [&] {
      const PhaseClock clock(work.times->contacts);
      return stepper.advance_with(*work.state, work.h, terms, near);
    }();
    work.times->response -= work.times->contacts - before;  // which goes on, and counts this too
    ++work.counts->solves;
    work.counts->newton_iterations += advance.iterations;
    trouble_.mover = advance.mover;
    if (!advance.converged) return false;
    *work.next = std::move(advance.state);
    driven = stepper.driven_work(*work.state, work.h, terms, *work.next);
    finder_.moved(work.next->q, all);
    finder_.find(work.next->q, found, *work.counts);
    // Friction changes how tension runs along a cable, and with it the forces that limit friction.
    double most = 0, change = 0;
    if (kFriction && contact_.friction > 0) {
      for (ContactTerm& term : terms) {
        const double slip = contact_.friction * normal_force(term, work.state->q, work.next->q);
        most = std::max(most, slip);
        change = std::max(change, std::abs(slip - term.slip));
        term.slip = slip;
      }
    }
    std::sort(term_of_pair.begin(), term_of_pair.end());
    const auto known = static_cast<std::ptrdiff_t>(term_of_pair.size());
    for (const Contact& contact : found) {
      const PairKey wanted = key(contact.pair);
      const auto known_end = term_of_pair.begin() + known;
      const auto same = std::lower_bound(term_of_pair.begin(), known_end, std::pair{wanted, std::size_t{0}});
      if (same == known_end || same->first != wanted) {
        add(contact);
      } else {
        // It turned on the way: where it touches now says more than where it would have touched.
        ContactTerm& term = terms[same->second];
        const double slip = term.slip;
        term = term_of(contact, work);
        term.slip = slip;
      }
    }
    const bool friction_known = change <= kLimitKnown * most;
    if (found.empty() && friction_known) break;
  }
  work.energy = std::max(work.energy, energies(*system_, *work.state).total() + driven);
  work.wanted = work.next->q;
  return true;
}

bool Response::is_held(Index particle) const {
  return (inverse_mass_.segment<3>(3 * static_cast<Eigen::Index>(particle)).array() == 0).all();
}

Vector3 Response::free_momentum(const std::vector<Index>& zone, const Work& work) const {
  Vector3 sum = Vector3::Zero();
  for (const Index p : zone) {
    const auto at = 3 * static_cast<Eigen::Index>(p);
    if (!is_held(p)) sum += system_->mass[at] * (position(work.next->q, p) - position(work.pushed, p));
  }
  return sum;
}

bool Response::freeze_zones(Work& work, std::vector<Contact> contacts) {
  // Each round joins particles that were apart, or ends: there are at most as many rounds as particles.
  ImpactZones zones(system_->particle_count());
  VectorX& x1 = work.next->q;
  while (!contacts.empty()) {
    for (const Contact& contact : contacts) {
      trouble_.left = contact;
      if (!zones.join(contact)) return false;  // a zone moves as one: only rounding can make its own parts meet
    }
    const auto groups = zones.zones();
    work.counts->zones = static_cast<int>(groups.size());
    for (const auto& zone : groups) {
      const Vector3 before = free_momentum(zone, work);
      if (!move_rigidly(zone, *system_, inverse_mass_, work.state->q, x1)) {
        const auto of_zone = [&](const Contact& c) { return zones.zone(c.particles[0]) == zone.front(); };
        trouble_.left = *std::find_if(contacts.begin(), contacts.end() - 1, of_zone);
        return false;
      }
      for (const Index p : zone) work.pushed.segment<3>(3 * static_cast<Eigen::Index>(p)).setZero();
      // What is driven carries the zone, and gives its free particles the momentum that they gain.
      const auto driven = std::find_if(zone.begin(), zone.end(), [&](Index p) { return is_held(p); });
      if (driven != zone.end()) {
        work.driven +=
            (free_momentum(zone, work) - before).dot(position(x1, *driven) - position(work.state->q, *driven)) /
            (work.h * work.h);
      }
    }
    finder_.begin(work.state->q, x1, 0);
    finder_.find(x1, contacts, *work.counts);
  }
  return true;
}

}  // namespace touchstone::sim
