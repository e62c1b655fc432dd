// SPDX-License-Identifier: MIT
#include <touchstone/solve.hpp>

#include <string_view>

#include "exact/exact.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "numbers/fraction.hpp"
#include "oracle/oracle.hpp"
#include "solver/cascade.hpp"
#include "solver/validate.hpp"

namespace touchstone::solver {
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

Answer answer(const RationalQuery& query, const Separation& separation, Method method, double t_max, Wanted wanted) {
  validate_method(method);
  validate(query, t_max);
  Query doubles;
  if (in_doubles(query, doubles)) return answer(doubles, separation, method, t_max, wanted);
  const bool by_cgal = method == Method::oracle || method == Method::fast_cgal;
  Answer result;
  if (separation.distance == 0) {
    result = by_cgal ? oracle::decide_by_oracle(query, t_max) : exact::decide_exactly(query, t_max);
    result.starts_within = result.contact && result.toi_upper == 0;
  } else {
    result =
        by_cgal ? oracle::decide_by_oracle(query, t_max, separation) : exact::decide_exactly(query, t_max, separation);
  }
  trim(result, wanted);
  return result;
}

}  // namespace touchstone::solver

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

bool has_method(Method method) noexcept {
  return method == Method::fast || method == Method::exact || (method <= Method::fast_cgal && oracle::is_present());
}

template <>
Names names_of<Method>() noexcept {
  static constexpr std::string_view kNames[] = {"fast", "exact", "oracle", "fast-cgal"};
  return kNames;
}

Answer solve(const Query& query, const SolveOptions& options) {
  const numbers::DefaultFloatEnvironment environment;
  // Calls that find nothing wrong would cost a quarter of an answer.
  if (options.method > Method::exact) solver::validate_method(options.method);
  if (options.wanted > Wanted::contact) solver::validate_wanted(options.wanted);
  const Separation& separation = options.separation;
  if (separation.distance == 0 && separation.metric <= Metric::max) {
    return solver::answer(query, options.method, options.t_max, options.wanted);
  }
  solver::validate(separation);
  return solver::answer(query, separation, options.method, options.t_max, options.wanted);
}

Answer solve(const Query& query) {
  const numbers::DefaultFloatEnvironment environment;
  return solver::answer(query, Method::fast, 1);
}

Answer solve(const RationalQuery& query, const SolveOptions& options) {
  const numbers::DefaultFloatEnvironment environment;
  solver::validate_wanted(options.wanted);
  solver::validate(options.separation);
  return solver::answer(query, options.separation, options.method, options.t_max, options.wanted);
}

Answer solve(const RationalQuery& query) { return solve(query, SolveOptions()); }

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
