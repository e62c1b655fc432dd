// The methods that are compared: every baseline at every tolerance, and the solver by three of its methods. Straight
// and curved queries have baselines of their own.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <touchstone/answer.hpp>
#include <touchstone/certify.hpp>
#include <touchstone/curved.hpp>
#include <touchstone/query.hpp>
#include <touchstone/solve.hpp>

#include "baselines/baseline.hpp"
#include "baselines/body_baseline.hpp"
#include "baselines/curved_baseline.hpp"
#include "baselines/separation_baseline.hpp"

namespace touchstone::report {

/// A method, with one tolerance if it takes any.
struct Contestant {
  std::string name;
  std::string about;
  const baselines::Baseline* baseline = nullptr;         ///< null: the solver, by `method`, or `thick`
  Method method = Method::fast;                          ///< only without a baseline
  double tolerance = 0;                                  ///< 0: it has none
  const baselines::SeparationBaseline* thick = nullptr;  ///< a baseline for queries with a separation, or null
  const baselines::CurvedBaseline* curved = nullptr;     ///< a baseline for queries with curved motion, or null
  const baselines::BodyBaseline* whole = nullptr;        ///< a baseline for whole bodies, or null

  bool supports(Kind kind) const {
    if (curved != nullptr) return curved->supports(kind);
    return baseline == nullptr || baseline->supports(kind);
  }
  bool is_touchstone() const noexcept { return !may_be_wrong() && method == Method::fast; }

  /// Whether it may stand on the front. The pairing with CGAL may not: where the filters decide all it is the same code
  /// as `touchstone`, and noise alone would say which of the two is faster.
  bool competes() const noexcept { return may_be_wrong() || method != Method::fast_cgal; }
  bool may_be_wrong() const noexcept {
    return baseline != nullptr || thick != nullptr || curved != nullptr || whole != nullptr;
  }

  /// Whether it has no tolerance, or the one that its users commonly choose.
  bool is_usual() const noexcept {
    if (tolerance == 0) return true;
    if (curved != nullptr) return tolerance == curved->usual_tolerance;
    if (whole != nullptr) return tolerance == whole->usual_tolerance;
    return tolerance == (thick != nullptr ? thick->usual_tolerance : baseline->usual_tolerance);
  }

  std::string tolerance_text() const;  ///< "1e-6", or "" without one
  std::string label() const;           ///< "newton 1e-6"
};

/// Baselines first, in their registry's order and tolerances as given; then `exact_only`, `touchstone_cgal` and
/// `touchstone`. With a separation > 0 the baselines are those that take it, at tolerances of their own.
std::vector<Contestant> contestants(const std::vector<double>& tolerances, const Separation& separation = {});

/// The same for queries with curved motion. No baseline for them takes a separation.
std::vector<Contestant> curved_contestants(const std::vector<double>& tolerances, const Separation& separation = {});

/// The methods for whole bodies, at tolerances of their own, and `touchstone`. None is asked about a separation.
std::vector<Contestant> body_contestants();

/// The reply of a contestant to one query, for a separation. A contestant for curved queries gets these alone, and
/// one for whole bodies steps of them, which have a separation of their own.
struct ContestantReply {
  Claim claim;
  Level level = Level::exact;  ///< the level that decided; only of the solver's own methods
};
ContestantReply ask(const Contestant& contestant, const Query& query, const Separation& separation);
ContestantReply ask(const Contestant& contestant, const CurvedQuery& query, const Separation& separation);
ContestantReply ask(const Contestant& contestant, const baselines::MovingBodies& step, const Separation& separation);

/// Asks the first `count` queries and forgets the answers: for timing.
void ask_all(const Contestant& contestant, const std::vector<Query>& queries, std::size_t count,
             const Separation& separation);
void ask_all(const Contestant& contestant, const std::vector<CurvedQuery>& queries, std::size_t count,
             const Separation& separation);
void ask_all(const Contestant& contestant, const std::vector<baselines::MovingBodies>& steps, std::size_t count,
             const Separation& separation);

}  // namespace touchstone::report
