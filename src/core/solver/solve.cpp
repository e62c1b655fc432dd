// SPDX-License-Identifier: MIT
#include <touchstone/solve.hpp>

#include "exact/exact.hpp"
#include "numbers/float_environment.hpp"
#include "numbers/fraction.hpp"
#include "oracle/oracle.hpp"
#include "solver/cascade.hpp"
#include "solver/validate.hpp"

namespace touchstone {
namespace {

/// Whether every coordinate is a double; `result` is then the query in doubles.
bool in_doubles(const RationalQuery& query, Query& result) {
  result.kind = query.kind;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    for (int side = 0; side < 2; ++side) {
      const auto& fractions = (side == 0 ? query.start : query.end)[i];
      double coordinates[3];
      for (std::size_t k = 0; k < 3; ++k) {
        const auto exact = numbers::exact_double(fractions[k].numerator, fractions[k].denominator);
        if (!exact) return false;
        coordinates[k] = *exact;
      }
      (side == 0 ? result.start : result.end)[i] = {coordinates[0], coordinates[1], coordinates[2]};
    }
  }
  return true;
}

}  // namespace

Answer solve(const Query& query, const Separation& separation, Method method, double t_max) {
  const numbers::DefaultFloatEnvironment environment;
  solver::validate(separation);
  return solver::answer(query, separation, method, t_max);
}

Answer solve(const Query& query, const Separation& separation, double t_max) {
  return solve(query, separation, Method::fast, t_max);
}

Answer solve(const Query& query, const Separation& separation, Wanted wanted, double t_max) {
  const numbers::DefaultFloatEnvironment environment;
  solver::validate_wanted(wanted);
  solver::validate(separation);
  return solver::answer(query, separation, Method::fast, t_max, wanted);
}

bool solve_any(const Query& query, const Separation& separation, double t_max) {
  const numbers::DefaultFloatEnvironment environment;
  solver::validate(separation);
  return solver::any_contact(query, separation, t_max);
}

Answer solve(const RationalQuery& query, const Separation& separation, double t_max) {
  return solve(query, separation, Method::fast, t_max);
}

Answer solve(const RationalQuery& query, const Separation& separation, Method method, double t_max) {
  const numbers::DefaultFloatEnvironment environment;
  solver::validate_method(method);
  solver::validate(separation);
  solver::validate(query, t_max);
  Query doubles;
  if (in_doubles(query, doubles)) return solver::answer(doubles, separation, method, t_max);
  const bool by_cgal = method == Method::oracle || method == Method::fast_cgal;
  if (separation.distance == 0) {
    Answer answer = by_cgal ? oracle::decide_by_oracle(query, t_max) : exact::decide_exactly(query, t_max);
    answer.starts_within = answer.contact && answer.toi_upper == 0;
    return answer;
  }
  return by_cgal ? oracle::decide_by_oracle(query, t_max, separation) : exact::decide_exactly(query, t_max, separation);
}

Answer solve(const Query& query, Method method, double t_max) {
  const numbers::DefaultFloatEnvironment environment;
  return solver::answer(query, method, t_max);
}

Answer solve(const Query& query, double t_max) { return solve(query, Method::fast, t_max); }
Answer solve(const EdgeEdge& query, double t_max) { return solve(Query(query), Method::fast, t_max); }
Answer solve(const VertexFace& query, double t_max) { return solve(Query(query), Method::fast, t_max); }
Answer solve(const PointEdge& query, double t_max) { return solve(Query(query), Method::fast, t_max); }
Answer solve(const PointPoint& query, double t_max) { return solve(Query(query), Method::fast, t_max); }

Answer solve(const Query& query, Wanted wanted, double t_max) {
  const numbers::DefaultFloatEnvironment environment;
  solver::validate_wanted(wanted);
  return solver::answer(query, Method::fast, t_max, wanted);
}

bool solve_any(const Query& query, double t_max) {
  const numbers::DefaultFloatEnvironment environment;
  return solver::any_contact(query, t_max);
}

Answer solve(const RationalQuery& query, double t_max) { return solve(query, Method::fast, t_max); }

Answer solve(const RationalQuery& query, Method method, double t_max) {
  return solve(query, Separation(), method, t_max);
}

}  // namespace touchstone
