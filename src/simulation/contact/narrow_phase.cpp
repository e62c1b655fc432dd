// SPDX-License-Identifier: MIT
#include "contact/narrow_phase.hpp"

#include "baselines/baseline.hpp"

namespace touchstone::sim {

PairSolver::PairSolver(const Colliders& colliders, NarrowPhase narrow_phase, int threads,
                       const linear::Cancellation& cancel)
    : colliders_(&colliders),
      cancel_(&cancel),
      narrow_phase_(narrow_phase),
      threads_(threads),
      queries_(kBlock),
      separations_(colliders.has_separations() ? kBlock : 0),
      answers_(kBlock) {}

void PairSolver::ask(const Pair* pairs, std::size_t count, const VectorX& x0, const VectorX& x1) {
  cancel_->check();
  for (std::size_t i = 0; i < count; ++i) queries_[i] = colliders_->query(pairs[i], x0, x1);
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

void PairSolver::count_level(Level level, LevelCounts& counts) noexcept {
  switch (level) {
    case Level::filter: ++counts.filter; break;
    case Level::bracket: ++counts.bracket; break;
    case Level::exact: ++counts.exact; break;
    case Level::oracle: ++counts.oracle; break;
  }
}

}  // namespace touchstone::sim
