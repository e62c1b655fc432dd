// SPDX-License-Identifier: MIT
#include "sim/newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/features.hpp"
#include "sim/sparse_solver.hpp"

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

/// A few whole steps although the potential rises. Stiff lengths resist a straight step as much as it turns them on the
/// way, so that only tiny steps lead down (Maratos 1978); a step or two later that is made good. While they are out of
/// shape, what their turning resists is the tension that they are meant to have, not that which they have: Newton's
/// method with the tensions as variables. Comes back when it was for nothing (the watchdog of Chamberlain et al. 1982).
struct Newton::Excursion {
  int left = 0;             // steps; 0: there is none under way
  int wait = 0, pause = 1;  // iterations before the next one, and after one that was for nothing
  double wanted = 0;        // J: what it must come down to
  VectorX tensions;
  VectorX q;  // where it began, and what was known there
  Frames frames;
  Potential potential;
  std::vector<Vector3> pulls;
  VectorX direction;
  double slope = 0, noise = 0;
};

/// Second derivatives in the free coordinates.
class Newton::Matrix final : public BlockSink {
 public:
  Matrix(const System& system, PatternCache& cache) : free_(static_cast<std::size_t>(system.size()), -1) {
    int count = 0;
    for (std::size_t i = 0; i < free_.size(); ++i) {
      if (!system.fixed[i]) free_[i] = count++;
    }
    Blocks cliques;
    for (const Length& element : system.lengths) {
      cliques.push_back(coordinates({3 * element.a, 3 * element.b}, {}));
    }
    for (const Joint& joint : system.joints) {
      // The order of JointVector.
      std::vector<int> all;
      for (int k = 0; k < 3; ++k) {
        for (Index c = 0; c < 3; ++c) all.push_back(free_[3 * joint.p[static_cast<std::size_t>(k)] + c]);
        if (k < 2) all.push_back(free_[static_cast<std::size_t>(system.angle(k == 0 ? joint.e : joint.f))]);
      }
      cliques.push_back(std::move(all));
    }
    joint_offset_ = system.lengths.size();
    solver_ = std::make_unique<SparseSolver>(count, std::move(cliques), cache);
  }

  /// The contacts of the next minimisation.
  void set_contacts(std::span<const ContactTerm> contacts) {
    if (contacts.empty() && contact_count_ == 0) return;
    contact_count_ = contacts.size();
    std::vector<SparseSolver::Corners> corners(contacts.size());
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      corners[i].fill(-1);
      for (std::size_t c = 0; c < contacts[i].corners; ++c) {
        for (std::size_t k = 0; k < 3; ++k) corners[i][3 * c + k] = free_[3 * contacts[i].particles[c] + k];
      }
    }
    solver_->set_contacts(corners);
  }

  void contact(std::size_t number, const ContactTerm& term, const Eigen::Matrix3d& block) {
    solver_->add_contact(number, term.omega, block);
  }

  int free_count() const noexcept { return solver_->size(); }

  void start(const VectorX& diagonal) {
    solver_->clear();
    for (std::size_t i = 0; i < free_.size(); ++i) {
      if (free_[i] >= 0) solver_->add_diagonal(free_[i], diagonal[static_cast<Eigen::Index>(i)]);
    }
  }

  void length(std::size_t element, const Eigen::Matrix3d& block) override {
    Eigen::Matrix<double, 6, 6> all;
    all << block, -block, -block, block;
    solver_->add(element, all.data());
  }

  void joint(std::size_t element, const JointMatrix& block) override {
    solver_->add(joint_offset_ + element, block.data());
  }

  bool factorise() { return solver_->factorise(); }

  /// -H^-1 gradient, zero in the fixed coordinates.
  VectorX direction(const VectorX& gradient) const {
    VectorX right(solver_->size());
    for (std::size_t i = 0; i < free_.size(); ++i) {
      if (free_[i] >= 0) right[free_[i]] = -gradient[static_cast<Eigen::Index>(i)];
    }
    const VectorX solution = solver_->solve(right);
    VectorX all = VectorX::Zero(gradient.size());
    for (std::size_t i = 0; i < free_.size(); ++i) {
      if (free_[i] >= 0) all[static_cast<Eigen::Index>(i)] = solution[free_[i]];
    }
    return all;
  }

 private:
  std::vector<int> coordinates(std::initializer_list<Index> particles,
                               std::initializer_list<Eigen::Index> angles) const {
    std::vector<int> all;
    for (const Index first : particles) {
      for (Index c = 0; c < 3; ++c) all.push_back(free_[first + c]);
    }
    for (const auto angle : angles) all.push_back(free_[static_cast<std::size_t>(angle)]);
    return all;
  }

  std::vector<int> free_;
  std::size_t joint_offset_ = 0;
  std::size_t contact_count_ = 0;
  std::unique_ptr<SparseSolver> solver_;
};

Newton::Newton(const System& system, const Settings& settings, PatternCache& patterns)
    : system_(&system),
      energy_(system),
      drag_(settings.drag),
      tolerance_(settings.newton_tolerance),
      matrix_(std::make_unique<Matrix>(system, patterns)) {}

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

NewtonResult Newton::minimise(const Stage& stage, const VectorX& guess, VectorX& q, Frames& frames) {
  NewtonResult result;
  const VectorX& mass = system_->mass;
  const auto particles = static_cast<Eigen::Index>(3 * system_->particle_count());
  const auto size_of = [&](const VectorX& d) {
    const auto angles = d.tail(d.size() - particles);
    return std::max(d.head(particles).lpNorm<Eigen::Infinity>(),
                    angles.size() > 0 ? kLever * angles.lpNorm<Eigen::Infinity>() : 0.0);
  };

  // Begin where the potential is lower: at the guess, or where nothing has moved but what must.
  VectorX still = q;
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    if (system_->fixed[static_cast<std::size_t>(i)]) still[i] = guess[i];
  }
  Frames frames_still = system_->transported(frames, q, still), frames_guess = system_->transported(frames, q, guess);
  Potential now = potential(stage, still, frames_still);
  const Potential at_guess = potential(stage, guess, frames_guess);
  const bool take_guess = !std::isfinite(now.value) || at_guess.value <= now.value;
  q = take_guess ? guess : still;
  frames = take_guess ? std::move(frames_guess) : std::move(frames_still);
  if (take_guess) now = at_guess;
  if (!std::isfinite(now.value)) return result;
  if (matrix_->free_count() == 0) {
    result.converged = true;
    return result;
  }

  matrix_->set_contacts(stage.contacts);
  std::vector<Vector3> pulls;
  const bool friction = kFriction && std::any_of(stage.contacts.begin(), stage.contacts.end(),
                                                 [](const ContactTerm& term) { return term.slip > 0; });
  if (friction) {
    for (const ContactTerm& term : stage.contacts) pulls.push_back(friction_pull(term, stage.base, q));
  }
  const auto add_contacts = [&](VectorX& gradient) {
    for (std::size_t i = 0; i < stage.contacts.size(); ++i) {
      const ContactTerm& term = stage.contacts[i];
      const ContactDerivatives d = contact_derivatives(term, stage.base, q, friction ? pulls[i] : Vector3::Zero());
      for (std::size_t c = 0; c < term.corners; ++c) {
        gradient.segment<3>(3 * static_cast<Eigen::Index>(term.particles[c])) += term.omega[c] * d.gradient;
      }
      matrix_->contact(i, term, d.hessian);
    }
  };
  const double inverse = 1 / (stage.span * stage.span);
  const VectorX diagonal = (inverse + drag_ / stage.span) * mass;
  VectorX direction;
  double slope = 0, noise = 0;
  const auto try_share = [&](double part) {
    Trial trial{part, q + part * direction, {}, {}};
    trial.frames = system_->transported(frames, q, trial.q);
    trial.potential = potential(stage, trial.q, trial.frames);
    return trial;
  };
  const auto take = [&](Trial trial) {
    for (std::size_t i = 0; i < pulls.size(); ++i) {
      const ContactTerm& term = stage.contacts[i];
      pulls[i] = next_pull(term, stage.base, q, pulls[i], relative_motion(term, direction), std::min(trial.share, 1.0));
    }
    q = std::move(trial.q);
    frames = std::move(trial.frames);
    now = trial.potential;
  };
  const auto wanted = [&](double share) { return now.value + 1e-4 * share * slope + noise; };
  const auto is_lower = [&](const Trial& trial) { return trial.potential.value <= wanted(trial.share); };
  Excursion out;
  for (result.iterations = 1; result.iterations <= kMostIterations; ++result.iterations) {
    const VectorX* const tensions = out.left > 0 ? &out.tensions : nullptr;
    VectorX gradient = VectorX::Zero(q.size());
    matrix_->start(diagonal);
    energy_.derivatives(q, frames, stage.time, stage.strains, Curvature::exact, gradient, matrix_.get(), tensions);
    add_contacts(gradient);
    const double stored_force = gradient.lpNorm<1>();
    const bool convex = !matrix_->factorise();
    if (convex) {
      ++result.convex;
      matrix_->start(diagonal);
      VectorX ignored = VectorX::Zero(q.size());
      energy_.derivatives(q, frames, stage.time, stage.strains, Curvature::convex, ignored, matrix_.get(), tensions);
      add_contacts(ignored);
      if (!matrix_->factorise()) return result;
    }
    const VectorX moved = q - stage.base;
    gradient += inverse * mass.cwiseProduct(moved - stage.span * stage.base_velocity) +
                drag_ / stage.span * mass.cwiseProduct(moved) - system_->force;
    direction = matrix_->direction(gradient);
    slope = gradient.dot(direction);
    double reach = size_of(direction);
    if (!std::isfinite(slope) || !std::isfinite(reach)) return result;

    // Coordinates are rounded: so much of the potential, and of a step, means nothing.
    const double ulp = kEpsilon * q.head(particles).lpNorm<Eigen::Infinity>();
    noise = now.noise + ulp * stored_force;
    const double enough = std::max(std::max(tolerance_, stage.tolerance) * stage.span, 16 * ulp);
    Trial best = try_share(1);
    bool lower = out.left > 0 ? best.potential.value <= out.wanted : is_lower(best);
    const auto go_out = [&] {
      out.tensions = energy_.tensions_after(q, stage.strains, direction);
      take(std::move(best));
    };
    if (out.left > 0 && !lower) {
      if (--out.left > 0 && std::isfinite(best.potential.value)) {
        go_out();
        continue;
      }
      out.left = 0;  // also where its next place is out of range
      q = std::move(out.q);
      frames = std::move(out.frames);
      now = out.potential;
      pulls = std::move(out.pulls);
      direction = std::move(out.direction);
      slope = out.slope;
      noise = out.noise;
      reach = size_of(direction);
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
      if (best.potential.value <= now.value) take(std::move(best));
      result.converged = true;
      return result;
    }
    if (!lower && result.iterations > kPatience && best.share == 1 && out.wait == 0 &&
        std::isfinite(best.potential.value)) {
      out = {kMostSteps, 0, out.pause, wanted(1), {}, q, frames, now, pulls, direction, slope, noise};
      go_out();
      continue;
    }
    if (out.wait > 0) --out.wait;
    for (int halving = 0; !lower; ++halving) {
      if (halving == kMostHalvings) {
        result.mover = mover_of(direction, particles, stage.span);
        return result;
      }
      best = try_share(best.share / 2);
      lower = is_lower(best);
    }
    // Where the potential is not convex, as beside a buckled shape, a step by what is convex of it is far too short.
    for (int doubling = 0; convex && best.share >= 1 && doubling < kMostDoublings; ++doubling) {
      Trial longer = try_share(2 * best.share);
      if (!is_lower(longer) || longer.potential.value >= best.potential.value - noise) break;
      best = std::move(longer);
    }
    // Where the potential is so flat that rounding hides what a step gains, no method can tell the places apart.
    const bool flat = -slope <= noise && reach <= kFlat * enough && best.share >= 1;
    take(std::move(best));
    if (flat) {
      result.converged = true;
      return result;
    }
  }
  result.mover = mover_of(direction, particles, stage.span);
  return result;
}

}  // namespace touchstone::sim
