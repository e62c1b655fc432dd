// The name of one fuzzed query: with it, it is made again.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <touchstone/query.hpp>

#include "families/families.hpp"

namespace touchstone::fuzz {

/// A query of a family, or one of those that hill climbing comes to from there.
struct CaseName {
  families::CaseId start;
  std::uint64_t step = 0;  ///< 0: the family's query itself
};

/// "near_hit edge-edge 7 1234", or "near_hit edge-edge 7 1234 +5" for the fifth step of climbing from there.
std::string case_text(const CaseName& name);

/// Back; nothing when the text is no case.
std::optional<CaseName> parse_case_text(std::string_view text);

/// The query itself. Climbing that far takes so many steps again.
Query query_of_case(const CaseName& name);

}  // namespace touchstone::fuzz
