// SPDX-License-Identifier: MIT
#include "contact/narrow_phase.hpp"

#include <touchstone/curved.hpp>

#include "baselines/baseline.hpp"

namespace touchstone::sim {

PairSolver::PairSolver(const Colliders& colliders, NarrowPhase narrow_phase, int threads,
                       const linear::Cancellation& cancel)
    : colliders_(&colliders),
      cancel_(&cancel),
      narrow_phase_(narrow_phase),
      threads_(threads),
      separations_(colliders.has_separations() ? kBlock : 0),
      answers_(kBlock) {}

void PairSolver::ask(const Pair* pairs, std::size_t count, const SceneMotion& motion) {
  cancel_->check();
  if (motion.start != nullptr) {
    for (std::size_t i = 0; i < count; ++i) {
      const double d = colliders_->separation(pairs[i]);
      const CurvedQuery query = colliders_->query(pairs[i], motion);
      answers_[i] = d > 0 ? solve(query, {.separation = Separation{d, Metric::euclidean}}) : solve(query);
    }
    return;
  }
  queries_.resize(kBlock);
  for (std::size_t i = 0; i < count; ++i) queries_[i] = colliders_->query(pairs[i], *motion.x0, *motion.x1);
  BatchOptions options;
  options.threads = threads_;
  if (kSeparations && !separations_.empty()) {
    for (std::size_t i = 0; i < count; ++i) separations_[i] = colliders_->separation(pairs[i]);
    options.separations = separations_.data();
    options.separation_count = count;
  }
  if (narrow_phase_ == NarrowPhase::exact) {
    solve_batch(queries_.data(), count, answers_.data(), options);
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    // The paper knows edges only: it sees no contact of a particle with a face. It leaves edges that share a particle
    // to "two dimensional continuous collision methods" (3.6), here to the exact solver.
    if (pairs[i].kind == Kind::vertex_face) {
      answers_[i] = Answer();
    } else if (pairs[i].kind == Kind::edge_edge) {
      const baselines::Result result = baselines::solve_paper(queries_[i], 1, 0);
      answers_[i] = Answer();
      answers_[i].contact = result.contact;
      answers_[i].toi = answers_[i].toi_upper = result.toi;
    } else {
      answers_[i] = solve(queries_[i]);
    }
  }
}

void count(Level level, LevelCounts& counts) noexcept {
  switch (level) {
    case Level::filter: ++counts.filter; break;
    case Level::bracket: ++counts.bracket; break;
    case Level::exact: ++counts.exact; break;
    case Level::oracle: ++counts.oracle; break;
  }
}

void count(const LevelCounts& others, LevelCounts& counts) noexcept {
  counts.filter += others.filter;
  counts.bracket += others.bracket;
  counts.exact += others.exact;
  counts.oracle += others.oracle;
}

void SeparationCounts::operator+=(const SeparationCounts& others) noexcept {
  if (others.pairs == 0) return;
  least = pairs == 0 ? others.least : std::min(least, others.least);
  largest = std::max(largest, others.largest);
  pairs += others.pairs;
}

SeparationCounts separations_of(const Colliders& colliders, const std::vector<Pair>& pairs) {
  SeparationCounts counts;
  if (!colliders.has_separations()) return counts;
  for (const Pair& pair : pairs) {
    if (const double d = colliders.separation(pair); d > 0) counts += {1, d, d};
  }
  return counts;
}

}  // namespace touchstone::sim
