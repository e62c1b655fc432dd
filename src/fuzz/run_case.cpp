// SPDX-License-Identifier: MIT
#include "fuzz/run_case.hpp"

#include <type_traits>
#include <utility>

#include "fuzz/judging/judged_solver.hpp"
#include "fuzz/plan.hpp"
#include "fuzz/shrinking/shrink.hpp"
#include "fuzz/shrinking/simplicity.hpp"
#include "numbers/doubles/float_environment.hpp"

namespace touchstone::fuzz {

CaseOutcome run_case(SolverUnderTest& solver, const CaseName& name, const Settings& settings,
                     const std::function<bool()>& stop) {
  const numbers::DefaultFloatEnvironment environment;
  supported_kinds(solver, {name.start.kind});
  const JudgedSolver judged(solver, settings);
  const Asked asked = asked_in_case(name, case_source(settings));
  check_sort(solver, is_curved(asked.query));
  const Answer truth = judged.truth(asked);
  const auto [reply, failure, allowed, seconds] = judged.ask(asked, truth);
  if (!failure) return {std::nullopt, allowed};
  Findings findings;
  findings.add(*failure, name, asked, reply, truth);
  Finding finding = std::move(findings.take(1).front());
  shrink_finding(finding, solver, settings, stop);
  return {std::move(finding)};
}

namespace {

/// Shrinks the query of the example, which is of type Q.
/// @param claims  null: any query may be asked
template <class Q>
void shrink_example(Finding& finding, const JudgedSolver& judged, const Claims* claims, const ShrinkLimits& limits) {
  Example best = finding.example;
  const auto fails = [&](Q query, double t_max) {
    if constexpr (std::is_same_v<Q, Query>) {
      if (claims != nullptr) query = nearest_claimed(query, *claims);
      if (claims != nullptr && !is_claimed(query, *claims, best.separation)) return false;
    }
    const Asked asked{query, best.separation, t_max};
    const Answer truth = judged.truth(asked);
    // The conditions on the true answer come first, because asking the solver may be dear.
    if (truth.nature != finding.degeneracy.nature || truth.feature_a != finding.degeneracy.feature_a ||
        truth.feature_b != finding.degeneracy.feature_b || degeneracy_of(query, truth) != finding.degeneracy) {
      return false;
    }
    auto [reply, failure, allowed, seconds] = judged.ask(asked, truth);
    if (!failure || failure->failure != finding.failure) return false;
    best = {finding.example.name, query, best.separation, t_max,
            std::move(reply),     truth, failure->detail, difficulty(query)};
    return true;
  };
  const Q start = std::get<Q>(finding.example.query);
  double t_max = finding.example.t_max;
  for (const double simpler : {1.0, 0.5}) {
    if (t_max != simpler && t_max != 1 && fails(start, simpler)) t_max = simpler;
  }
  shrink(
      start, [&](const Q& query) { return fails(query, t_max); }, limits);
  finding.example = std::move(best);  // the last query that failed is the simplest
}

}  // namespace

void shrink_finding(Finding& finding, SolverUnderTest& solver, const Settings& settings,
                    const std::function<bool()>& stop) {
  if (settings.shrink_tries == 0) return;
  const JudgedSolver judged(solver, settings);
  ShrinkLimits limits;
  limits.tries = settings.shrink_tries;
  limits.stop = stop;
  const Claims* const claims = settings.claims ? &*settings.claims : nullptr;
  if (is_curved(finding.example.query)) {
    shrink_example<CurvedQuery>(finding, judged, claims, limits);
  } else {
    shrink_example<Query>(finding, judged, claims, limits);
  }
}

}  // namespace touchstone::fuzz
