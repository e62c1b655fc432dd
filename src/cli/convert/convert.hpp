// `touchstone convert`: query files from one format to another, exactly.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include <touchstone/query.hpp>

#include "cli/shared/command_line/command.hpp"
#include "io/queries/curved_rows.hpp"
#include "io/queries/query_chunks.hpp"
#include "io/queries/query_file_writer.hpp"

namespace touchstone::cli {

struct ConvertOptions {
  enum class Claims : std::uint8_t { keep, drop, solve };

  std::string from;
  std::string to;
  std::optional<io::QueryFormat> format;  ///< nothing: the ending of `to` says it
  std::optional<Kind> kind;
  Claims claims = Claims::keep;
  bool unsigned_zeros = false;
  io::Decimals decimals = io::Decimals::exact;
  io::Turns turns = io::Turns::as_given;  ///< of the bodies of curved queries
  std::string group;                      ///< of an HDF5 file that is read; empty: the benchmark's, or else the root
  int threads = 0;                        ///< 0: all that the machine has
  std::size_t chunk_bytes = io::kChunkBytes;  ///< for tests: no result depends on it
};

/// @returns the exit status. @throws FileError, Error
int run_convert(const ConvertOptions& options);

void add_convert(CLI::App& program, Command& command);

}  // namespace touchstone::cli
