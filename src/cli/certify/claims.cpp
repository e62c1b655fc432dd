// SPDX-License-Identifier: MIT
#include "cli/certify/claims.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "cli/shared/progress/interrupt.hpp"
#include "cli/shared/words.hpp"
#include "io/fail.hpp"
#include "io/queries/separation_text.hpp"

namespace touchstone::cli {

ClaimStream::ClaimStream(const std::string& path, const io::ClaimColumns& columns, io::Decimals decimals,
                         const std::vector<Input>& inputs, const SeparationOption& separation,
                         SeparationsOfFile separations_of_file, std::size_t chunk_bytes)
    : name_(without_dash(path)),
      decimals_(decimals),
      inputs_(inputs),
      separation_(separation),
      separations_of_file_(separations_of_file) {
  if (is_list_of_claims(name_)) {
    listed_ = read_listed_claims(name_, columns);
  } else {
    reader_.emplace(io::InputFile::open(name_, throw_if_interrupted), columns, chunk_bytes);
  }
}

std::string ClaimStream::left_out() const {
  const std::vector<std::string>& unread = reader_ ? reader_->unread_columns() : listed_.unread;
  std::string text;
  if (times_ < contacts_) {
    text = times_ == 0 ? "no times" : fmt::format("times for {} of {}", grouped(times_), counted(contacts_, "contact"));
  }
  if (unread.empty()) return text;
  text += std::string(text.empty() ? "" : ", ") + "not read:";
  constexpr std::size_t kMost = 5;
  for (std::size_t i = 0; i < unread.size() && i < kMost; ++i)
    text += (i == 0 ? " " : " and ") + io::in_quotes(unread[i]);
  if (unread.size() > kMost) text += " and " + std::to_string(unread.size() - kMost) + " more";
  return text;
}

void ClaimStream::read(const QueryItem& item, std::vector<StatedClaim>& claims) {
  const Input& input = inputs_[item.input];
  for (std::size_t i = 0; i < item.chunk.query_count; ++i) {
    const std::uint64_t query = item.chunk.first_query + i;
    io::AnswerRow row;
    if (!next(row)) {
      refuse(reader_ ? reader_->last_row() : 0, fmt::format("the claims end here, after {}; query {} of {} has none",
                                                            grouped(claims_), query, io::printable(input.name)));
    }
    if (row.file && !(has_known_file_ && known_input_ == item.input && known_file_ == *row.file)) {
      check_file(row, input);
      known_file_ = *row.file;
      known_input_ = item.input;
      has_known_file_ = true;
    }
    if (row.query.value_or(query) != query) {
      refuse(row.row,
             fmt::format("query is {} where {} of {} comes next; claims must be in the order of the queries, one each",
                         *row.query, query, io::printable(input.name)));
    }
    if (decimals_ == io::Decimals::nearest_double) row.toi_as_written = {};
    const Separation separation = separation_of(row);
    if (separations_of_file_ == SeparationsOfFile::one) check_one_separation(separation, row.row, query, input);
    claims.push_back({{row.contact, row.toi, std::string(row.toi_as_written)}, separation});
    ++claims_;
    contacts_ += row.contact ? 1 : 0;
    times_ += row.toi ? 1 : 0;
  }
}

void ClaimStream::finish() {
  io::AnswerRow row;
  if (!next(row)) return;
  refuse(row.row, fmt::format("a claim too many; there are only {} in the query files", counted(claims_, "query")));
}

bool ClaimStream::next(io::AnswerRow& row) {
  if (reader_) return reader_->next(row);
  if (claims_ == listed_.claims.size()) return false;
  const ListedClaim& claim = listed_.claims[claims_];
  if (claim.file) row.file = *claim.file;
  row.separation = claim.separation;
  row.query = claim.query;
  row.contact = claim.contact;
  row.toi = claim.toi;
  return true;
}

void ClaimStream::refuse(std::uint64_t row, const std::string& reason) const {
  if (!reader_) io::fail(name_, reason);
  io::fail(name_, row, reason);
}

Separation ClaimStream::separation_of(const io::AnswerRow& row) const {
  if (!separation_.given) return row.separation.value_or(Separation());
  if (row.separation && !io::same_question(*row.separation, separation_.separation)) {
    refuse(row.row, fmt::format("the claim is about {}; --separation and --metric ask for {}",
                                separation_for_person(*row.separation), separation_for_person(separation_.separation)));
  }
  return separation_.separation;
}

void ClaimStream::check_one_separation(const Separation& separation, std::uint64_t row, std::uint64_t query,
                                       const Input& input) {
  if (query == 0) file_separation_ = separation;
  if (io::same_question(separation, file_separation_)) return;
  refuse(row,
         fmt::format("the claim is about {}, and the first one about {} is about {}; in a file of proofs, as --proofs "
                     "writes it, the queries of a file have one separation",
                     separation_for_person(separation), io::printable(input.name),
                     separation_for_person(file_separation_)));
}

void ClaimStream::check_file(const io::AnswerRow& row, const Input& input) {
  const std::filesystem::path claimed(*row.file);
  if (claimed.lexically_normal() == std::filesystem::path(input.name).lexically_normal()) return;
  refuse(row.row,
         fmt::format("file is {} where {} comes next; claims must be in the order of the queries, and name the files "
                     "as the command line does",
                     io::in_quotes(*row.file), io::in_quotes(input.name)));
}

}  // namespace touchstone::cli
