// SPDX-License-Identifier: MIT
#include "solver/cascade.hpp"

#include "exact/exact.hpp"
#include "filters/filters.hpp"
#include "oracle/oracle.hpp"
#include "solver/validate.hpp"

namespace touchstone::solver {
namespace {

void validate(const Query& query, double t_max) {
  solver::validate(query.kind, query.start.data(), query.end.data(), t_max);
}

}  // namespace

Answer answer(const Query& query, Method method, double t_max) {
  Answer result;  // the one object that is returned everywhere, so that none is copied
  if (method != Method::fast) {
    validate(query, t_max);
    result = method == Method::oracle ? oracle::decide(query, t_max) : exact::decide(query, t_max);
    return result;
  }
  result.level = Level::filter;
  // Proves its query valid, too; so most coordinates are read once.
  if (is_time(t_max) && filters::same_side(query)) return result;
  validate(query, t_max);
  const auto decision = filters::decide(query, t_max, filters::Want::everything, exact::coplanarity_at, result);
  if (decision == filters::Decision::uncertain) result = exact::decide(query, t_max);
  return result;
}

bool any_contact(const Query& query, double t_max) {
  if (is_time(t_max) && filters::same_side(query)) return false;
  validate(query, t_max);
  Answer ignored;
  switch (filters::decide(query, t_max, filters::Want::contact_only, exact::coplanarity_at, ignored)) {
    case filters::Decision::contact: return true;
    case filters::Decision::no_contact: return false;
    case filters::Decision::uncertain: break;
  }
  return exact::decide(query, t_max).contact;
}

}  // namespace touchstone::solver
