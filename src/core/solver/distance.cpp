// SPDX-License-Identifier: MIT
#include <touchstone/distance.hpp>

#include <cmath>
#include <limits>
#include <type_traits>

#include "exact/exact.hpp"
#include "filters/separation/distance_bound.hpp"
#include "filters/separation/precise_distance.hpp"
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
  if constexpr (std::is_same_v<AnyQuery, Query>) {
    if (const auto distance = filters::precise_distance(query, t, metric)) return *distance;
  }
  const numbers::LimbScratch scratch;  // no number outlives the question
  return exact::distance_at(query, t, metric);
}

template <class AnyQuery>
int compare(const AnyQuery& query, double t, const Separation& separation) {
  const numbers::DefaultFloatEnvironment environment;
  solver::validate(separation);
  solver::validate_time(t);
  solver::validate(query, t);
  if constexpr (std::is_same_v<AnyQuery, Query>) {
    if (const int side = filters::side_of_distance(query, t, separation)) return side;
    if (const int side = filters::precise_side_of_distance(query, t, separation)) return side;
  }
  const numbers::LimbScratch scratch;
  return exact::compare_distance(query, t, separation);
}

}  // namespace

Distance distance(const Query& query, double t, Metric metric) { return distance_of(query, t, metric); }
Distance distance(const RationalQuery& query, double t, Metric metric) { return distance_of(query, t, metric); }
Distance distance(const CurvedQuery& query, double t, Metric metric) { return distance_of(query, t, metric); }

double distance_upper_bound(const Query& query, double t) {
  const numbers::DefaultFloatEnvironment environment;
  solver::validate_time(t);
  solver::validate(query, t);
  if (const auto bound = filters::distance_bound(query, t)) return *bound;
  const numbers::LimbScratch scratch;
  if (exact::compare_distance(query, t, Separation()) == 0) return 0;
  return std::nextafter(exact::distance_at(query, t, Metric::euclidean).value, std::numeric_limits<double>::infinity());
}

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
