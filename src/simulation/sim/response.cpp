// SPDX-License-Identifier: MIT
#include "sim/response.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "contact/impact_zones.hpp"
#include "dynamics/energy_budget.hpp"
#include "sim/contact_terms.hpp"

namespace touchstone::sim {
namespace {

constexpr int kSweeps = 4;  // over all contacts known so far, in each pass of impulses
constexpr int kSolves = 4;  // with the contacts in the potential, each with those that the one before it left

/// The energy that the end of a substep may have, J.
struct EnergyLimit {
  double highest = 0;      // of the energies before the substep and after it without contacts
  double tolerance = 0;    // a gain that counts as none
  double driven_work = 0;  // of driven particles by impulses and impact zones, which is no gain either
};

}  // namespace

/// One response under way: the end of the substep as it stands, and where the integrator would have it.
class Response::Attempt {
 public:
  Attempt(Response& response, Substep substep);

  ResponseResult run();

 private:
  std::optional<Cause> answer();
  void find(std::vector<Contact>& found);
  void keep_contacts(const std::vector<Contact>& contacts);
  void keep_each_pair_once();
  bool resolve_by_impulses(std::vector<Contact> known);
  bool solve_with_contacts(std::vector<Contact> contacts);
  bool resolve_by_zones(std::vector<Contact> contacts);

  void take_velocities();
  bool gained_energy() const;
  void measure_flows();
  Vector3 free_momentum(const std::vector<Index>& zone) const;

  Response* response_;
  const ResponseModel* model_;
  const State* start_;
  double h_;
  ResponseResult result_;
  VectorX integrated_;  // the positions that the integrator leads to, to which the velocities belong
  VectorX correction_;  // the part of the way from there that is no velocity
  EnergyLimit limit_;
  std::optional<Contact> left_;  // when not resolved: one of the contacts that are left
  LargestChange largest_change_;
  // When flows of energy are measured: the impulses, and the end of the solve with contacts, if there is one.
  ContactImpulses applied_;
  State solved_;
};

Response::Response(const Colliders& colliders, const System& system, const Settings& settings, NarrowPhase narrow_phase,
                   int threads, Stepper& stepper, const linear::Cancellation& cancel)
    : model_(colliders, system, settings),
      repels_(narrow_phase == NarrowPhase::exact),
      finder_(colliders, narrow_phase, threads, cancel),
      stepper_(&stepper) {}

ResponseResult Response::respond(Substep substep) { return Attempt(*this, std::move(substep)).run(); }

Response::Attempt::Attempt(Response& response, Substep substep)
    : response_(&response), model_(&response.model_), start_(substep.start), h_(substep.h) {
  result_.end = std::move(substep.end);
  result_.flows = substep.flows;
}

ResponseResult Response::Attempt::run() {
  {
    const PhaseClock clock(result_.times.response);
    if (const auto cause = answer()) {
      result_.refused = Refusal{.cause = *cause, .largest_change = largest_change_, .with_contacts = true};
      if (cause == Cause::not_resolved && left_) {
        result_.refused->pair = left_->pair;
        result_.refused->point = contact_point(*left_, start_->q);
      }
    }
  }
  if (response_->keeps_contacts_) keep_each_pair_once();
  const bool ended = !result_.refused || result_.refused->cause == Cause::gained_energy;
  if (ended && applied_.normal.size() > 0) measure_flows();
  return std::move(result_);
}

std::optional<Cause> Response::Attempt::answer() {
  const auto& passes = model_->colliders().passes();
  if (!passes.edge_edge && !passes.vertex_face && !passes.joints && !passes.points) return std::nullopt;
  ContactFinder& finder = response_->finder_;
  State& end = result_.end;
  finder.begin(start_->q, end.q, model_->thickness());
  // The paper has no repulsion: contacts that its solver does not find are not answered.
  std::vector<Contact> known, found;
  if (response_->repels_ && model_->contact().repulsion) known = finder.close(model_->thickness());
  result_.counts.close = known.size();
  keep_contacts(known);
  find(found);
  if (known.empty() && found.empty()) return std::nullopt;
  if (model_->contact().impulses) known.insert(known.end(), found.begin(), found.end());
  found = {};

  const Energies before = energies(model_->system(), *start_), without = energies(model_->system(), end);
  limit_ = {std::max(before.total(), without.total()), energy_tolerance(before, without), 0};
  integrated_ = end.q;
  correction_ = VectorX::Zero(model_->inverse_mass().size());
  if (response_->measures_flows_) applied_.reset(correction_.size());
  const bool stiff = std::any_of(known.begin(), known.end(), [&](const Contact& c) { return model_->is_stiff(c, h_); });
  if (!stiff) {
    const State free = end;
    if (resolve_by_impulses(known)) {
      take_velocities();
      if (!gained_energy()) return std::nullopt;
    }
    end = free;
    integrated_ = free.q;
    correction_.setZero();
    if (response_->measures_flows_) applied_.reset(correction_.size());
    limit_.driven_work = 0;
  }
  if (!solve_with_contacts(std::move(known))) return Cause::not_converged;
  if (!resolve_by_impulses({})) {
    find(found);
    if (!model_->contact().zones && !found.empty()) left_ = found.front();
    if (!model_->contact().zones || !resolve_by_zones(found)) return Cause::not_resolved;
  }
  take_velocities();
  return gained_energy() ? std::optional(Cause::gained_energy) : std::nullopt;
}

/// The contacts of the end as it stands.
void Response::Attempt::find(std::vector<Contact>& found) {
  response_->finder_.find(result_.end.q, found, result_.counts);
  keep_contacts(found);
}

void Response::Attempt::keep_contacts(const std::vector<Contact>& contacts) {
  if (!response_->keeps_contacts_) return;
  result_.contacts.insert(result_.contacts.end(), contacts.begin(), contacts.end());
}

/// A pair that touches is kept as the first touch that was found, and not as a pair that was close.
void Response::Attempt::keep_each_pair_once() {
  const auto key = [](const Contact& c) { return std::tuple(c.pair.kind, c.pair.i, c.pair.j); };
  const auto order = [&](const Contact& c) { return std::pair(key(c), c.time == 0); };
  auto& kept = result_.contacts;
  std::stable_sort(kept.begin(), kept.end(), [&](const Contact& a, const Contact& b) { return order(a) < order(b); });
  const auto same = [&](const Contact& a, const Contact& b) { return key(a) == key(b); };
  kept.erase(std::unique(kept.begin(), kept.end(), same), kept.end());
}

/// Impulses on the known contacts and on those that come up, pass by pass. False when contacts are left.
bool Response::Attempt::resolve_by_impulses(std::vector<Contact> known) {
  const ImpulseRule rule = model_->impulse_rule(h_);
  ContactFinder& finder = response_->finder_;
  VectorX& x1 = result_.end.q;
  double driven = 0;
  ContactImpulses* const impulses = response_->measures_flows_ ? &applied_ : nullptr;
  const Displacements motion{&start_->q, &x1, &correction_, &model_->inverse_mass(), &driven, impulses};
  std::vector<char> touched(model_->system().particle_count(), 0);
  const auto resolve_all = [&](const std::vector<Contact>& contacts) {
    bool any = false;
    for (const Contact& contact : contacts) {
      if (!apply_impulse(contact, rule, motion)) continue;
      any = true;
      for (std::size_t c = 0; c < contact.corners; ++c) touched[contact.particles[c]] = 1;
    }
    return any;
  };
  const int most_passes = model_->contact().impulses ? model_->contact().passes : 0;
  std::vector<Contact> found;
  for (int pass = 0;; ++pass) {
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      if (!resolve_all(known)) break;
    }
    finder.moved(x1, touched);
    std::fill(touched.begin(), touched.end(), char{0});
    find(found);
    if (found.empty() || pass == most_passes) {
      limit_.driven_work += driven / (h_ * h_);
      return found.empty();
    }
    ++result_.counts.passes;
    known.insert(known.end(), found.begin(), found.end());
  }
}

/// Solves the substep again with the contacts in its potential, until no other ones come up. False when Newton's method
/// does not converge.
bool Response::Attempt::solve_with_contacts(std::vector<Contact> contacts) {
  ContactTerms terms(*model_, *start_, h_, limit_.tolerance, contacts);
  contacts = {};  // memory: the terms have all of them
  integrated_ = {};
  const std::vector<char> all(model_->system().particle_count(), 1);
  std::vector<Contact> found;
  State& end = result_.end;
  double driven = 0;
  for (int solve = 0; solve < kSolves; ++solve) {
    const VectorX near = std::move(end.q);
    end = {};  // the end of the previous solve only takes room
    const double before = result_.times.contacts;
    Advance advance = [&] {
      const PhaseClock clock(result_.times.contacts);
      return response_->stepper_->advance_with(*start_, h_, terms.all(), near);
    }();
    result_.times.response -= result_.times.contacts - before;  // its clock goes on, and counts this too
    ++result_.counts.solves;
    result_.counts.newton_iterations += advance.iterations;
    largest_change_ = advance.largest_change;
    if (!advance.converged) return false;
    end = std::move(advance.state);
    driven = response_->stepper_->driven_work(*start_, h_, terms.all(), end);
    if (response_->measures_flows_) {
      result_.flows = advance.flows;
      result_.flows += terms.flows(end);
      solved_ = end;
    }
    response_->finder_.moved(end.q, all);
    find(found);
    const bool friction_settled = terms.update_friction(end.q);
    if (!model_->contact().impulses) found.clear();
    terms.take(found);
    if (found.empty() && friction_settled) break;
  }
  limit_.tolerance = terms.tolerance();
  limit_.highest = std::max(limit_.highest, energies(model_->system(), *start_).total() + driven);
  integrated_ = end.q;
  return true;
}

/// Lets particles in contact move as rigid bodies. False when contacts are left all the same.
bool Response::Attempt::resolve_by_zones(std::vector<Contact> contacts) {
  // Each round joins particles that were apart, keeps a particle's zone from turning for the first time, or ends: there
  // are at most twice as many rounds as particles.
  const System& system = model_->system();
  ImpactZones zones(system.particle_count());
  const bool thick = model_->colliders().has_separations();
  std::vector<std::size_t> stopped(thick ? system.particle_count() : 0, 0);  // the round that stopped its zone turning
  const auto may_turn = [&](const std::vector<Index>& zone) {
    return !thick || std::none_of(zone.begin(), zone.end(), [&](Index p) { return stopped[p] > 0; });
  };
  VectorX& x1 = result_.end.q;
  for (std::size_t round = 1; !contacts.empty(); ++round) {
    for (const Contact& contact : contacts) {
      left_ = contact;
      if (zones.join(contact)) continue;
      // A zone moves as one. Only a turn can bring elements of it within their separation, and only rounding can make
      // them meet.
      if (model_->colliders().separation(contact.pair) == 0) return false;
      if (std::size_t& since = stopped[contact.particles[0]]; since == 0) {
        since = round;
      } else if (since < round) {
        return false;
      }
    }
    const auto groups = zones.zones();
    result_.counts.zones = static_cast<int>(groups.size());
    for (const auto& zone : groups) {
      const Vector3 before = free_momentum(zone);
      const Turning turning = may_turn(zone) ? Turning::free : Turning::none;
      if (!move_rigidly(zone, system, model_->inverse_mass(), start_->q, x1, turning)) {
        const auto of_zone = [&](const Contact& c) { return zones.zone(c.particles[0]) == zone.front(); };
        left_ = *std::find_if(contacts.begin(), contacts.end() - 1, of_zone);
        return false;
      }
      for (const Index p : zone) correction_.segment<3>(3 * static_cast<Eigen::Index>(p)).setZero();
      // A driven particle carries the zone, and gives its free particles the momentum that they gain.
      const auto driven = std::find_if(zone.begin(), zone.end(), [&](Index p) { return model_->is_held(p); });
      if (driven != zone.end()) {
        const Vector3 gained = free_momentum(zone) - before;
        limit_.driven_work += gained.dot(position(x1, *driven) - position(start_->q, *driven)) / (h_ * h_);
        if (response_->measures_flows_) {
          applied_.normal.segment<3>(3 * static_cast<Eigen::Index>(*driven)) -= gained;
        }
      }
    }
    response_->finder_.begin(start_->q, x1, 0);
    find(contacts);
  }
  return true;
}

/// Gives the end the velocities that belong to its positions.
void Response::Attempt::take_velocities() {
  State& end = result_.end;
  const auto n = correction_.size();
  if (end.q.head(n) == integrated_.head(n)) return;
  for (Eigen::Index i = 0; i < n; ++i) {
    if (end.q[i] != integrated_[i]) end.v[i] += (end.q[i] - integrated_[i] - correction_[i]) / h_;
  }
  end.frames = model_->system().transported(end.frames, integrated_, end.q);
}

/// Contacts take energy away, but for what driven particles give; substeps that gain without contacts were refused
/// before. Position corrections lift weight, which is no gain either.
bool Response::Attempt::gained_energy() const {
  const System& system = model_->system();
  const double lifted = (system.force.head(correction_.size()).array() * correction_.array()).abs().sum();
  return energies(system, result_.end).total() >
         limit_.highest + limit_.tolerance + lifted + std::max(limit_.driven_work, 0.0);
}

/// The work of an impulse is that impulse times the mean of the velocities before and after it, which is the kinetic
/// energy that it gives. Before it are the velocities of the solve with contacts or, as an impulse acts for the whole
/// substep, those at its start. A held coordinate has the velocity of its path.
void Response::Attempt::measure_flows() {
  const System& system = model_->system();
  const State& end = result_.end;
  const auto n = correction_.size();
  const bool solved = solved_.q.size() > 0;
  const VectorX& before = solved ? solved_.v : start_->v;
  EnergyFlows& flows = result_.flows;
  for (Eigen::Index i = 0; i < n; ++i) {
    const bool held = model_->inverse_mass()[i] == 0;
    const double friction = applied_.friction[i];
    // Of zones is what impulses do not explain.
    const double normal = result_.counts.zones > 0 && !held
                              ? system.mass[i] * (end.q[i] - integrated_[i] - correction_[i]) - friction
                              : applied_.normal[i];
    const double speed = held ? end.v[i] : 0.5 * (before[i] + end.v[i]);
    flows.impacts += normal * speed / h_;
    flows.friction += friction * speed / h_;
    if (held) flows.driven -= (normal + friction) * speed / h_;
  }
  const auto without_motion = [&system](const State& state) {
    const Energies e = energies(system, state);
    return e.total() - e.kinetic;
  };
  if (solved) {
    flows.corrections += without_motion(end) - without_motion(solved_);
  } else if (!correction_.isZero(0)) {
    State uncorrected = end;
    uncorrected.q.head(n) -= correction_;
    uncorrected.frames = system.transported(end.frames, end.q, uncorrected.q);
    flows.corrections += without_motion(end) - without_motion(uncorrected);
  }
}

/// Of the displacements in this substep, kg m, but for a constant; held particles are left aside.
Vector3 Response::Attempt::free_momentum(const std::vector<Index>& zone) const {
  Vector3 sum = Vector3::Zero();
  for (const Index p : zone) {
    const auto at = 3 * static_cast<Eigen::Index>(p);
    if (!model_->is_held(p)) {
      sum += model_->system().mass[at] * (position(result_.end.q, p) - position(correction_, p));
    }
  }
  return sum;
}

}  // namespace touchstone::sim
