// A proved answer as a theorem of Coq, about the definitions in src/proofs/proved/Statement.v. docs/proved.md says how
// it is checked.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <touchstone/answer.hpp>
#include <touchstone/curved_query.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

namespace touchstone::proofs {

/// What a theorem is called, and what its file says of the query.
struct TheoremTitle {
  std::string name;    ///< an identifier of Coq
  std::string origin;  ///< where the query is from: one line of any text
};

/// The text of a file for coqc: the proof that `prove` finds, the corners, and last the theorem.
/// @throws Error  for an answer that has no proof
std::string theorem_of(const TheoremTitle& title, const Query& query, const Answer& answer,
                       const Separation& separation = {});
std::string theorem_of(const TheoremTitle& title, const RationalQuery& query, const Answer& answer,
                       const Separation& separation = {});
std::string theorem_of(const TheoremTitle& title, const CurvedQuery& query, const Answer& answer,
                       const Separation& separation = {});

}  // namespace touchstone::proofs
