// One query of a file, by its number.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "cli/shared/command_line/turns.hpp"
#include "cli/shared/inputs.hpp"
#include "io/queries/query_chunks.hpp"
#include "io/queries/query_parser.hpp"

namespace touchstone::cli {

/// A query and the piece of the file that holds it. Only that piece is parsed.
struct FoundQuery {
  std::optional<Separation> truth_separation;  ///< what the file says that its truth column is about
  io::QueryChunk chunk;                        ///< record.text lies in here
  io::QueryRecord record;
};

/// A CLI11 check of a query's number: "", or the reason why the text is none.
std::string check_query_number(const std::string& text);

/// Tells of the longer turn of a body, too, with TurnNotes's advice. @throws FileError  for a file that has no such query
std::unique_ptr<FoundQuery> find_query(const Input& input, std::uint64_t number, io::Turns turns = io::Turns::as_given,
                                       const std::string& advice = kTakeShorterTurns);

/// "query 3 of a.csv (rows 25 to 32), edge-edge"
std::string heading(const Input& input, const io::QueryRecord& record);

}  // namespace touchstone::cli
