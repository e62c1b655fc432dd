// SPDX-License-Identifier: MIT
#include <touchstone/distance.hpp>

#include "exact/exact.hpp"
#include "numbers/float_environment.hpp"
#include "solver/validate.hpp"

namespace touchstone {

Distance distance(const Query& query, double t, Metric metric) {
  const numbers::DefaultFloatEnvironment environment;
  solver::validate(Separation{0, metric});
  solver::validate_time(t);
  solver::validate(query, t);
  return exact::distance_at(query, t, metric);
}

int compare_distance(const Query& query, double t, const Separation& separation) {
  const numbers::DefaultFloatEnvironment environment;
  solver::validate(separation);
  solver::validate_time(t);
  solver::validate(query, t);
  return exact::compare_distance(query, t, separation);
}

}  // namespace touchstone
