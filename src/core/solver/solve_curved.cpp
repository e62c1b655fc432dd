// Queries whose corners move on curves.
// SPDX-License-Identifier: MIT
#include <touchstone/curved.hpp>

#include <cstddef>
#include <optional>

#include "exact/exact.hpp"
#include "filters/curved/curved_bracket.hpp"
#include "filters/curved/curved_chords.hpp"
#include "filters/curved/curved_paths.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "numbers/roots/vanishing.hpp"
#include "oracle/oracle.hpp"
#include "solver/cascade.hpp"
#include "solver/validate.hpp"

namespace touchstone::solver {
namespace {

/// The same as a straight query, if it is one: all corners are on curves of degree 0 or 1.
std::optional<Query> straight(const CurvedQuery& query) {
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    if (query.corners[i].motion != CurvedCorner::kOnCurve) return std::nullopt;
  }
  Query result;
  result.kind = query.kind;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    const CurvedCorner& corner = query.corners[i];
    if (corner.control_points > 2) return std::nullopt;
    result.start[i] = corner.points[0];
    result.end[i] = corner.points[static_cast<std::size_t>(corner.control_points - 1)];
  }
  return result;
}

/// Whether the filters decide a valid query. If so, the answer is complete.
bool decided_by_filters(const CurvedQuery& query, double t_max, Answer& answer) {
  answer.level = Level::filter;
  if (filters::chords_certainly_farther(query, Separation()) || filters::certainly_apart(query)) return true;
  answer.level = Level::bracket;
  return filters::decide_in_brackets(query, t_max, answer) != filters::Outcome::uncertain;
}

}  // namespace

Answer answer(const CurvedQuery& query, Method method, double t_max, Wanted wanted) {
  validate_method(method);
  validate(query, t_max);
  const bool by_cgal = method == Method::oracle || method == Method::fast_cgal;
  if (method == Method::fast || method == Method::fast_cgal) {
    if (const std::optional<Query> same = straight(query)) return answer(*same, method, t_max, wanted);
    Answer answer;
    if (decided_by_filters(query, t_max, answer)) {
      trim(answer, wanted);
      return answer;
    }
  }
  Answer answer = by_cgal ? oracle::decide_by_oracle(query, t_max) : exact::decide_exactly(query, t_max);
  answer.starts_within = answer.contact && answer.toi_upper == 0;
  trim(answer, wanted);
  return answer;
}

Answer answer(const CurvedQuery& query, const Separation& separation, Method method, double t_max, Wanted wanted) {
  if (separation.distance == 0) return answer(query, method, t_max, wanted);
  validate_method(method);
  validate(query, t_max);
  const bool by_cgal = method == Method::oracle || method == Method::fast_cgal;
  if (method == Method::fast || method == Method::fast_cgal) {
    if (const std::optional<Query> same = straight(query)) return answer(*same, separation, method, t_max, wanted);
    Answer apart;
    apart.level = Level::filter;
    if (filters::chords_certainly_farther(query, separation) || filters::certainly_farther(query, separation)) {
      return apart;
    }
    Answer answer;
    answer.level = Level::bracket;
    const filters::Outcome finding = filters::decide_in_brackets(query, separation, t_max, answer);
    if (finding != filters::Outcome::uncertain) {
      trim(answer, wanted);
      return answer;
    }
  }
  Answer answer =
      by_cgal ? oracle::decide_by_oracle(query, t_max, separation) : exact::decide_exactly(query, t_max, separation);
  trim(answer, wanted);
  return answer;
}

}  // namespace touchstone::solver

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

bool takes_longer_turn(const RigidMotion& motion) { return numbers::sign_of_dot(motion.q0, motion.q1) < 0; }
bool takes_half_turn(const RigidMotion& motion) { return numbers::sign_of_dot(motion.q0, motion.q1) == 0; }

RigidMotion with_shorter_turn(const RigidMotion& motion) {
  RigidMotion shorter = motion;
  if (takes_longer_turn(motion)) {
    for (double& component : shorter.q1) component = -component;
  }
  return shorter;
}

Answer solve(const CurvedQuery& query, const SolveOptions& options) {
  const numbers::DefaultFloatEnvironment environment;
  solver::validate_wanted(options.wanted);
  solver::validate(options.separation);
  return solver::answer(query, options.separation, options.method, options.t_max, options.wanted);
}

Answer solve(const CurvedQuery& query) { return solve(query, SolveOptions()); }

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
