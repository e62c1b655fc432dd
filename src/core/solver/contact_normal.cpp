// SPDX-License-Identifier: MIT
#include <touchstone/contact_normal.hpp>

#include <touchstone/curved.hpp>
#include <touchstone/error.hpp>
#include <touchstone/toi_gradient.hpp>

#include <string>

#include "exact/exact.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "solver/validate.hpp"

namespace touchstone {
inline namespace TOUCHSTONE_ABI {
namespace {

template <class AnyQuery>
void validate(const AnyQuery& query, const Separation& separation, double t_max, const char* wanted) {
  solver::validate(separation);
  solver::validate(query, t_max);
  if (separation.distance > 0 && separation.metric != Metric::euclidean) {
    throw InvalidQuery("the " + std::string(wanted) +
                       " needs the Euclidean metric: in the metric max the closest points are not unique");
  }
}

template <class AnyQuery>
std::optional<std::array<double, 3>> normal_of(const AnyQuery& query, const Separation& separation, double t_max) {
  const numbers::DefaultFloatEnvironment environment;
  validate(query, separation, t_max, "normal");
  return exact::contact_normal(query, t_max, separation);
}

template <class AnyQuery>
ToiGradient gradient_of(const AnyQuery& query, const Separation& separation, double t_max) {
  const numbers::DefaultFloatEnvironment environment;
  validate(query, separation, t_max, "gradient");
  const auto gradient = exact::toi_gradient(query, t_max, separation);
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
  return gradient_of(query, separation, t_max);
}

ToiGradient toi_gradient(const RationalQuery& query, const Separation& separation, double t_max) {
  return gradient_of(query, separation, t_max);
}

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
