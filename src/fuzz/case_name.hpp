// The name of one fuzzed query, from which the query is made again.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

#include "families/families.hpp"
#include "fuzz/any_query.hpp"
#include "fuzz/auditing/claims.hpp"
#include "fuzz/climb.hpp"

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

/// What the names of one run refer to, besides the families.
struct CaseSource {
  const std::vector<AnyQuery>& given;
  Separation separation = {};  ///< of every query
  bool own =
      false;  ///< each query has a distance of its own instead, see families::make_separated and make_curved_separated
  const Claims* claims = nullptr;  ///< each straight query is the nearest one of these
};

/// A query, and what it is asked about.
struct Asked {
  AnyQuery query;
  Separation separation;
  double t_max = 1;  ///< the end of the time range; 1 for straight queries
};

/// A case of step n takes n steps of climbing again.
/// @throws InvalidQuery when the case is a given query that is not among the given ones
Asked asked_in_case(const CaseName& name, const CaseSource& source);

/// The same for the case's step 0.
Asked start_of_case(const CaseName& name, const CaseSource& source);

/// The walk from there.
Climb climb_from(const CaseName& name, const CaseSource& source);

/// The query of a straight case alone, for contact.
Query query_of_case(const CaseName& name, const std::vector<AnyQuery>& given = {});

}  // namespace touchstone::fuzz
