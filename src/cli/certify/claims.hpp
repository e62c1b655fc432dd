// A file of claims, read in step with the queries that they are about.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <touchstone/certify.hpp>

#include "cli/certify/listed_claims.hpp"
#include "cli/shared/command_line/separation_options.hpp"
#include "cli/shared/inputs.hpp"
#include "io/answers/answer_reader.hpp"

namespace touchstone::cli {

/// A claim and the separation that it is about.
struct StatedClaim {
  Claim claim;
  Separation separation;
};

/// Whether the claims about one query file may be about several separations.
enum class SeparationsOfFile : bool { one, several };

/// The claims must be in the order of the queries, one for each. The `query` column of an answers file, if it has one,
/// counts from 0 within each query file, and its `file` column, if it has one, names the file as the command line does.
/// Files that listed_claims.hpp reads are no such table.
class ClaimStream {
 public:
  /// @param separation  what the claims must be about. When it is not given, a claim is about the separation of its
  ///                    row, and about touching when the file has no such column
  /// @param columns     of --columns; empty without
  /// @param decimals    what a toi in CSV stands for that is no double
  /// @throws FileError when the file cannot be read or holds no claims
  ClaimStream(const std::string& path, const io::ClaimColumns& columns, io::Decimals decimals,
              const std::vector<Input>& inputs, const SeparationOption& separation,
              SeparationsOfFile separations_of_file, std::size_t chunk_bytes);

  /// What the claims that were read leave out, for the verdict's line: "no times", "times for 1 of 5 contacts", "not
  /// read: 'ns'"; empty when nothing is.
  std::string left_out() const;

  /// Appends the claims about the queries of `item`. @throws FileError at the first that is missing, another query's,
  /// or about another separation
  void read(const QueryItem& item, std::vector<StatedClaim>& claims);

  /// To be called when there are no more queries. @throws FileError when there are more claims
  void finish();

 private:
  bool next(io::AnswerRow& row);
  void check_file(const io::AnswerRow& row, const Input& input);

  Separation separation_of(const io::AnswerRow& row) const;
  void check_one_separation(const Separation& separation, std::uint64_t row, std::uint64_t query, const Input& input);
  [[noreturn]] void refuse(std::uint64_t row, const std::string& reason) const;

  std::string name_;
  io::Decimals decimals_;
  const std::vector<Input>& inputs_;
  const SeparationOption& separation_;
  SeparationsOfFile separations_of_file_;
  Separation file_separation_;  ///< of the first claim about the present query file
  std::optional<io::AnswerReader> reader_;
  ListedClaims listed_;     ///< without a reader
  std::string known_file_;  ///< the last name that was compared, and found to be that of known_input_
  std::size_t known_input_ = 0;
  bool has_known_file_ = false;
  std::uint64_t claims_ = 0, contacts_ = 0, times_ = 0;  ///< read so far; contacts with a time
};

}  // namespace touchstone::cli
