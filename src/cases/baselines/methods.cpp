// The registry.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "baselines/baseline.hpp"

namespace touchstone::baselines {
namespace {

bool every_kind(Kind) { return true; }

}  // namespace

const std::vector<Baseline>& methods() {
  static const std::vector<Baseline> all{
      {"paper", "the cubic by Cardano's formulas as printed; misses planar, parallel, grazing and boundary contacts",
       Tolerance::none, 0, coplanar_kinds, solve_paper},
      {"closed_form",
       "the same with every care that doubles allow; fixed slacks: rare misses, phantoms, toi late by ulps",
       Tolerance::none, 0, every_kind, solve_closed_form},
      {"newton", "bracketed Newton steps to a tolerance; phantoms within it, misses small fast elements",
       Tolerance::fraction, 1e-6, every_kind, solve_newton},
      {"interval", "inclusion of the difference over time and weights; misses nothing, phantoms within the tolerance",
       Tolerance::length, 1e-6, every_kind, solve_interval},
      {"conservative_advancement", "steps of distance over speed; phantoms within the tolerance, rounded steps miss",
       Tolerance::length, 1e-6, every_kind, solve_conservative_advancement},
  };
  return all;
}

const Baseline* find_method(std::string_view name) {
  const auto& all = methods();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Baseline& method) { return method.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace touchstone::baselines
