// SPDX-License-Identifier: MIT
#include <touchstone/contact_normal.hpp>

#include <touchstone/curved.hpp>
#include <touchstone/error.hpp>
#include <touchstone/toi_gradient.hpp>

#include <string>

#include "exact/exact.hpp"
#include "filters/coplanar_gradient.hpp"
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
  const Answer answer = solver::answer(query, separation, Method::fast, t_max, Wanted::features);
  if (!answer.contact || answer.toi_upper == 0) return {};
  if (separation.distance == 0) {
    // Elsewhere V' is 0, or a small change gives the contact to other features.
    const bool inside =
        answer.feature_a == Feature::a ? answer.feature_b == Feature::b : answer.feature_b == Feature::f;
    if (!inside || answer.nature != Nature::crossing) return {};
    geometry::EndGradients gradient;
    if (filters::coplanar_gradient(query, answer.toi, answer.toi_upper, gradient)) {
      return {true, gradient[0], gradient[1]};
    }
  }
  return gradient_of(exact::toi_gradient(query, t_max, separation));
}

ToiGradient toi_gradient(const RationalQuery& query, const Separation& separation, double t_max) {
  const numbers::DefaultFloatEnvironment environment;
  validate(query, separation, t_max, "gradient");
  return gradient_of(exact::toi_gradient(query, t_max, separation));
}

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
