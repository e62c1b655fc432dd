// SPDX-License-Identifier: MIT
#include "body_contact/body_attempt.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace touchstone::sim {
namespace {

constexpr double kMostTurn = 1;  // rad, in a substep: the motion that is stored is one arc

// Elements keep this fraction of the thickness between them; where they are nearer, this fraction of what is missing is
// restored in a whole step of the scene, and less in a shorter one.
constexpr double kGapKept = 0.5, kRecovery = 0.2;

// In units of gravity's displacement in a step: a slower approach is that of bodies at rest, and does not bounce.
constexpr double kResting = 2;

constexpr int kPasses = 12;  // of impulses and exact answers
constexpr int kSweeps = 400, kPushSweeps = 20;
constexpr double kTolerance = 1e-7;  // of the thickness, in a substep: what sweeps may leave

// Of the distance that is kept: what contacts part by, in the substep, that touch although impulses have answered them.
// It doubles with each pass. More than is needed throws a body at rest upwards.
constexpr double kLeastExtra = 0.005;

// Contacts of one pair of bodies are one if they are nearer to each other than this fraction of the thickness and their
// normals are as near.
constexpr double kSamePosition = 0.02, kSameNormal = 1e-3;

Vector3 turn_of(const Pose& from, const Pose& to) { return turn_between(from.q, to.q); }

}  // namespace

bool BodyResponse::Attempt::begin() {
  const PhaseClock clock(result_.times.integration);
  const double h = step_->h;
  free_ = start_->bodies;
  system_->accelerate(free_, h);
  if (system_->most_turn(free_, h) > kMostTurn) return false;
  free_movers_.bodies.assign(bodies_, {});
  for (std::size_t i = 0; i < bodies_; ++i) {
    const RigidBody& body = system_->bodies()[i];
    const BodyState& from = start_->bodies[i];
    BodyState& to = free_[i];
    MovingBody& mover = free_movers_.bodies[i];
    if (body.is_free()) {
      to.pose.p = from.pose.p + 0.5 * h * (from.velocity + to.velocity);
      to.pose.q = free_spin(body.inertia, from.pose.q, to.momentum, h);
      const Matrix3 turn = matrix_of(from.pose.q);
      mover.inverse_mass = 1 / body.mass;
      mover.inverse_inertia = turn * body.inertia.inverse * turn.transpose();
    } else {
      to.pose = system_->prescribed(i, step_->end_time);
      if (dot(from.pose.q, to.pose.q) < 0) to.pose.q = negated(to.pose.q);
    }
    mover.velocity = body.is_free() ? to.velocity : Vector3((to.pose.p - from.pose.p) / h);
    const Vector3 turn = turn_of(from.pose, to.pose);
    const double end = step_->end_time;
    if (!body.is_free() && system_->prescribed_turn(i, end - h, end) > kMostTurn) return false;
    mover.spin = turn / h;
  }
  free_movers_.particles = (step_->x1 - *step_->x0) / h;
  free_movers_.inverse_mass = r_->inverse_mass_;
  held_.assign(bodies_, 0);
  result_.end.bodies = free_;
  result_.x1 = step_->x1;
  result_.velocity_change = VectorX::Zero(step_->x1.size());
  return true;
}

/// Those that come within the thickness if nothing answers them.
void BodyResponse::Attempt::find_contacts() {
  const PhaseClock clock(result_.times.response);
  const double h = step_->h, thickness = r_->thickness_;
  const auto pairs = r_->colliders_->body_candidates(motion(), thickness);
  double fastest = 0;
  for (std::size_t i = 0; i < bodies_; ++i) {
    const MovingBody& m = free_movers_.bodies[i];
    fastest = std::max(fastest, m.velocity.norm() + m.spin.norm() * system_->bodies()[i].reach);
  }
  for (Eigen::Index p = 0; p + 2 < free_movers_.particles.size(); p += 3) {
    fastest = std::max(fastest, free_movers_.particles.segment<3>(p).norm());
  }
  const double reach = thickness + 2 * fastest * h;
  using ContactKey = std::array<long long, 8>;
  std::set<ContactKey> known;
  const auto rounded = [](double x, double unit) { return std::llround(std::clamp(x / unit, -1e15, 1e15)); };
  for (const Pair& pair : pairs) {
    const auto near = closest(*r_->colliders_, pair, motion(), reach);
    if (!near) continue;
    const double along = near->normal.dot(free_movers_.approach(*near));
    if (!(near->gap + h * std::min(along, 0.0) < thickness)) continue;
    const ContactKey key{near->a.body,
                         near->b.body,
                         rounded(near->point.x(), kSamePosition * thickness),
                         rounded(near->point.y(), kSamePosition * thickness),
                         rounded(near->point.z(), kSamePosition * thickness),
                         rounded(near->normal.x(), kSameNormal),
                         rounded(near->normal.y(), kSameNormal),
                         rounded(near->normal.z(), kSameNormal)};
    if (near->a.is_body() && near->b.is_body() && !known.insert(key).second) continue;
    SolverContact contact;
    contact.contact = *near;
    const auto old = std::lower_bound(start_->forces.begin(), start_->forces.end(), pair,
                                      [](const ContactForce& f, const Pair& p) { return f.pair < p; });
    if (old != start_->forces.end() && old->pair == pair) {
      contact.normal_impulse = std::max(0.0, h * old->force.dot(near->normal));
      contact.friction = h * old->force - h * old->force.dot(near->normal) * near->normal;
      if (contact.normal_impulse == 0 || !(r_->contact_.friction > 0)) contact.friction.setZero();
    }
    add(std::move(contact));
  }
  result_.counts.close = contacts_.size();
}

void BodyResponse::Attempt::set_targets() {
  const double h = step_->h;
  for (SolverContact& c : contacts_) {
    c.room = std::max(c.contact.gap - kept_, 0.0);
    c.least = c.extra - c.room / h;
    const double missing = c.contact.at_touch ? 0 : std::max(kept_ - c.contact.gap, 0.0);
    c.push = missing > 0 ? kRecovery * missing / r_->time_step_ : -c.room / h;
  }
}

void BodyResponse::Attempt::solve(double restitution) {
  const double h = step_->h;
  movers_ = free_movers_;
  std::fill(held_.begin(), held_.end(), char{0});
  for (SolverContact& c : contacts_) {
    c.bounce.setZero();
    for (const ContactSide* side : {&c.contact.a, &c.contact.b}) {
      if (side->is_body()) held_[side->body] = 1;
    }
  }
  const SolverRule rule{r_->contact_.friction, kTolerance * r_->thickness_ / h, kSweeps};
  if (restitution > 0) {
    const double resting = kResting * system_->gravity().norm() * h;
    result_.counts.sweeps += bounce(movers_, contacts_, {restitution, h, resting, rule});
  }
  result_.counts.sweeps += solve_contacts(movers_, contacts_, rule);
  pushes_ = free_movers_;
  for (MovingBody& body : pushes_.bodies) body.velocity = body.spin = Vector3::Zero();
  pushes_.particles.setZero();
  const bool any = std::any_of(contacts_.begin(), contacts_.end(), [](const SolverContact& c) { return c.push > 0; });
  if (any) solve_pushes(pushes_, contacts_, kPushSweeps);
}

/// The end of the substep by the velocities of the solver.
void BodyResponse::Attempt::move() {
  const double h = step_->h;
  unpushed_ = free_;
  for (std::size_t i = 0; i < bodies_; ++i) {
    const RigidBody& body = system_->bodies()[i];
    BodyState& to = result_.end.bodies[i];
    to = free_[i];
    if (!body.is_free() || !held_[i]) continue;
    const BodyState& from = start_->bodies[i];
    to.velocity = movers_.bodies[i].velocity;
    const Vector3 gained = movers_.bodies[i].spin - free_movers_.bodies[i].spin;
    to.momentum = free_[i].momentum + angular_momentum(body.inertia, from.pose.q, gained);
    to.pose.p = from.pose.p + h * to.velocity;
    Quaternion q = from.pose.q;
    if (most_turn(body.inertia, to.momentum, h) <= 2 * kMostTurn) q = free_spin(body.inertia, q, to.momentum, h);
    to.pose.q = dot(q, from.pose.q) < 0 ? negated(q) : q;
    unpushed_[i] = to;
    to.pose.p += h * pushes_.bodies[i].velocity;
    const Vector3 correction = h * pushes_.bodies[i].spin;
    if (!correction.isZero(0)) q = normalised(product(rotation_by(correction), q));
    to.pose.q = dot(q, from.pose.q) < 0 ? negated(q) : q;
  }
  if (step_->x1.size() == 0) return;
  const VectorX change = movers_.particles - free_movers_.particles;
  for (Eigen::Index i = 0; i < change.size(); ++i) {
    // A coordinate that nothing pushes keeps its bits.
    const double by = change[i] + pushes_.particles[i];
    result_.x1[i] = by == 0 ? step_->x1[i] : step_->x1[i] + h * by;
    result_.velocity_change[i] = change[i];
  }
}

/// Of the motion as it stands. Particles have answered each other before bodies push them: so those that bodies move
/// are asked about again, and what they are pushed onto carries them.
BodyResponse::Touches BodyResponse::Attempt::touches() {
  Touches touches = r_->touches(motion());
  std::vector<char> moved(static_cast<std::size_t>(result_.x1.size()) / 3, 0);
  bool any = false;
  for (Eigen::Index i = 0; i < result_.x1.size(); ++i) {
    if (result_.x1[i] == step_->x1[i]) continue;
    any = true;
    moved[static_cast<std::size_t>(i) / 3] = 1;
  }
  if (!any) return touches;
  std::vector<Pair> pairs = r_->colliders_->candidates(*step_->x0, result_.x1, 0);
  std::erase_if(pairs, [&](const Pair& pair) {
    const auto corners = r_->colliders_->corners(pair);
    return std::none_of(corners.begin(), corners.begin() + corner_count(pair.kind), [&](Index p) { return moved[p]; });
  });
  // The proof of bodies has no pairs of particles.
  const Touches more = r_->touches(pairs, motion());
  count_asked(more);
  touches.found.insert(touches.found.end(), more.found.begin(), more.found.end());
  std::stable_sort(touches.found.begin(), touches.found.end(),
                   [](const auto& a, const auto& b) { return a.second.toi < b.second.toi; });
  return touches;
}

void BodyResponse::Attempt::count_asked(const Touches& touches) {
  BodyCounts& counts = result_.counts;
  counts.queries += touches.pairs;
  count(touches.levels, counts.levels);
}

/// More contacts, or more distance for those that were not enough.
void BodyResponse::Attempt::answer_touches(const Touches& touches) {
  const double h = step_->h;
  for (const auto& [pair, answer] : touches.found) {
    bool known = false;
    for (SolverContact& c : contacts_) {
      if (c.contact.pair != pair) continue;
      known = true;
      c.extra = std::max(2 * c.extra, kLeastExtra * kept_ / h);
    }
    if (known) continue;
    SolverContact contact;
    contact.contact = touching(*r_->colliders_, pair, motion(), answer);
    const double along =
        contact.contact.normal.dot((movers_.bodies.empty() ? free_movers_ : movers_).approach(contact.contact));
    contact.contact.gap = std::max(0.0, -along) * answer.toi * h;
    add(std::move(contact));
  }
}

std::optional<Refusal> BodyResponse::Attempt::settle(double restitution) {
  Touches found;
  restored_ = restored_particles_ = 0;
  result_.counts.zones = 0;
  carried_ = {};
  merged_.clear();
  for (int pass = 0;; ++pass) {
    if (!contacts_.empty()) {
      const PhaseClock clock(result_.times.contacts);
      set_targets();
      solve(restitution);
      move();
    }
    if (system_->most_turn(result_.end.bodies, step_->h) > 2 * kMostTurn) return Refusal{Cause::turns_too_far};
    double asking = 0;
    {
      const PhaseClock clock(asking);
      found = touches();
    }
    (found.found.empty() ? result_.times.proof : result_.times.response) += asking;
    result_.counts.contacts += found.found.size();
    if (found.found.empty()) {
      result_.counts.pairs = found.pairs;
      result_.counts.proof = found.levels;
      result_.counts.separations = found.separations;
      if (!contacts_.empty()) {
        const PhaseClock clock(result_.times.contacts);
        restore_angular_momentum();
      }
      return std::nullopt;
    }
    count_asked(found);
    if (pass == kPasses) break;
    ++result_.counts.passes;
    answer_touches(found);
  }
  const PhaseClock clock(result_.times.response);
  if (step_->may_merge && merge(found)) {
    restore_angular_momentum();
    return std::nullopt;
  }
  const auto& [pair, answer] = found.found.front();
  return Refusal{Cause::not_resolved, pair, touching(*r_->colliders_, pair, motion(), answer).point};
}

BodyResult BodyResponse::Attempt::run() {
  kept_ = kGapKept * r_->thickness_;
  if (!begin()) {
    result_.refused = Refusal{Cause::turns_too_far};
    return std::move(result_);
  }
  find_contacts();
  const std::vector<SolverContact> found = contacts_;
  const double restitution = r_->contact_.restitution;
  const auto settled = [&](double e) {
    const auto refused = settle(e);
    return !refused && gained_energy() ? std::optional(Refusal{Cause::gained_energy}) : refused;
  };
  result_.refused = settled(restitution);
  if (restitution > 0 && result_.refused && result_.refused->cause == Cause::gained_energy) {
    contacts_ = found;
    result_.refused = settled(0);
  }
  measure_flows();
  for (const SolverContact& c : contacts_) {
    // Bounces are over; the next substep starts from the forces of contacts that last.
    const Vector3 impulse = c.normal_impulse * c.contact.normal + c.friction;
    if (c.normal_impulse > 0 && !c.contact.at_touch) result_.end.forces.push_back({c.contact.pair, impulse / step_->h});
  }
  if (step_->keep_contacts) {
    for (const SolverContact& c : contacts_) {
      if (c.contact.at_touch || !c.impulse().isZero(0)) result_.contacts.push_back(c.contact);
    }
  }
  std::sort(result_.end.forces.begin(), result_.end.forces.end(),
            [](const ContactForce& a, const ContactForce& b) { return a.pair < b.pair; });
  return std::move(result_);
}

}  // namespace touchstone::sim
