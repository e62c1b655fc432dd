// The query files that a command reads: named on the command line, or bundled with the program.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <touchstone/query.hpp>

#include "io/input_file.hpp"
#include "io/queries/query_chunks.hpp"
#include "io/queries/query_parser.hpp"

namespace touchstone::cli {

struct Input {
  std::string name;  ///< as given; bundled files are called "bundled/KIND/FAMILY.csv"
  Kind kind = Kind::edge_edge;
  std::optional<std::uint64_t> bytes;  ///< nothing for a pipe
  std::string_view content;            ///< of a bundled file
  bool bundled = false;
  io::Decimals decimals = io::Decimals::exact;

  io::InputFile open() const;
};

/// @throws Error  where - , standard input, is among the names of files to read more than once
void refuse_standard_input_twice(const std::vector<std::string>& names);

/// The files of these names. Each is checked to exist; a name that is no file may be the name of a bundled file.
/// @param kind  the kind of their queries; by default a file of doubles states it, and else a file's folder names it
/// @param decimals  what decimals stand for that are no doubles
/// @throws FileError
std::vector<Input> find_inputs(const std::vector<std::string>& names, std::optional<Kind> kind,
                               io::Decimals decimals = io::Decimals::exact);

/// Every bundled file, or those of straight motion. @throws FileError when the program was built without them
std::vector<Input> bundled_inputs(io::Motions motions);

/// Those of them whose truth column is about touching.
std::vector<Input> bundled_touching_inputs(io::Motions motions = io::Motions::straight);

/// One item of the pipeline: some queries of one input.
struct QueryItem {
  std::size_t input = 0;  ///< index into the inputs
  io::QueryChunk chunk;
  io::LongerTurns longer_turns;  ///< of the queries that were parsed
  std::exception_ptr error;      ///< the error that came after the readable queries of this item
};

/// The chunks of several files, one file after the other.
class QueryStream {
 public:
  /// @param motions  with Motions::straight a file of curved queries is refused
  QueryStream(const std::vector<Input>& inputs, std::size_t chunk_bytes, io::Motions motions = io::Motions::straight);

  /// @returns false after the last chunk of the last file. @throws FileError
  bool next(QueryItem& item);

 private:
  const std::vector<Input>& inputs_;
  std::size_t chunk_bytes_;
  io::Motions motions_;
  std::size_t current_ = 0;
  std::optional<io::QueryChunkReader> reader_;
};

/// Calls take(input, record) for every query of the files, in their order, `input` being an index into the inputs.
/// @param motions  with Motions::straight a file of curved queries is refused
/// @throws FileError; and Interrupted, as throw_if_interrupted does
void for_each_query(const std::vector<Input>& inputs,
                    const std::function<void(std::size_t input, const io::QueryRecord& record)>& take,
                    io::Motions motions = io::Motions::straight);

}  // namespace touchstone::cli
