// Queries whose corners move on curves. SPDX-License-Identifier: MIT
#include <touchstone/curved.hpp>

#include "exact/exact.hpp"
#include "filters/curved_paths.hpp"
#include "numbers/float_environment.hpp"
#include "oracle/oracle.hpp"
#include "solver/validate.hpp"

namespace touchstone {

Answer solve(const CurvedQuery& query, Method method, double t_max) {
  const numbers::DefaultFloatEnvironment environment;
  solver::validate_method(method);
  solver::validate(query, t_max);
  const bool by_cgal = method == Method::oracle || method == Method::fast_cgal;
  if ((method == Method::fast || method == Method::fast_cgal) && filters::certainly_apart(query)) {
    Answer apart;
    apart.level = Level::filter;
    return apart;
  }
  Answer answer = by_cgal ? oracle::decide_by_oracle(query, t_max) : exact::decide_exactly(query, t_max);
  answer.starts_within = answer.contact && answer.toi_upper == 0;
  return answer;
}

Answer solve(const CurvedQuery& query, double t_max) { return solve(query, Method::fast, t_max); }

}  // namespace touchstone
