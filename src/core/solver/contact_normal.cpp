// SPDX-License-Identifier: MIT
#include <touchstone/contact_normal.hpp>

#include <touchstone/curved.hpp>
#include <touchstone/error.hpp>
#include <touchstone/toi_gradient.hpp>

#include <string>

#include "exact/exact.hpp"
#include "filters/coplanar_gradient.hpp"
#include "filters/filters.hpp"
#include "filters/separation/entry_gradient.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "solver/cascade.hpp"
#include "solver/validate.hpp"

namespace touchstone {
inline namespace TOUCHSTONE_ABI {
namespace {

void refuse_max(const Separation& separation, const char* wanted) {
  if (separation.distance > 0 && separation.metric != Metric::euclidean) {
    throw InvalidQuery("the " + std::string(wanted) +
                       " needs the Euclidean metric: in the metric max the closest points are not unique");
  }
}

template <class AnyQuery>
void validate(const AnyQuery& query, const Separation& separation, double t_max, const char* wanted) {
  solver::validate(separation);
  solver::validate(query, t_max);
  refuse_max(separation, wanted);
}

template <class AnyQuery>
std::optional<std::array<double, 3>> normal_of(const AnyQuery& query, const Separation& separation, double t_max) {
  const numbers::DefaultFloatEnvironment environment;
  validate(query, separation, t_max, "normal");
  return exact::contact_normal(query, t_max, separation);
}

/// `contact`: the gradient is written. `no_contact`: there is none.
filters::Outcome touching_gradient_in_doubles(const Query& query, double t_max, geometry::EndGradients& gradient) {
  using filters::Outcome;
  const Answer answer = solver::answer(query, Method::fast, t_max, Wanted::features);
  // Elsewhere V' is 0, or a small change gives the contact to other features.
  const bool inside = answer.feature_a == Feature::a ? answer.feature_b == Feature::b : answer.feature_b == Feature::f;
  if (!inside || answer.nature != Nature::crossing || answer.toi_upper == 0) return Outcome::no_contact;
  const bool known = filters::coplanar_gradient(query, answer.toi, answer.toi_upper, gradient);
  return known ? Outcome::contact : Outcome::uncertain;
}

filters::Outcome gradient_in_doubles(const Query& query, const Separation& separation, double t_max,
                                     geometry::EndGradients& gradient) {
  using filters::Outcome;
  if (separation.distance == 0) return touching_gradient_in_doubles(query, t_max, gradient);
  if (solver::is_time(t_max) && filters::clear_all_along(query, separation)) return Outcome::no_contact;
  solver::validate(query, t_max);
  Answer answer;
  numbers::BoundedPair time;
  const Outcome found = filters::decide_by_filters(query, separation, t_max, answer, &time);
  if (found != Outcome::contact) return found;
  if (answer.toi_upper == 0) return Outcome::no_contact;
  return filters::entry_gradient(query, answer, time, gradient) ? Outcome::contact : Outcome::uncertain;
}

ToiGradient gradient_of(const std::optional<geometry::EndGradients>& gradient) {
  return gradient ? ToiGradient{true, (*gradient)[0], (*gradient)[1]} : ToiGradient();
}

}  // namespace

std::optional<std::array<double, 3>> contact_normal(const Query& query, const Separation& separation, double t_max) {
  return normal_of(query, separation, t_max);
}

std::optional<std::array<double, 3>> contact_normal(const RationalQuery& query, const Separation& separation,
                                                    double t_max) {
  return normal_of(query, separation, t_max);
}

std::optional<std::array<double, 3>> contact_normal(const CurvedQuery& query, const Separation& separation,
                                                    double t_max) {
  return normal_of(query, separation, t_max);
}

ToiGradient toi_gradient(const Query& query, const Separation& separation, double t_max) {
  const numbers::DefaultFloatEnvironment environment;
  solver::validate(separation);
  refuse_max(separation, "gradient");
  geometry::EndGradients gradient;
  const filters::Outcome found = gradient_in_doubles(query, separation, t_max, gradient);
  if (found == filters::Outcome::no_contact) return {};
  if (found == filters::Outcome::contact) return {true, gradient[0], gradient[1]};
  return gradient_of(exact::toi_gradient(query, t_max, separation));
}

ToiGradient toi_gradient(const RationalQuery& query, const Separation& separation, double t_max) {
  const numbers::DefaultFloatEnvironment environment;
  validate(query, separation, t_max, "gradient");
  return gradient_of(exact::toi_gradient(query, t_max, separation));
}

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
