// SPDX-License-Identifier: MIT
#include "solver/cascade.hpp"

#include <algorithm>
#include <cmath>

#include "exact/exact.hpp"
#include "filters/filters.hpp"
#include "oracle/oracle.hpp"
#include "solver/validate.hpp"

namespace touchstone::solver {
namespace {

void validate(const Query& query, double t_max) {
  solver::validate(query.kind, query.start.data(), query.end.data(), t_max);
}

/// All coordinates times the power of two that makes the largest one about 1, which changes no answer; false when they are of
/// ordinary size or one would be rounded. Products of the others are out of the filters' range.
bool rescale(const Query& query, Query& scaled) noexcept {
  constexpr double kLeast = 0x1p-150;
  constexpr double kGreatest = 0x1p150;
  const std::size_t count = corner_count(query.kind);
  double largest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    for (const Vec3* x : {&query.start[i], &query.end[i]}) {
      largest = std::max({largest, std::fabs(x->x), std::fabs(x->y), std::fabs(x->z)});
    }
  }
  if (largest == 0 || (largest >= kLeast && largest <= kGreatest)) return false;
  const int exponent = std::ilogb(largest);
  bool exact = true;
  const auto times = [&](const Vec3& x) {
    const Vec3 y = {std::ldexp(x.x, -exponent), std::ldexp(x.y, -exponent), std::ldexp(x.z, -exponent)};
    exact = exact && std::ldexp(y.x, exponent) == x.x && std::ldexp(y.y, exponent) == x.y &&
            std::ldexp(y.z, exponent) == x.z;
    return y;
  };
  scaled.kind = query.kind;
  for (std::size_t i = 0; i < count; ++i) {
    scaled.start[i] = times(query.start[i]);
    scaled.end[i] = times(query.end[i]);
  }
  return exact;
}

/// The arithmetic without error below the filters and the bracket level.
struct ExactArithmetic {
  filters::ExactValue coplanarity_at;
  Answer (*decide)(const Query& query, double t_max);
};
constexpr ExactArithmetic kOwn = {exact::coplanarity_at, exact::decide};
constexpr ExactArithmetic kCgal = {oracle::coplanarity_at, oracle::decide};

/// What filters and bracket level say of a query that they leave uncertain as it is, when they see it rescaled.
filters::Decision decide_rescaled(const Query& query, double t_max, filters::Want want, filters::ExactValue exact_value,
                                  Answer& answer) {
  Query scaled;
  if (!rescale(query, scaled)) return filters::Decision::uncertain;
  if (filters::same_side(scaled)) return filters::Decision::no_contact;
  return filters::decide(scaled, t_max, want, exact_value, answer);
}

/// What they say of a valid query that the first filter leaves.
filters::Decision decide_before_exact(const Query& query, double t_max, filters::Want want,
                                      filters::ExactValue exact_value, Answer& answer) {
  const auto decision = filters::decide(query, t_max, want, exact_value, answer);
  return decision != filters::Decision::uncertain ? decision : decide_rescaled(query, t_max, want, exact_value, answer);
}

}  // namespace

Answer answer(const Query& query, Method method, double t_max) {
  Answer result;  // the one object that is returned everywhere, so that none is copied
  if (method != Method::fast && method != Method::fast_cgal) {
    validate(query, t_max);
    result = method == Method::oracle ? oracle::decide(query, t_max) : exact::decide(query, t_max);
    return result;
  }
  result.level = Level::filter;
  // Proves its query valid, too; so most coordinates are read once.
  if (is_time(t_max) && filters::same_side(query)) return result;
  validate(query, t_max);
  const ExactArithmetic& below = method == Method::fast ? kOwn : kCgal;
  const auto decision = decide_before_exact(query, t_max, filters::Want::everything, below.coplanarity_at, result);
  if (decision == filters::Decision::uncertain) result = below.decide(query, t_max);
  return result;
}

bool any_contact(const Query& query, double t_max) {
  if (is_time(t_max) && filters::same_side(query)) return false;
  validate(query, t_max);
  Answer ignored;
  switch (decide_before_exact(query, t_max, filters::Want::contact_only, exact::coplanarity_at, ignored)) {
    case filters::Decision::contact: return true;
    case filters::Decision::no_contact: return false;
    case filters::Decision::uncertain: break;
  }
  return exact::decide(query, t_max).contact;
}

}  // namespace touchstone::solver
