// In which way a query is degenerate: failures of one sort are one finding.
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>
#include <string>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>

namespace touchstone::fuzz {

/// How the elements touch and which of the polynomials that decide it vanish identically.
struct Degeneracy {
  Kind kind = Kind::edge_edge;
  Nature nature = Nature::none;
  Feature feature_a = Feature::none;
  Feature feature_b = Feature::none;
  std::uint8_t vanishing = 0;  ///< a bit for each polynomial that `vanishing_names` can name

  auto operator<=>(const Degeneracy&) const = default;
};

/// Of a query with finite coordinates and its exact answer. The polynomials are computed exactly.
Degeneracy degeneracy_of(const Query& query, const Answer& truth);

/// For a person: "sustained, a0 against b, V = n = 0", "no contact".
std::string degeneracy_text(const Degeneracy& degeneracy);

}  // namespace touchstone::fuzz
