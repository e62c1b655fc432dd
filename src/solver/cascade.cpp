// SPDX-License-Identifier: MIT
#include "solver/cascade.hpp"

#include "exact/exact.hpp"
#include "filters/filters.hpp"
#include "oracle/oracle.hpp"

namespace touchstone::solver {

Answer answer(const Query& query, Method method, double t_max) {
  if (method == Method::oracle) return oracle::decide(query, t_max);
  if (method == Method::exact) return exact::decide(query, t_max);
  Answer result;
  if (filters::decide(query, t_max, exact::coplanarity_sign, result) == filters::Decision::uncertain) {
    result = exact::decide(query, t_max);
  }
  return result;
}

}  // namespace touchstone::solver
