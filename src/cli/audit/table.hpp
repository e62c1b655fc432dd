// The table of an audit.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <touchstone/query.hpp>

#include "cli/audit/engines.hpp"
#include "fuzz/engine.hpp"

namespace touchstone::cli {

/// One question about one kind of query.
struct AuditRow {
  std::string name;  ///< "fcl/linear"
  Kind kind = Kind::edge_edge;
  fuzz::SearchOutcome outcome;
};

/// Whether the engine was wrong beyond its tolerance, or gave no answer.
bool failed(const AuditRow& row);

/// A line a row, below its heading.
std::string audit_table(const std::vector<AuditRow>& rows);

/// A line about each engine that cannot be asked; of the others, each question with what is called, what it claims and
/// the notes of its description.
std::string engines_text(const std::vector<AuditedEngine>& engines);

}  // namespace touchstone::cli
