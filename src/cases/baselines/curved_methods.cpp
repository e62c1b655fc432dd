// The registry of methods for curved queries.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "baselines/curved_baseline.hpp"

namespace touchstone::baselines {
const std::vector<CurvedBaseline>& curved_methods() {
  static const std::vector<CurvedBaseline> all{
      {"redon", "interval arithmetic over time; misses parallel and grazing contacts, phantoms within the tolerance",
       Tolerance::fraction, 1e-6, coplanar_kinds, solve_redon},
      {"curved_advancement",
       "steps of distance over a bound on speed; phantoms within the tolerance, rounded steps miss", Tolerance::length,
       1e-6, coplanar_kinds, solve_curved_advancement},
  };
  return all;
}

const CurvedBaseline* find_curved_method(std::string_view name) {
  const auto& all = curved_methods();
  const auto found = std::find_if(all.begin(), all.end(), [&](const CurvedBaseline& m) { return m.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace touchstone::baselines
