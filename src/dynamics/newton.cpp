// SPDX-License-Identifier: MIT
#include "dynamics/newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/features.hpp"
#include "dynamics/newton_matrix.hpp"

namespace touchstone::sim {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr int kMostIterations = 100;
constexpr int kMostHalvings = 30;
constexpr int kMostDoublings = 10;
constexpr int kPatience = 15;    // iterations before the first excursion: what converges sooner is not led elsewhere
constexpr int kMostSteps = 4;    // of an excursion
constexpr double kFlat = 1000;   // tolerances that a step may still be long when rounding hides what it gains
constexpr double kLever = 0.01;  // m: an angle's change counts as what it moves this far from the axis

Mover mover_of(const VectorX& direction, Eigen::Index particles, double span) {
  Mover mover;
  VectorX moved = direction.cwiseAbs();
  moved.tail(moved.size() - particles) *= kLever;
  moved.maxCoeff(&mover.coordinate);
  mover.speed = std::abs(direction[mover.coordinate]) / span;
  return mover;
}

}  // namespace

/// Where the search is, and what is known there.
struct Newton::Place {
  VectorX q;
  Frames frames;
  Potential potential;
  std::vector<Vector3> pulls;  // of friction, for each contact; empty without friction
  VectorX direction;           // to go
  double slope = 0;            // J: of the potential along it
  double noise = 0;            // J: what the potential cannot tell apart
};

/// A few whole steps although the potential rises. Stiff lengths resist a straight step as much as it turns them on the
/// way, so that only tiny steps lead down (Maratos 1978); a step or two later that is made good. While they are out of
/// shape, what their turning resists is the tension that they are meant to have, not that which they have: Newton's
/// method with the tensions as variables. Comes back when it was for nothing (the watchdog of Chamberlain et al. 1982).
struct Newton::Excursion {
  int left = 0;             // steps; 0: there is none under way
  int wait = 0, pause = 1;  // iterations before the next one, and after one that was for nothing
  double wanted = 0;        // J: what it must come down to
  VectorX tensions;
  Place from;
};

Newton::Newton(const System& system, const Settings& settings, linear::PatternCache& patterns)
    : system_(&system),
      energy_(system),
      drag_(settings.drag),
      tolerance_(settings.newton_tolerance),
      matrix_(std::make_unique<NewtonMatrix>(system, patterns)) {}

Newton::~Newton() = default;

Newton::Potential Newton::potential(const Stage& stage, const VectorX& q, const Frames& frames) const {
  const auto mass = system_->mass.array();
  const VectorX moved = q - stage.base;
  const double inertia =
      0.5 / (stage.span * stage.span) * (mass * (moved - stage.span * stage.base_velocity).array().square()).sum();
  const double drag = 0.5 * drag_ / stage.span * (mass * moved.array().square()).sum();
  const double load = (system_->force.array() * moved.array()).sum();
  const double stored = energy_.value(q, frames, stage.time, stage.strains);
  double contact = 0;
  for (const ContactTerm& term : stage.contacts) contact += contact_value(term, stage.base, q);
  return {inertia + drag - load + stored + contact,
          64 * kEpsilon * (inertia + drag + std::abs(load) + stored + contact)};
}

Newton::Place Newton::start(const Stage& stage, const VectorX& guess, const VectorX& q, const Frames& frames) const {
  VectorX still = q;
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    if (system_->fixed[static_cast<std::size_t>(i)]) still[i] = guess[i];
  }
  Place at_still{still, system_->transported(frames, q, still), {}, {}, {}, 0, 0};
  Place at_guess{guess, system_->transported(frames, q, guess), {}, {}, {}, 0, 0};
  for (Place* const place : {&at_still, &at_guess}) place->potential = potential(stage, place->q, place->frames);
  const double value = at_still.potential.value;
  return !std::isfinite(value) || at_guess.potential.value <= value ? at_guess : at_still;
}

NewtonResult Newton::minimise(const Stage& stage, const VectorX& guess, VectorX& q, Frames& frames) {
  Place here = start(stage, guess, q, frames);
  const NewtonResult result = descend(stage, here);
  q = std::move(here.q);
  frames = std::move(here.frames);
  return result;
}

NewtonResult Newton::descend(const Stage& stage, Place& here) {
  NewtonResult result;
  if (!std::isfinite(here.potential.value)) return result;
  if (matrix_->free_count() == 0) {
    result.converged = true;
    return result;
  }
  const VectorX& mass = system_->mass;
  const auto particles = static_cast<Eigen::Index>(3 * system_->particle_count());
  const auto size_of = [&](const VectorX& d) {
    const auto angles = d.tail(d.size() - particles);
    return std::max(d.head(particles).lpNorm<Eigen::Infinity>(),
                    angles.size() > 0 ? kLever * angles.lpNorm<Eigen::Infinity>() : 0.0);
  };
  matrix_->set_contacts(stage.contacts);
  const bool friction = kFriction && std::any_of(stage.contacts.begin(), stage.contacts.end(),
                                                 [](const ContactTerm& term) { return term.slip > 0; });
  if (friction) {
    for (const ContactTerm& term : stage.contacts) here.pulls.push_back(friction_pull(term, stage.base, here.q));
  }
  const auto add_contacts = [&](VectorX& gradient) {
    for (std::size_t i = 0; i < stage.contacts.size(); ++i) {
      const ContactTerm& term = stage.contacts[i];
      const ContactDerivatives d =
          contact_derivatives(term, stage.base, here.q, friction ? here.pulls[i] : Vector3::Zero());
      for (std::size_t c = 0; c < term.corners; ++c) {
        gradient.segment<3>(3 * static_cast<Eigen::Index>(term.particles[c])) += term.omega[c] * d.gradient;
      }
      matrix_->contact(i, term, d.hessian);
    }
  };
  const double inverse = 1 / (stage.span * stage.span);
  const VectorX diagonal = (inverse + drag_ / stage.span) * mass;
  const auto try_share = [&](double part) {
    Trial trial{part, here.q + part * here.direction, {}, {}};
    trial.frames = system_->transported(here.frames, here.q, trial.q);
    trial.potential = potential(stage, trial.q, trial.frames);
    return trial;
  };
  const auto take = [&](Trial trial) {
    for (std::size_t i = 0; i < here.pulls.size(); ++i) {
      const ContactTerm& term = stage.contacts[i];
      const Vector3 du = relative_motion(term, here.direction);
      here.pulls[i] = next_pull(term, stage.base, here.q, here.pulls[i], du, std::min(trial.share, 1.0));
    }
    here.q = std::move(trial.q);
    here.frames = std::move(trial.frames);
    here.potential = trial.potential;
  };
  const auto wanted = [&](double share) { return here.potential.value + 1e-4 * share * here.slope + here.noise; };
  const auto is_lower = [&](const Trial& trial) { return trial.potential.value <= wanted(trial.share); };
  Excursion out;
  for (result.iterations = 1; result.iterations <= kMostIterations; ++result.iterations) {
    const VectorX* const tensions = out.left > 0 ? &out.tensions : nullptr;
    VectorX gradient = VectorX::Zero(here.q.size());
    matrix_->start(diagonal);
    energy_.derivatives(here.q, here.frames, stage.time, stage.strains, Curvature::exact, gradient, matrix_.get(),
                        tensions);
    add_contacts(gradient);
    const double stored_force = gradient.lpNorm<1>();
    const bool convex = !matrix_->factorise();
    if (convex) {
      ++result.convex;
      matrix_->start(diagonal);
      VectorX ignored = VectorX::Zero(here.q.size());
      energy_.derivatives(here.q, here.frames, stage.time, stage.strains, Curvature::convex, ignored, matrix_.get(),
                          tensions);
      add_contacts(ignored);
      if (!matrix_->factorise()) return result;
    }
    const VectorX moved = here.q - stage.base;
    gradient += inverse * mass.cwiseProduct(moved - stage.span * stage.base_velocity) +
                drag_ / stage.span * mass.cwiseProduct(moved) - system_->force;
    here.direction = matrix_->direction(gradient);
    here.slope = gradient.dot(here.direction);
    double reach = size_of(here.direction);
    if (!std::isfinite(here.slope) || !std::isfinite(reach)) return result;

    // Coordinates are rounded: so much of the potential, and of a step, means nothing.
    const double ulp = kEpsilon * here.q.head(particles).lpNorm<Eigen::Infinity>();
    here.noise = here.potential.noise + ulp * stored_force;
    const double enough = std::max(std::max(tolerance_, stage.tolerance) * stage.span, 16 * ulp);
    Trial best = try_share(1);
    bool lower = out.left > 0 ? best.potential.value <= out.wanted : is_lower(best);
    const auto go_out = [&] {
      out.tensions = energy_.tensions_after(here.q, stage.strains, here.direction);
      take(std::move(best));
    };
    if (out.left > 0 && !lower) {
      if (--out.left > 0 && std::isfinite(best.potential.value)) {
        go_out();
        continue;
      }
      out.left = 0;  // also where its next place is out of range
      here = std::move(out.from);
      reach = size_of(here.direction);
      best = try_share(0.5);
      lower = is_lower(best);
      out.wait = out.pause;
      out.pause *= 2;
    } else if (out.left > 0) {
      out.left = 0;
      out.pause = 1;
    }
    result.last_step = reach / stage.span;
    if (reach <= enough) {
      // The last step is shorter than the tolerance: taken when it leads down, left when rounding hides where down is.
      if (best.potential.value <= here.potential.value) take(std::move(best));
      result.converged = true;
      return result;
    }
    if (!lower && result.iterations > kPatience && best.share == 1 && out.wait == 0 &&
        std::isfinite(best.potential.value)) {
      out = {kMostSteps, 0, out.pause, wanted(1), {}, here};
      go_out();
      continue;
    }
    if (out.wait > 0) --out.wait;
    for (int halving = 0; !lower; ++halving) {
      if (halving == kMostHalvings) {
        result.mover = mover_of(here.direction, particles, stage.span);
        return result;
      }
      best = try_share(best.share / 2);
      lower = is_lower(best);
    }
    // Where the potential is not convex, as beside a buckled shape, a step by what is convex of it is far too short.
    for (int doubling = 0; convex && best.share >= 1 && doubling < kMostDoublings; ++doubling) {
      Trial longer = try_share(2 * best.share);
      if (!is_lower(longer) || longer.potential.value >= best.potential.value - here.noise) break;
      best = std::move(longer);
    }
    // Where the potential is so flat that rounding hides what a step gains, no method can tell the places apart.
    const bool flat = -here.slope <= here.noise && reach <= kFlat * enough && best.share >= 1;
    take(std::move(best));
    if (flat) {
      result.converged = true;
      return result;
    }
  }
  result.mover = mover_of(here.direction, particles, stage.span);
  return result;
}

}  // namespace touchstone::sim
