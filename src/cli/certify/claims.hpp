// A file of claims, read in step with the queries that they are about.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
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

/// The separations of claims: all the same one, or several.
class Questions {
 public:
  void add(const Separation& separation);
  void merge(const Questions& other);

  /// Nothing when there are several; touching when there is none.
  std::optional<Separation> only() const {
    return several_ ? std::nullopt : std::optional(first_.value_or(Separation()));
  }

 private:
  std::optional<Separation> first_;
  bool several_ = false;
};

/// Whether the claims about one query file may be about several separations.
enum class SeparationsOfFile : bool { one, several };

/// One claim for each query. The `query` column of an answers file, if it has one, counts from 0 within each query
/// file, and its `file` column, if it has one, names the file as the command line does. Without a `query` column the
/// claims are in the order of the queries, and so they are without a `file` column where there are several query
/// files. Otherwise they may have any order; claims that come before those of earlier queries are held in memory.
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
              SeparationsOfFile separations_of_file, io::MissingClaim missing, std::size_t chunk_bytes);

  /// What the claims that were read leave out, for the verdict's line: "claims without 'contact' have one unless 'toi'
  /// denies it", "no times", "times for 1 of 5 contacts", "no contact at 3 queries without a claim", "not read: 'ns'";
  /// empty when nothing is.
  std::string left_out() const;

  /// Appends the claims about the queries of `item`. @throws FileError at the first that is missing, the second about a
  /// query, or about another separation
  void read(const QueryItem& item, std::vector<StatedClaim>& claims);

  /// To be called when there are no more queries. @throws FileError when there are more claims
  void finish();

 private:
  /// The query that a claim is about: the index of its file, and its number there.
  using Subject = std::pair<std::size_t, std::uint64_t>;

  struct ReadClaim {
    StatedClaim stated;
    std::uint64_t row = 0;  ///< 0: none is said
  };

  bool next(io::AnswerRow& row);
  Subject subject_of(const io::AnswerRow& row, Subject expected);
  std::size_t file_of(const io::AnswerRow& row, std::size_t expected);
  ReadClaim claim_about(Subject subject);
  ReadClaim missing_claim(Subject subject);
  ReadClaim count(const io::AnswerRow& row);
  void refuse_second(std::uint64_t row, Subject subject) const;
  [[noreturn]] void refuse_file(std::uint64_t row, std::string_view file) const;
  void refuse_unheld(std::size_t file) const;
  [[noreturn]] void refuse_number(std::uint64_t row, Subject subject, std::uint64_t queries) const;
  std::string name_of_query(Subject subject) const;

  Separation separation_of(const io::AnswerRow& row) const;
  void check_one_separation(const ReadClaim& claim, Subject subject);
  [[noreturn]] void refuse(std::uint64_t row, const std::string& reason) const;

  std::string name_;
  io::Decimals decimals_;
  const std::vector<Input>& inputs_;
  const SeparationOption& separation_;
  SeparationsOfFile separations_of_file_;
  io::MissingClaim missing_;
  Separation file_separation_;  ///< of the first claim about the present query file
  std::optional<io::AnswerReader> reader_;
  ListedClaims listed_;                  ///< without a reader
  std::vector<std::string> paths_;       ///< of the inputs, without . and ..
  std::string known_file_, known_path_;  ///< the last name that a row had, and its path
  std::map<Subject, ReadClaim> held_;    ///< the claims about later queries than those before them in the file
  std::vector<std::uint64_t> queries_;   ///< of each input, so far
  bool has_numbers_ = false;             ///< of queries
  bool implied_contacts_ = false;        ///< claims may not say whether there is contact
  Questions questions_;                  ///< of all claims that were read
  std::uint64_t claims_ = 0, contacts_ = 0, times_ = 0;  ///< read so far; contacts with a time
  std::uint64_t without_claim_ = 0;
};

}  // namespace touchstone::cli
