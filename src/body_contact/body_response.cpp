// SPDX-License-Identifier: MIT
#include "body_contact/body_response.hpp"

#include <Eigen/Geometry>

#include <touchstone/curved.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "linear/union_find.hpp"

namespace touchstone::sim {
namespace {

constexpr double kMostTurn = 1;  // rad, in a substep: the motion that is stored is one arc

// Elements keep this part of the thickness between them; where they are nearer, this part of what is missing is restored
// in a whole step of the scene, and less in a shorter one.
constexpr double kGapKept = 0.5, kRecovery = 0.2;

// In units of gravity's displacement in a step: a slower approach is that of bodies at rest, and does not bounce.
constexpr double kResting = 2;

constexpr double kEdgesPerThickness = 50;  // the default thickness, as a fraction of the shortest edge that moves

constexpr int kPasses = 12;  // of impulses and exact answers
constexpr int kSweeps = 400, kPushSweeps = 20;
constexpr double kTolerance = 1e-7;  // of the thickness, in a substep: what sweeps may leave

// Contacts of one pair of bodies nearer to each other than this part of the thickness, with normals as near, are one.
constexpr double kSamePlace = 0.02, kSameNormal = 1e-3;

// Relative: rounding of energies, and what the sweeps leave.
constexpr double kEnergyRounding = 1e-9;
constexpr double kSmallEnergy = 1e-12;  // J

Vector3 turn_of(const Pose& from, const Pose& to) { return turn_between(from.q, to.q); }

void count_level(Level level, LevelCounts& counts) noexcept {
  switch (level) {
    case Level::filter: ++counts.filter; break;
    case Level::bracket: ++counts.bracket; break;
    case Level::exact: ++counts.exact; break;
    case Level::oracle: ++counts.oracle; break;
  }
}

}  // namespace

/// One substep under way.
class BodyResponse::Attempt {
 public:
  Attempt(const BodyResponse& response, const BodiesState& start, const BodyStep& step)
      : r_(&response),
        system_(&response.colliders_->bodies()),
        start_(&start),
        step_(&step),
        bodies_(start.bodies.size()) {}

  BodyResult run();

 private:
  using Outcome = BodyResult::Outcome;

  bool begin();
  void find_contacts();
  void set_targets(double restitution);
  void solve();
  void move();
  Outcome settle(double restitution);
  bool answer_touches(const Touches& touches);
  bool merge(const Touches& touches);
  bool gained_energy() const;
  double kinetic(const BodyStates& states, const VectorX& velocity) const;
  BodyMotions motions() const { return {&start_->bodies, &result_.end.bodies, step_->x0, &result_.x1}; }
  void add(SolverContact contact) { contacts_.push_back(std::move(contact)); }

  const BodyResponse* r_;
  const BodySystem* system_;
  const BodiesState* start_;
  const BodyStep* step_;
  std::size_t bodies_;
  BodyResult result_;
  BodyStates free_;         // velocities and poses at the end without contacts
  Movers free_movers_;      // the velocities that lead there
  Movers movers_, pushes_;  // with contacts
  std::vector<char> held_;  // by body: it has contacts, and its velocity at the end is that of its displacement
  std::vector<SolverContact> contacts_;
  double kept_ = 0;  // m
};

bool BodyResponse::Attempt::begin() {
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
    if (!body.is_free() && turn.norm() > kMostTurn) return false;
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
  const double h = step_->h, thickness = r_->thickness_;
  const auto pairs = r_->colliders_->candidates(motions(), thickness);
  double fastest = 0;
  for (std::size_t i = 0; i < bodies_; ++i) {
    const MovingBody& m = free_movers_.bodies[i];
    fastest = std::max(fastest, m.velocity.norm() + m.spin.norm() * system_->bodies()[i].reach);
  }
  for (Eigen::Index p = 0; p + 2 < free_movers_.particles.size(); p += 3) {
    fastest = std::max(fastest, free_movers_.particles.segment<3>(p).norm());
  }
  const double reach = thickness + 2 * fastest * h;
  using Place = std::array<long long, 8>;
  std::set<Place> known;
  const auto rounded = [](double x, double unit) { return std::llround(std::clamp(x / unit, -1e15, 1e15)); };
  for (const BodyPair& pair : pairs) {
    const auto near = closest(*r_->colliders_, pair, motions(), reach);
    if (!near) continue;
    const double along = near->normal.dot(free_movers_.approach(*near));
    if (!(near->gap + h * std::min(along, 0.0) < thickness)) continue;
    const Place place{static_cast<long long>(near->a.body),
                      static_cast<long long>(near->b.body),
                      rounded(near->point.x(), kSamePlace * thickness),
                      rounded(near->point.y(), kSamePlace * thickness),
                      rounded(near->point.z(), kSamePlace * thickness),
                      rounded(near->normal.x(), kSameNormal),
                      rounded(near->normal.y(), kSameNormal),
                      rounded(near->normal.z(), kSameNormal)};
    const bool of_particles = near->a.body == kParticles || near->b.body == kParticles;
    if (!of_particles && !known.insert(place).second) continue;
    SolverContact contact;
    contact.contact = *near;
    const auto old = std::lower_bound(start_->forces.begin(), start_->forces.end(), pair,
                                      [](const ContactForce& f, const BodyPair& p) { return f.pair < p; });
    if (old != start_->forces.end() && old->pair == pair) {
      contact.normal_impulse = std::max(0.0, h * old->force.dot(near->normal));
      contact.friction = h * old->force - h * old->force.dot(near->normal) * near->normal;
      if (contact.normal_impulse == 0 || !(r_->contact_.friction > 0)) contact.friction.setZero();
    }
    add(std::move(contact));
  }
  result_.counts.close = contacts_.size();
}

void BodyResponse::Attempt::set_targets(double restitution) {
  const double h = step_->h;
  const double resting = kResting * system_->gravity().norm() * h;
  for (SolverContact& c : contacts_) {
    const double along = c.contact.normal.dot(free_movers_.approach(c.contact));
    // An approach that would use up the gap bounces; another is slowed down to what the gap has room for.
    const double room = std::max(c.contact.gap - kept_, 0.0) / h;
    c.least = -room;
    if (restitution > 0 && along < -resting && along < -room) c.least = -restitution * along;
    const double missing = c.contact.at_touch ? 0 : std::max(kept_ - c.contact.gap, 0.0);
    c.push = std::max(kRecovery * missing / r_->time_step_, -room);
    if (missing == 0) c.push = -room;
  }
}

void BodyResponse::Attempt::solve() {
  const double h = step_->h;
  movers_ = free_movers_;
  std::fill(held_.begin(), held_.end(), char{0});
  for (const SolverContact& c : contacts_) {
    for (const ContactSide* side : {&c.contact.a, &c.contact.b}) {
      if (side->count == 0) held_[side->body] = 1;
    }
  }
  const SolverRule rule{r_->contact_.friction, kTolerance * r_->thickness_ / h, kSweeps};
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
  for (std::size_t i = 0; i < bodies_; ++i) {
    const RigidBody& body = system_->bodies()[i];
    BodyState& to = result_.end.bodies[i];
    to = free_[i];
    if (!body.is_free() || !held_[i]) continue;
    const BodyState& from = start_->bodies[i];
    to.velocity = movers_.bodies[i].velocity;
    const Vector3 gained = movers_.bodies[i].spin - free_movers_.bodies[i].spin;
    to.momentum = free_[i].momentum + angular_momentum(body.inertia, from.pose.q, gained);
    to.pose.p = from.pose.p + h * (to.velocity + pushes_.bodies[i].velocity);
    Quaternion q = from.pose.q;
    if (most_turn(body.inertia, to.momentum, h) <= 2 * kMostTurn) q = free_spin(body.inertia, q, to.momentum, h);
    const Vector3 pushed = h * pushes_.bodies[i].spin;
    if (!pushed.isZero(0)) q = normalised(product(rotation_by(pushed), q));
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

/// More contacts, or more distance for those that were not enough. False when nothing can be done.
bool BodyResponse::Attempt::answer_touches(const Touches& touches) {
  const double h = step_->h;
  for (const auto& [pair, answer] : touches.found) {
    bool known = false;
    for (SolverContact& c : contacts_) {
      if (c.contact.pair != pair) continue;
      known = true;
      c.least += 0.5 * kept_ / h;
    }
    if (known) continue;
    SolverContact contact;
    contact.contact = touching(*r_->colliders_, pair, motions(), answer);
    const double along =
        contact.contact.normal.dot((movers_.bodies.empty() ? free_movers_ : movers_).approach(contact.contact));
    contact.contact.gap = std::max(0.0, -along) * answer.toi * h;
    contact.least = -std::max(contact.contact.gap - kept_, 0.0) / h;
    add(std::move(contact));
  }
  return true;
}

/// Bodies and particles that touch move on together, in this substep without turning, with the momentum that they have.
/// Their velocities afterwards are those of one rigid body with their momentum and angular momentum.
bool BodyResponse::Attempt::merge(const Touches& first) {
  const double h = step_->h;
  const std::size_t particles = static_cast<std::size_t>(step_->x1.size()) / 3;
  linear::UnionFind joined(bodies_ + particles);
  const auto node = [&](const OfBody& corner) {
    return static_cast<Index>(corner.body == kParticles ? bodies_ + corner.number : corner.body);
  };
  Touches touches = first;
  const BodyStates before = result_.end.bodies;
  const VectorX x_before = result_.x1;
  while (!touches.found.empty()) {
    bool grew = false;
    for (const auto& [pair, answer] : touches.found) {
      const auto corners = r_->colliders_->corners(pair);
      for (std::size_t c = 1; c < corner_count(pair.kind); ++c) grew |= joined.join(node(corners[0]), node(corners[c]));
    }
    if (!grew) return false;
    result_.end.bodies = before;
    result_.x1 = x_before;
    result_.counts.zones = 0;
    std::vector<std::vector<Index>> groups(bodies_ + particles);
    for (Index n = 0; n < groups.size(); ++n) groups[joined.root(n)].push_back(n);
    for (const auto& members : groups) {
      if (members.size() < 2) continue;
      ++result_.counts.zones;
      double mass = 0;
      Vector3 momentum = Vector3::Zero(), centre = Vector3::Zero();
      bool carried = false;
      Vector3 carrier = Vector3::Zero();
      for (const Index n : members) {
        const bool is_body = n < bodies_;
        const auto at = is_body ? 0 : 3 * static_cast<Eigen::Index>(n - bodies_);
        const bool held =
            is_body ? !system_->bodies()[n].is_free() : !(r_->inverse_mass_.segment<3>(at).array() > 0).all();
        if (held) {
          const Vector3 own = is_body ? Vector3((before[n].pose.p - start_->bodies[n].pose.p) / h)
                                      : Vector3((x_before.segment<3>(at) - step_->x0->segment<3>(at)) / h);
          const bool turns = is_body && before[n].pose.q != start_->bodies[n].pose.q;
          if (turns || (carried && own != carrier)) return false;
          carried = true;
          carrier = own;
          continue;
        }
        const double m = is_body ? system_->bodies()[n].mass : 1 / r_->inverse_mass_[at];
        const Vector3 x = is_body ? start_->bodies[n].pose.p : Vector3(step_->x0->segment<3>(at));
        const Vector3 v =
            is_body ? before[n].velocity : Vector3((x_before.segment<3>(at) - step_->x0->segment<3>(at)) / h);
        mass += m;
        momentum += m * v;
        centre += m * x;
      }
      const Vector3 velocity = carried ? carrier : Vector3(momentum / mass);
      Vector3 spin = Vector3::Zero();
      if (!carried) {
        centre /= mass;
        Vector3 angular = Vector3::Zero();
        Matrix3 inertia = Matrix3::Zero();
        for (const Index n : members) {
          const bool is_body = n < bodies_;
          const auto at = is_body ? 0 : 3 * static_cast<Eigen::Index>(n - bodies_);
          const double m = is_body ? system_->bodies()[n].mass : 1 / r_->inverse_mass_[at];
          const Vector3 arm = (is_body ? start_->bodies[n].pose.p : Vector3(step_->x0->segment<3>(at))) - centre;
          const Vector3 v =
              is_body ? before[n].velocity : Vector3((x_before.segment<3>(at) - step_->x0->segment<3>(at)) / h);
          angular += m * arm.cross(v - velocity);
          inertia += m * (arm.squaredNorm() * Matrix3::Identity() - arm * arm.transpose());
          if (!is_body) continue;
          angular += before[n].momentum;
          const Matrix3 turn = matrix_of(start_->bodies[n].pose.q);
          inertia += turn * system_->bodies()[n].inertia.moments * turn.transpose();
        }
        spin = inertia.ldlt().solve(angular);
        if (!spin.allFinite()) return false;
      }
      for (const Index n : members) {
        const bool is_body = n < bodies_;
        if (is_body) {
          if (!system_->bodies()[n].is_free()) continue;
          BodyState& to = result_.end.bodies[n];
          const Pose& from = start_->bodies[n].pose;
          to.pose = {from.q, from.p + h * velocity};
          to.velocity = velocity + spin.cross(from.p - centre);
          to.momentum = angular_momentum(system_->bodies()[n].inertia, from.q, spin);
          continue;
        }
        const auto at = 3 * static_cast<Eigen::Index>(n - bodies_);
        if (!(r_->inverse_mass_.segment<3>(at).array() > 0).all()) continue;
        const Vector3 x0 = step_->x0->segment<3>(at);
        result_.x1.segment<3>(at) = x0 + h * velocity;
        const Vector3 v = carried ? velocity : Vector3(velocity + spin.cross(x0 - centre));
        result_.velocity_change.segment<3>(at) = v - (step_->x1.segment<3>(at) - x0) / h;
      }
    }
    touches = r_->touches(motions());
    result_.counts.queries += touches.pairs;
  }
  result_.counts.pairs = touches.pairs;
  result_.counts.proof = touches.levels;
  return true;
}

double BodyResponse::Attempt::kinetic(const BodyStates& states, const VectorX& velocity) const {
  double sum = system_->energies(states).kinetic;
  for (Eigen::Index i = 0; i < velocity.size(); ++i) {
    if (r_->inverse_mass_[i] > 0) sum += 0.5 * velocity[i] * velocity[i] / r_->inverse_mass_[i];
  }
  return sum;
}

/// Of bodies, and of the particles that they touch: gravity's work on bodies is in their potential energy, and that of
/// driven ones counts as given.
bool BodyResponse::Attempt::gained_energy() const {
  const double h = step_->h;
  const auto before = system_->energies(start_->bodies), after = system_->energies(result_.end.bodies);
  double work = 0, lift = 0;
  for (const SolverContact& c : contacts_) {
    const Vector3 impulse = c.normal_impulse * c.contact.normal + c.friction;
    const auto held = [&](const ContactSide& side) {
      if (side.count == 0) return !system_->bodies()[side.body].is_free();
      for (std::size_t i = 0; i < side.count; ++i) {
        if (r_->inverse_mass_.segment<3>(3 * static_cast<Eigen::Index>(side.particles[i])).maxCoeff() > 0) return false;
      }
      return true;
    };
    if (held(c.contact.a)) work += std::max(0.0, -impulse.dot(movers_.velocity(c.contact.a)));
    if (held(c.contact.b)) work += std::max(0.0, impulse.dot(movers_.velocity(c.contact.b)));
  }
  for (std::size_t i = 0; i < bodies_; ++i) {
    if (!system_->bodies()[i].is_free() || pushes_.bodies.empty()) continue;
    lift += system_->bodies()[i].mass * std::abs(system_->gravity().dot(pushes_.bodies[i].velocity)) * h;
  }
  const VectorX free_velocity = free_movers_.particles;
  const double particles_before = kinetic({}, free_velocity);
  const double particles_after = kinetic({}, free_velocity + result_.velocity_change);
  const double scale = before.kinetic + after.kinetic + std::abs(before.load) + std::abs(after.load) + particles_before;
  return after.kinetic + after.load + particles_after >
         before.kinetic + before.load + particles_before + work + lift + kEnergyRounding * scale + kSmallEnergy;
}

BodyResult::Outcome BodyResponse::Attempt::settle(double restitution) {
  Touches touches;
  for (int pass = 0;; ++pass) {
    if (pass == 0) {
      set_targets(restitution);
    }
    if (!contacts_.empty()) {
      solve();
      move();
    }
    if (system_->most_turn(result_.end.bodies, step_->h) > 2 * kMostTurn) return Outcome::too_fast;
    touches = r_->touches(motions());
    result_.counts.contacts += touches.found.size();
    if (touches.found.empty()) {
      result_.counts.pairs = touches.pairs;
      result_.counts.proof = touches.levels;
      return Outcome::done;
    }
    result_.counts.queries += touches.pairs;
    result_.counts.levels.filter += touches.levels.filter;
    result_.counts.levels.bracket += touches.levels.bracket;
    result_.counts.levels.exact += touches.levels.exact;
    if (pass == kPasses) break;
    ++result_.counts.passes;
    const bool first = contacts_.empty();
    answer_touches(touches);
    if (first) set_targets(restitution);
  }
  if (step_->may_merge && merge(touches)) return Outcome::done;
  result_.left = touches.found.front().first;
  const auto& [pair, answer] = touches.found.front();
  result_.point = touching(*r_->colliders_, pair, motions(), answer).point;
  return Outcome::not_resolved;
}

BodyResult BodyResponse::Attempt::run() {
  kept_ = kGapKept * r_->thickness_;
  if (!begin()) {
    result_.outcome = Outcome::too_fast;
    return std::move(result_);
  }
  find_contacts();
  const std::vector<SolverContact> found = contacts_;
  const double restitution = r_->contact_.restitution;
  result_.outcome = settle(restitution);
  if (result_.outcome == Outcome::done && gained_energy()) {
    result_.outcome = Outcome::gained_energy;
    if (restitution > 0) {
      contacts_ = found;
      const auto retried = settle(0);
      result_.outcome = retried == Outcome::done && gained_energy() ? Outcome::gained_energy : retried;
    }
  }
  for (const SolverContact& c : contacts_) {
    const Vector3 impulse = c.normal_impulse * c.contact.normal + c.friction;
    if (c.normal_impulse > 0 && !c.contact.at_touch) result_.end.forces.push_back({c.contact.pair, impulse / step_->h});
  }
  std::sort(result_.end.forces.begin(), result_.end.forces.end(),
            [](const ContactForce& a, const ContactForce& b) { return a.pair < b.pair; });
  return std::move(result_);
}

BodyResponse::BodyResponse(const BodyColliders& colliders, const System& system, const Settings& settings,
                           const linear::Cancellation& cancel)
    : colliders_(&colliders),
      contact_(settings.contact),
      time_step_(settings.time_step),
      thickness_(settings.contact.thickness),
      inverse_mass_(VectorX::Zero(static_cast<Eigen::Index>(3 * system.particle_count()))),
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

BodyResponse::Touches BodyResponse::touches(const BodyMotions& motions) const {
  const auto pairs = colliders_->candidates(motions, 0);
  Touches touches;
  touches.pairs = pairs.size();
  constexpr std::size_t kBlock = 256;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (i % kBlock == 0) cancel_->check();
    const Answer answer = solve(colliders_->query(pairs[i], motions));
    count_level(answer.level, touches.levels);
    if (answer.contact) touches.found.emplace_back(pairs[i], answer);
  }
  std::stable_sort(touches.found.begin(), touches.found.end(),
                   [](const auto& a, const auto& b) { return a.second.toi < b.second.toi; });
  return touches;
}

}  // namespace touchstone::sim
