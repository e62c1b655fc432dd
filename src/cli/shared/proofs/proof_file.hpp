// The file of proofs that `touchstone prove` and `touchstone certify --proofs` write. docs/proofs.md defines it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <touchstone/answer.hpp>
#include <touchstone/separation.hpp>

#include "cli/shared/inputs.hpp"
#include "io/output_file.hpp"
#include "io/queries/query_parser.hpp"

namespace touchstone::cli {

/// The digest of a file's bytes; "-" for a pipe, which can be read only once.
std::string digest_of(const Input& input);

/// A proof is about a file that its reader has. @throws FileError  for a bundled one
void require_file(const Input& input);

/// A proof is about a query as touchstone-check reads it in that file.
/// @param chunk  with this query
/// @throws FileError  for doubles, decimals, separators that are no commas and so on. It names the command that writes
///                    the same queries as touchstone-check reads them
void require_plain_rows(const Input& input, const io::QueryChunk& chunk, const io::QueryRecord& record);

/// The proofs of some queries of one file, in the order of the file. Any thread may make them.
class ProvedQueries {
 public:
  /// Appends the proof of one answer.
  /// @throws FileError  that names the query, when the answer has no proof: then it is wrong
  void add(const Input& input, const io::QueryRecord& record, const Answer& answer, const Separation& separation);

 private:
  friend class ProofFile;

  std::string text_;
  std::uint64_t queries_ = 0;
  std::uint64_t contacts_ = 0;
};

/// Grows in the order of the queries, and appears when it is complete.
class ProofFile {
 public:
  /// @param path  "-": standard output
  /// @param inputs  the query files; they must outlive this object. @throws FileError  for a bundled one
  ProofFile(const std::string& path, const std::vector<Input>& inputs);

  /// Appends the next proofs. Each file's first ones begin its section.
  /// @param input  the file of these queries, an index into the inputs
  /// @param separation  the one of all queries of that file
  void add(std::size_t input, const Separation& separation, const ProvedQueries& proved);

  /// To be called after the last proofs: the file gets its last line and its name.
  /// @throws FileError  also for an input without a query: the checker refuses proofs of nothing
  void finish();

 private:
  io::OutputFile out_;
  const std::vector<Input>& inputs_;
  std::vector<std::uint64_t> proved_;  ///< queries of each input
  std::size_t begun_ = 0;              ///< files whose section has begun
  std::uint64_t queries_ = 0;
  std::uint64_t contacts_ = 0;
};

}  // namespace touchstone::cli
