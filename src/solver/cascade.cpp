// SPDX-License-Identifier: MIT
#include "solver/cascade.hpp"

#include "exact/exact.hpp"
#include "filters/filters.hpp"
#include "oracle/oracle.hpp"
#include "solver/validate.hpp"

namespace touchstone::solver {
namespace {

/// The arithmetic without error below the filters and the bracket level.
struct ExactArithmetic {
  filters::ExactValue coplanarity_at;
  Answer (*decide_exactly)(const Query& query, double t_max);
};
constexpr ExactArithmetic kOwn = {exact::coplanarity_at, exact::decide_exactly};
constexpr ExactArithmetic kCgal = {oracle::coplanarity_at, oracle::decide_by_oracle};

}  // namespace

Answer answer(const Query& query, Method method, double t_max) {
  Answer result;  // the one object that is returned everywhere, so that none is copied
  if (method != Method::fast && method != Method::fast_cgal) {
    validate_method(method);
    validate(query, t_max);
    result = method == Method::oracle ? oracle::decide_by_oracle(query, t_max) : exact::decide_exactly(query, t_max);
    return result;
  }
  result.level = Level::filter;
  // The first test also proves that the query is valid. So most queries are read only once.
  if (is_time(t_max) && filters::same_side(query)) return result;
  validate(query, t_max);
  const ExactArithmetic& below = method == Method::fast ? kOwn : kCgal;
  const filters::Decision decision = filters::decide_by_filters({query, t_max, below.coplanarity_at}, result);
  if (decision.finding == filters::Finding::uncertain) result = below.decide_exactly(query, t_max);
  return result;
}

bool any_contact(const Query& query, double t_max) {
  if (is_time(t_max) && filters::same_side(query)) return false;
  validate(query, t_max);
  Answer ignored;
  const filters::Question question = {query, t_max, exact::coplanarity_at, true};
  const filters::Finding finding = filters::decide_by_filters(question, ignored).finding;
  if (finding != filters::Finding::uncertain) return finding == filters::Finding::contact;
  return exact::decide_exactly(query, t_max).contact;
}

}  // namespace touchstone::solver
