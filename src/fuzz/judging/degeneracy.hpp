// The way in which a query is degenerate. Failures with one class and one degeneracy are one finding.
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>
#include <string>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>

#include "fuzz/any_query.hpp"

namespace touchstone::fuzz {

/// How the elements touch, and which of the deciding polynomials vanish identically.
struct Degeneracy {
  Kind kind = Kind::edge_edge;
  Nature nature = Nature::none;
  Feature feature_a = Feature::none;
  Feature feature_b = Feature::none;
  std::uint8_t vanishing = 0;  ///< a bit for each polynomial that `vanishing_names` can name

  bool curved = false;

  auto operator<=>(const Degeneracy&) const = default;
};

/// The degeneracy of a valid query and its exact answer. The polynomials are computed exactly.
Degeneracy degeneracy_of(const AnyQuery& query, const Answer& truth);

/// For a person: "sustained, a0 against b, V = n = 0", "no contact".
std::string degeneracy_text(const Degeneracy& degeneracy);

}  // namespace touchstone::fuzz
