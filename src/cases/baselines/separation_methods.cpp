// The registry of the methods with a separation.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "baselines/separation_baseline.hpp"

namespace touchstone::baselines {

const std::vector<SeparationBaseline>& separation_methods() {
  static const std::vector<SeparationBaseline> all{
      {"thick_advancement",
       "steps of gap over speed until a tenth of the gap is left; early, phantoms near the separation",
       Tolerance::fraction, 0.1, solve_thick_advancement},
      {"thick_polynomial",
       "roots of the degree-6 polynomial in doubles; misses grazing, late by ulps, small distances drown",
       Tolerance::none, 0, solve_thick_polynomial},
  };
  return all;
}

const SeparationBaseline* find_separation_method(std::string_view name) {
  const auto& all = separation_methods();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& method) { return method.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace touchstone::baselines
