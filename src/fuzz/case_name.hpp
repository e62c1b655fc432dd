// The name of one fuzzed query: with it, it is made again.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <touchstone/query.hpp>

#include "families/families.hpp"

namespace touchstone::fuzz {

/// A query of a family or one that was given, or one of those that hill climbing comes to from there.
struct CaseName {
  families::CaseId start;
  std::uint64_t step = 0;  ///< 0: the query itself
  bool given = false;      ///< start.index counts the queries that were given; start.family means nothing
};

/// "near_hit edge-edge 7 1234", or "near_hit edge-edge 7 1234 +5" for the fifth step of climbing from there; "given
/// edge-edge 7 1234" for one that was given.
std::string case_text(const CaseName& name);

/// Back; nothing when the text is no case.
std::optional<CaseName> parse_case_text(std::string_view text);

/// The query itself. Climbing that far takes so many steps again.
/// @param given  the queries that were given  @throws InvalidQuery when it is one of these and there is none such
Query query_of_case(const CaseName& name, const std::vector<Query>& given = {});

/// Where the case starts: its query at step 0.
Query start_of_case(const CaseName& name, const std::vector<Query>& given);

}  // namespace touchstone::fuzz
