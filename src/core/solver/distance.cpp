// SPDX-License-Identifier: MIT
#include <touchstone/distance.hpp>

#include "exact/exact.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "numbers/integers/limb_scratch.hpp"
#include "solver/validate.hpp"

namespace touchstone {
inline namespace TOUCHSTONE_ABI {
namespace {

template <class AnyQuery>
Distance distance_of(const AnyQuery& query, double t, Metric metric) {
  const numbers::DefaultFloatEnvironment environment;
  solver::validate(Separation{0, metric});
  solver::validate_time(t);
  solver::validate(query, t);
  const numbers::LimbScratch scratch;  // no number outlives the question
  return exact::distance_at(query, t, metric);
}

template <class AnyQuery>
int compare(const AnyQuery& query, double t, const Separation& separation) {
  const numbers::DefaultFloatEnvironment environment;
  solver::validate(separation);
  solver::validate_time(t);
  solver::validate(query, t);
  const numbers::LimbScratch scratch;
  return exact::compare_distance(query, t, separation);
}

}  // namespace

Distance distance(const Query& query, double t, Metric metric) { return distance_of(query, t, metric); }
Distance distance(const RationalQuery& query, double t, Metric metric) { return distance_of(query, t, metric); }
Distance distance(const CurvedQuery& query, double t, Metric metric) { return distance_of(query, t, metric); }

int compare_distance(const Query& query, double t, const Separation& separation) {
  return compare(query, t, separation);
}
int compare_distance(const RationalQuery& query, double t, const Separation& separation) {
  return compare(query, t, separation);
}
int compare_distance(const CurvedQuery& query, double t, const Separation& separation) {
  return compare(query, t, separation);
}

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
