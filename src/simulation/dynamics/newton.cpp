// SPDX-License-Identifier: MIT
#include "dynamics/newton.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dynamics/newton_matrix.hpp"
#include "dynamics/rounding.hpp"
#include "dynamics/watchdog.hpp"
#include "scene/features.hpp"

namespace touchstone::sim {
namespace {

// Iterations; scenes converge in 3 to 15, and a substep that needs more than this is cheaper in two halves.
constexpr int kMostIterations = 100;

// The line search. A step length of 2^-30 moves nothing that the tolerance would see.
constexpr int kMostBacktracks = 30;
constexpr int kMostDoublings = 10;
constexpr double kSufficientDecrease = 1e-4;  // Armijo's fraction of the decrease that the slope promises

// Rounding. The terms of the potential are sums of products of a few factors: 64 epsilon of their sum of magnitudes is
// far more than sums of that many terms lose, as their errors have either sign.
constexpr double kPotentialNoise = 64 * kEpsilon;
// A step of fewer units in the last place of the largest coordinate than this is lost in the rounding of strains.
constexpr double kLeastStep = 16;

// Iterations of cloth without a try of the exact Hessian, after one in which it was not positive definite.
constexpr int kSkipped = 5;

// Tolerances: a step of up to this many of them ends the search where rounding hides its decrease.
constexpr double kFlat = 1000;

struct PotentialValue {
  double value = 0;  // J
  double noise = 0;  // J: the part that may be rounding
};

/// A point of the search with its potential, friction and direction.
struct Iterate {
  VectorX q;
  Frames frames;
  PotentialValue potential;
  std::vector<Vector3> pulls;  // of friction, for each contact; empty without friction
  VectorX direction;           // Newton's
  double slope = 0;            // J: of the potential along the direction
  double noise = 0;            // J: differences of the potential below this mean nothing
};

/// A point of the line through an iterate.
struct Trial {
  double step_length = 0;  // 1: Newton's whole step
  VectorX q;
  Frames frames;
  PotentialValue potential;
};

/// The first and second derivatives at an iterate. The second ones stay in the matrix.
struct Assembly {
  bool positive_definite = false;
  bool projected = false;  // the Hessian, because the exact one is not positive definite
  VectorX gradient;
  double stored_force = 0;  // N: the sum of magnitudes of the elements' and contacts' forces
};

/// The length of Newton's step, and the lengths that are too short to matter, m.
struct StepSize {
  double reach = 0;   // of Newton's whole step
  double enough = 0;  // a reach of no more than this is convergence
  double ulp = 0;     // of the largest coordinate
};

}  // namespace

/// One minimisation under way: assemble, find a step, accept it, until it has converged.
class Newton::Descent {
 public:
  Descent(const Newton& newton, const Stage& stage, const VectorX& guess, const VectorX& q, const Frames& frames);

  NewtonResult run();
  Iterate& iterate() noexcept { return here_; }

 private:
  enum class Search : std::uint8_t { accepted, converged, failed };

  PotentialValue potential(const VectorX& q, const Frames& frames) const;
  Iterate start(const VectorX& guess, const VectorX& q, const Frames& frames) const;

  Assembly assemble();
  bool factorise(Hessian hessian, VectorX& gradient);
  void add_contacts(VectorX& gradient);
  bool find_direction(const Assembly& assembly, StepSize& size);

  Search advance(bool projected, StepSize size, NewtonResult& result);
  Trial trial(double step_length) const;
  double sufficient(double step_length) const;
  bool decreases(const Trial& trial) const;
  bool backtrack(Trial& best) const;
  void extend(Trial& best) const;
  bool is_flat(const Trial& best, const StepSize& size) const;
  void accept(Trial trial);
  void climb(Trial trial);

  double reach_of(const VectorX& direction) const;
  LargestChange largest_change() const;

  const Newton* newton_;
  const Stage* stage_;
  Eigen::Index particles_;  // coordinates of particles, which come before the angles
  double inverse_;          // 1 / span^2
  VectorX diagonal_;        // of inertia and drag, kg/s^2
  bool friction_ = false;
  int skipped_ = 0;  // iterations to come that use the projected Hessian without a try of the exact one
  Iterate here_;
  Watchdog<Iterate> watchdog_;
};

Newton::Descent::Descent(const Newton& newton, const Stage& stage, const VectorX& guess, const VectorX& q,
                         const Frames& frames)
    : newton_(&newton),
      stage_(&stage),
      particles_(static_cast<Eigen::Index>(3 * newton.system_->particle_count())),
      inverse_(1 / (stage.span * stage.span)),
      here_(start(guess, q, frames)) {}

PotentialValue Newton::Descent::potential(const VectorX& q, const Frames& frames) const {
  const Stage& stage = *stage_;
  const double drag_factor = newton_->drag_;
  const auto mass = newton_->system_->mass.array();
  const VectorX moved = q - stage.base;
  const double inertia =
      0.5 / (stage.span * stage.span) * (mass * (moved - stage.span * stage.base_velocity).array().square()).sum();
  const double drag = 0.5 * drag_factor / stage.span * (mass * moved.array().square()).sum();
  const double load = (newton_->system_->force.array() * moved.array()).sum();
  const double stored = newton_->energy_.value(q, frames, stage.time, stage.strains);
  double contact = 0;
  for (const ContactTerm& term : stage.contacts) contact += contact_value(term, stage.base, q);
  return {inertia + drag - load + stored + contact,
          kPotentialNoise * (inertia + drag + std::abs(load) + stored + contact)};
}

/// The better of two: the guess, and the positions before with only the prescribed coordinates moved.
Iterate Newton::Descent::start(const VectorX& guess, const VectorX& q, const Frames& frames) const {
  const System& system = *newton_->system_;
  VectorX still = q;
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    if (system.fixed[static_cast<std::size_t>(i)]) still[i] = guess[i];
  }
  Iterate at_still{still, system.transported(frames, q, still), {}, {}, {}, 0, 0};
  Iterate at_guess{guess, system.transported(frames, q, guess), {}, {}, {}, 0, 0};
  for (Iterate* const iterate : {&at_still, &at_guess}) iterate->potential = potential(iterate->q, iterate->frames);
  const double value = at_still.potential.value;
  return !std::isfinite(value) || at_guess.potential.value <= value ? at_guess : at_still;
}

NewtonResult Newton::Descent::run() {
  NewtonResult result;
  NewtonMatrix& matrix = *newton_->matrix_;
  if (!std::isfinite(here_.potential.value)) return result;
  if (matrix.free_count() == 0) {
    result.converged = true;
    return result;
  }
  diagonal_ = (inverse_ + newton_->drag_ / stage_->span) * newton_->system_->mass;
  matrix.set_contacts(stage_->contacts);
  friction_ = kFriction && std::any_of(stage_->contacts.begin(), stage_->contacts.end(),
                                       [](const ContactTerm& term) { return term.slip > 0; });
  if (friction_) {
    for (const ContactTerm& term : stage_->contacts) here_.pulls.push_back(friction_pull(term, stage_->base, here_.q));
  }
  for (result.iterations = 1; result.iterations <= kMostIterations; ++result.iterations) {
    newton_->cancel_->check();
    const Assembly assembly = assemble();
    if (assembly.projected) ++result.projected;
    if (!assembly.positive_definite) return result;
    StepSize size;
    if (!find_direction(assembly, size)) return result;
    switch (advance(assembly.projected, size, result)) {
      case Search::accepted: break;
      case Search::converged: result.converged = true; return result;
      case Search::failed: result.largest_change = largest_change(); return result;
    }
  }
  result.largest_change = largest_change();
  return result;
}

Assembly Newton::Descent::assemble() {
  Assembly assembly;
  assembly.gradient = VectorX::Zero(here_.q.size());
  // Cloth in compression has an indefinite Hessian, mostly for some iterations to come.
  const bool skips = kCloth && skipped_ > 0;
  assembly.positive_definite = factorise(skips ? Hessian::projected : Hessian::exact, assembly.gradient);
  assembly.projected = skips;
  assembly.stored_force = assembly.gradient.lpNorm<1>();
  if (skips) {
    --skipped_;
  } else if (!assembly.positive_definite) {
    if (!newton_->system_->cloth.membranes.empty()) skipped_ = kSkipped;
    assembly.projected = true;
    VectorX ignored = VectorX::Zero(here_.q.size());
    assembly.positive_definite = factorise(Hessian::projected, ignored);
  }
  if (!assembly.positive_definite) return assembly;
  const VectorX& mass = newton_->system_->mass;
  const VectorX moved = here_.q - stage_->base;
  assembly.gradient += inverse_ * mass.cwiseProduct(moved - stage_->span * stage_->base_velocity) +
                       newton_->drag_ / stage_->span * mass.cwiseProduct(moved) - newton_->system_->force;
  return assembly;
}

/// Adds the forces of elements and contacts to the gradient. False when the matrix is not positive definite.
bool Newton::Descent::factorise(Hessian hessian, VectorX& gradient) {
  NewtonMatrix& matrix = *newton_->matrix_;
  matrix.start(diagonal_);
  newton_->energy_.derivatives(here_.q, here_.frames, stage_->time, stage_->strains, hessian, gradient, &matrix,
                               watchdog_.tensions());
  add_contacts(gradient);
  return matrix.factorise();
}

void Newton::Descent::add_contacts(VectorX& gradient) {
  for (std::size_t i = 0; i < stage_->contacts.size(); ++i) {
    const ContactTerm& term = stage_->contacts[i];
    const ContactDerivatives d =
        contact_derivatives(term, stage_->base, here_.q, friction_ ? here_.pulls[i] : Vector3::Zero());
    for (std::size_t c = 0; c < term.corners; ++c) {
      gradient.segment<3>(3 * static_cast<Eigen::Index>(term.particles[c])) += term.omega[c] * d.gradient;
    }
    newton_->matrix_->contact(i, term, d.hessian);
  }
}

/// False where the direction is out of range.
bool Newton::Descent::find_direction(const Assembly& assembly, StepSize& size) {
  here_.direction = newton_->matrix_->direction(assembly.gradient);
  here_.slope = assembly.gradient.dot(here_.direction);
  size.reach = reach_of(here_.direction);
  if (!std::isfinite(here_.slope) || !std::isfinite(size.reach)) return false;
  // Coordinates are rounded, so differences of the potential and steps below these mean nothing.
  size.ulp = kEpsilon * here_.q.head(particles_).lpNorm<Eigen::Infinity>();
  here_.noise = here_.potential.noise + size.ulp * assembly.stored_force;
  size.enough = std::max(std::max(newton_->tolerance_, stage_->tolerance) * stage_->span, kLeastStep * size.ulp);
  return true;
}

/// One step from here, by the line search or, where that creeps, uphill under the watchdog's eye.
Newton::Descent::Search Newton::Descent::advance(bool projected, StepSize size, NewtonResult& result) {
  Trial best = trial(1);
  bool decreased = watchdog_.is_out() ? best.potential.value <= watchdog_.target() : decreases(best);
  if (watchdog_.is_out()) {
    if (decreased) {
      watchdog_.succeed();
    } else if (watchdog_.may_go_on(std::isfinite(best.potential.value))) {
      climb(std::move(best));
      return Search::accepted;
    } else {
      here_ = watchdog_.come_back();
      size.reach = reach_of(here_.direction);
      best = trial(0.5);
      decreased = decreases(best);
    }
  }
  result.last_step = size.reach / stage_->span;
  if (size.reach <= size.enough) {
    // The last step is shorter than the tolerance. It is taken when it leads down; else rounding hides where down is.
    if (best.potential.value <= here_.potential.value) accept(std::move(best));
    return Search::converged;
  }
  const bool whole_step_rises = !decreased && best.step_length == 1 && std::isfinite(best.potential.value);
  if (whole_step_rises && watchdog_.may_go_out(result.iterations)) {
    watchdog_.go_out(here_, sufficient(1));
    climb(std::move(best));
    return Search::accepted;
  }
  watchdog_.rest();
  if (!decreased && !backtrack(best)) return Search::failed;
  // Where the exact Hessian is not positive definite, as beside a buckled shape, a step by the projected one is far too
  // short.
  if (projected) extend(best);
  const bool flat = is_flat(best, size);
  accept(std::move(best));
  return flat ? Search::converged : Search::accepted;
}

Trial Newton::Descent::trial(double step_length) const {
  Trial trial{step_length, here_.q + step_length * here_.direction, {}, {}};
  trial.frames = newton_->system_->transported(here_.frames, here_.q, trial.q);
  trial.potential = potential(trial.q, trial.frames);
  return trial;
}

/// The potential below which a step of this length decreases it sufficiently.
double Newton::Descent::sufficient(double step_length) const {
  return here_.potential.value + kSufficientDecrease * step_length * here_.slope + here_.noise;
}

bool Newton::Descent::decreases(const Trial& trial) const {
  return trial.potential.value <= sufficient(trial.step_length);
}

/// Halves the step until it decreases the potential sufficiently. False when it never does.
bool Newton::Descent::backtrack(Trial& best) const {
  for (int halving = 0; halving < kMostBacktracks; ++halving) {
    best = trial(best.step_length / 2);
    if (decreases(best)) return true;
  }
  return false;
}

/// Doubles a whole step as long as that pays.
void Newton::Descent::extend(Trial& best) const {
  for (int doubling = 0; best.step_length >= 1 && doubling < kMostDoublings; ++doubling) {
    Trial longer = trial(2 * best.step_length);
    if (!decreases(longer) || longer.potential.value >= best.potential.value - here_.noise) return;
    best = std::move(longer);
  }
}

/// Where the potential is so flat that rounding hides the decrease of a step, no method can tell the iterates apart.
bool Newton::Descent::is_flat(const Trial& best, const StepSize& size) const {
  return -here_.slope <= here_.noise && size.reach <= kFlat * size.enough && best.step_length >= 1;
}

void Newton::Descent::accept(Trial trial) {
  for (std::size_t i = 0; i < here_.pulls.size(); ++i) {
    const ContactTerm& term = stage_->contacts[i];
    const Vector3 du = relative_motion(term, here_.direction);
    here_.pulls[i] = next_pull(term, stage_->base, here_.q, here_.pulls[i], du, std::min(trial.step_length, 1.0));
  }
  here_.q = std::move(trial.q);
  here_.frames = std::move(trial.frames);
  here_.potential = trial.potential;
}

/// Accepts a step of the watchdog's, which need not decrease the potential.
void Newton::Descent::climb(Trial trial) {
  watchdog_.set_tensions(newton_->energy_.tensions_after(here_.q, stage_->strains, here_.direction));
  accept(std::move(trial));
}

double Newton::Descent::reach_of(const VectorX& direction) const {
  const auto angles = direction.tail(direction.size() - particles_);
  return std::max(direction.head(particles_).lpNorm<Eigen::Infinity>(),
                  angles.size() > 0 ? kLever * angles.lpNorm<Eigen::Infinity>() : 0.0);
}

LargestChange Newton::Descent::largest_change() const {
  LargestChange largest;
  VectorX moved = here_.direction.cwiseAbs();
  moved.tail(moved.size() - particles_) *= kLever;
  moved.maxCoeff(&largest.coordinate);
  largest.speed = std::abs(here_.direction[largest.coordinate]) / stage_->span;
  return largest;
}

Newton::Newton(const System& system, const Settings& settings, linear::PatternCache& patterns,
               const linear::Cancellation& cancel)
    : system_(&system),
      energy_(system),
      drag_(settings.drag),
      tolerance_(settings.newton_tolerance),
      cancel_(&cancel),
      matrix_(std::make_unique<NewtonMatrix>(system, patterns, cancel)) {}

Newton::~Newton() = default;

NewtonResult Newton::minimise(const Stage& stage, const VectorX& guess, VectorX& q, Frames& frames) {
  Descent descent(*this, stage, guess, q, frames);
  const NewtonResult result = descent.run();
  q = std::move(descent.iterate().q);
  frames = std::move(descent.iterate().frames);
  return result;
}

}  // namespace touchstone::sim
