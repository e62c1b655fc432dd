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
  const auto decision = filters::decide(query, t_max, filters::Want::everything, exact::coplanarity_sign, result);
  if (decision == filters::Decision::uncertain) result = exact::decide(query, t_max);
  return result;
}

bool any_contact(const Query& query, double t_max) {
  Answer ignored;
  switch (filters::decide(query, t_max, filters::Want::contact_only, exact::coplanarity_sign, ignored)) {
    case filters::Decision::contact: return true;
    case filters::Decision::no_contact: return false;
    case filters::Decision::uncertain: break;
  }
  return exact::decide(query, t_max).contact;
}

}  // namespace touchstone::solver
