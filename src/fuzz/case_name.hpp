// The name of one fuzzed query, from which the query is made again.
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

/// A query of a family, or a given query, or a query that hill climbing reaches from one of these.
struct CaseName {
  families::CaseId start;
  std::uint64_t step = 0;  ///< 0: the query itself
  bool given = false;      ///< start.index is the position among the given queries; start.family has no meaning
};

/// "near_hit edge-edge 7 1234", or "near_hit edge-edge 7 1234 +5" for the fifth step of climbing from there; "given
/// edge-edge 7 1234" for a given query.
std::string case_text(const CaseName& name);

/// The inverse of case_text; nothing when the text is no case.
std::optional<CaseName> parse_case_text(std::string_view text);

/// The query itself. A case of step n takes n steps of climbing again.
/// @param given  the given queries  @throws InvalidQuery when the case is a given query that is not among them
Query query_of_case(const CaseName& name, const std::vector<Query>& given = {});

/// The query at step 0 of the case.
Query start_of_case(const CaseName& name, const std::vector<Query>& given);

}  // namespace touchstone::fuzz
