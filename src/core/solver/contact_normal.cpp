// SPDX-License-Identifier: MIT
#include <touchstone/contact_normal.hpp>

#include <touchstone/curved.hpp>
#include <touchstone/error.hpp>

#include "exact/exact.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "solver/validate.hpp"

namespace touchstone {
inline namespace TOUCHSTONE_ABI {
namespace {

template <class AnyQuery>
std::optional<std::array<double, 3>> normal_of(const AnyQuery& query, const Separation& separation, double t_max) {
  const numbers::DefaultFloatEnvironment environment;
  solver::validate(separation);
  solver::validate(query, t_max);
  if (separation.distance > 0 && separation.metric != Metric::euclidean) {
    throw InvalidQuery("the normal needs the Euclidean metric: in the metric max the closest points are not unique");
  }
  return exact::contact_normal(query, t_max, separation);
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

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
