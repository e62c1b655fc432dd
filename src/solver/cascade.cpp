// SPDX-License-Identifier: MIT
#include "solver/cascade.hpp"

#include "exact/exact.hpp"
#include "filters/filters.hpp"
#include "oracle/oracle.hpp"

namespace touchstone::solver {

void answer(const Query& query, Method method, double t_max, Answer& result) {
  switch (method) {
    case Method::fast:
      if (filters::decide(query, t_max, exact::coplanarity_sign, result) != filters::Decision::uncertain) return;
      break;
    case Method::exact: break;
    case Method::oracle: result = oracle::decide(query, t_max); return;
  }
  result = exact::decide(query, t_max);
}

}  // namespace touchstone::solver
