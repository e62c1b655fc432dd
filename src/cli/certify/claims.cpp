// SPDX-License-Identifier: MIT
#include "cli/certify/claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include <touchstone/error.hpp>

#include "cli/shared/progress/interrupt.hpp"
#include "cli/shared/words.hpp"
#include "io/fail.hpp"
#include "io/queries/separation_text.hpp"

namespace touchstone::cli {
namespace {

std::string path_of(const std::string& name) { return std::filesystem::path(name).lexically_normal().string(); }

}  // namespace

void Questions::add(const Separation& separation) {
  if (!first_) first_ = separation;
  several_ = several_ || !io::same_question(*first_, separation);
}

void Questions::merge(const Questions& other) {
  if (other.first_) add(*other.first_);
  several_ = several_ || other.several_;
}

ClaimStream::ClaimStream(const std::string& path, const io::ClaimColumns& columns, io::Decimals decimals,
                         const std::vector<Input>& inputs, const SeparationOption& separation,
                         SeparationsOfFile separations_of_file, io::MissingClaim missing, std::size_t chunk_bytes)
    : name_(without_dash(path)),
      decimals_(decimals),
      inputs_(inputs),
      separation_(separation),
      separations_of_file_(separations_of_file),
      missing_(missing),
      queries_(inputs.size()) {
  for (const Input& input : inputs) paths_.push_back(path_of(input.name));
  io::InputFile file = io::InputFile::open(name_, throw_if_interrupted);
  if (is_list_of_claims(file)) {
    listed_ = read_listed_claims(std::move(file), columns, missing);
    implied_contacts_ = listed_.implied_contacts;
  } else {
    reader_.emplace(std::move(file), columns, chunk_bytes, missing);
    has_numbers_ = reader_->has_query_column();
    implied_contacts_ = !reader_->has_contact_column();
  }
}

std::string ClaimStream::left_out() const {
  const std::vector<std::string>& unread = reader_ ? reader_->unread_columns() : listed_.unread;
  std::string text;
  if (implied_contacts_) text = "claims without 'contact' have one unless 'toi' denies it";
  if (times_ < contacts_) {
    text +=
        std::string(text.empty() ? "" : ", ") +
        (times_ == 0 ? "no times" : fmt::format("times for {} of {}", grouped(times_), counted(contacts_, "contact")));
  }
  if (without_claim_ > 0) {
    text += std::string(text.empty() ? "" : ", ") + "no contact at " + counted(without_claim_, "query") +
            " without a claim";
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
  for (std::size_t i = 0; i < item.chunk.query_count; ++i) {
    const Subject subject(item.input, item.chunk.first_query + i);
    ReadClaim claim = claim_about(subject);
    ++queries_[subject.first];
    if (separations_of_file_ == SeparationsOfFile::one) check_one_separation(claim, subject);
    claims.push_back(std::move(claim.stated));
  }
}

ClaimStream::ReadClaim ClaimStream::claim_about(Subject subject) {
  if (auto held = held_.extract(subject)) return std::move(held.mapped());
  io::AnswerRow row;
  while (next(row)) {
    const Subject of = subject_of(row, subject);
    ReadClaim claim = count(row);
    if (of == subject) return claim;
    refuse_second(row.row, of);
    held_.emplace(of, std::move(claim));
  }
  return missing_claim(subject);
}

ClaimStream::ReadClaim ClaimStream::missing_claim(Subject subject) {
  const auto refuse_missing = [&](const std::string& more) {
    refuse(reader_ ? reader_->last_row() : 0,
           fmt::format("the claims end here, after {}; {} has none{}", grouped(claims_), name_of_query(subject), more));
  };
  if (!has_numbers_) {
    refuse_missing(missing_ == io::MissingClaim::refused ? ""
                                                         : ", and --missing is for claims that number their queries");
  }
  if (missing_ == io::MissingClaim::refused) {
    refuse_unheld(subject.first);
    refuse_missing(
        "; queries are counted from 0, and with --missing no-contact those without a claim are claimed to have none");
  }
  const auto separation = separation_.given ? separation_.separation : questions_.only();
  if (!separation) refuse_missing(", and those of others are about several separations; --separation says which");
  ++without_claim_;
  return {{Claim(), *separation}, 0};
}

/// The claim of a row, which is counted.
ClaimStream::ReadClaim ClaimStream::count(const io::AnswerRow& row) {
  const Separation separation = separation_of(row);
  questions_.add(separation);
  ++claims_;
  contacts_ += row.contact ? 1 : 0;
  times_ += row.toi ? 1 : 0;
  const std::string_view written = decimals_ == io::Decimals::nearest_double ? std::string_view() : row.toi_as_written;
  return {{{row.contact, row.toi, std::string(written)}, separation}, row.row};
}

/// @param expected  the query whose claim is looked for: that of a row without a number
ClaimStream::Subject ClaimStream::subject_of(const io::AnswerRow& row, Subject expected) {
  const Subject subject(file_of(row, expected.first), row.query.value_or(expected.second));
  has_numbers_ = has_numbers_ || row.query.has_value();
  if (!row.file && row.query && inputs_.size() > 1 && subject != expected) {
    refuse(row.row, fmt::format("query is {} where {} comes next; claims about several query files have another order "
                                "than the queries only if a column 'file' names the file of each",
                                *row.query, name_of_query(expected)));
  }
  return subject;
}

void ClaimStream::refuse_second(std::uint64_t row, Subject subject) const {
  const auto held = held_.find(subject);
  if (held == held_.end() && subject.second >= queries_[subject.first]) return;
  const std::uint64_t first = held == held_.end() ? 0 : held->second.row;
  refuse(row, fmt::format("the second claim about {}{}", name_of_query(subject),
                          first == 0 ? std::string() : fmt::format("; the first one is in row {}", first)));
}

void ClaimStream::refuse_number(std::uint64_t row, Subject subject, std::uint64_t queries) const {
  refuse(row, fmt::format("query is {}, and {} has {}, counted from 0", subject.second,
                          io::printable(inputs_[subject.first].name), counted(queries, "query")));
}

/// Where a claim is missing, the number of another one may be wrong: the greatest of those about the same file.
void ClaimStream::refuse_unheld(std::size_t file) const {
  auto last = held_.lower_bound({file + 1, 0});
  if (last == held_.begin() || (--last)->first.first != file || !inputs_[file].bytes) return;
  std::uint64_t queries = 0;
  try {
    const std::vector<Input> one = {inputs_[file]};
    QueryStream stream(one, io::kChunkBytes, io::Motions::any);
    for (QueryItem item; stream.next(item); throw_if_interrupted()) queries += item.chunk.query_count;
  } catch (const FileError&) {
    return;  // the queries' own error comes later
  }
  if (last->first.second >= queries) refuse_number(last->second.row, last->first, queries);
}

void ClaimStream::finish() {
  io::AnswerRow row;
  if (!held_.empty()) {
    const Subject first = held_.begin()->first;
    refuse_number(held_.begin()->second.row, first, queries_[first.first]);
  }
  if (!next(row)) return;
  std::uint64_t queries = 0;
  for (const std::uint64_t of_file : queries_) queries += of_file;
  if (row.query && (row.file || inputs_.size() == 1)) {
    const Subject subject = subject_of(row, {inputs_.size() - 1, *row.query});
    refuse_second(row.row, subject);
    refuse_number(row.row, subject, queries_[subject.first]);
  }
  refuse(row.row, fmt::format("a claim too many; there are only {} in the query files", counted(queries, "query")));
}

bool ClaimStream::next(io::AnswerRow& row) {
  if (reader_) return reader_->next(row);
  if (claims_ == listed_.claims.size()) return false;
  const ListedClaim& claim = listed_.claims[claims_];
  row.row = claims_ + 1;
  if (claim.file) row.file = *claim.file;
  row.separation = claim.separation;
  row.query = claim.query;
  row.contact = claim.contact;
  row.toi = claim.toi;
  return true;
}

void ClaimStream::refuse(std::uint64_t row, const std::string& reason) const {
  if (reader_) io::fail(name_, row, reason);
  io::fail(name_, row == 0 ? reason : fmt::format("claim {} of {}: {}", row, listed_.claims.size(), reason));
}

std::string ClaimStream::name_of_query(Subject subject) const {
  return fmt::format("query {} of {}", subject.second, io::printable(inputs_[subject.first].name));
}

Separation ClaimStream::separation_of(const io::AnswerRow& row) const {
  if (!separation_.given) return row.separation.value_or(Separation());
  if (row.separation && !io::same_question(*row.separation, separation_.separation)) {
    refuse(row.row, fmt::format("the claim is about {}; --separation and --metric ask for {}",
                                separation_for_person(*row.separation), separation_for_person(separation_.separation)));
  }
  return separation_.separation;
}

void ClaimStream::check_one_separation(const ReadClaim& claim, Subject subject) {
  const Separation& separation = claim.stated.separation;
  if (subject.second == 0) file_separation_ = separation;
  if (io::same_question(separation, file_separation_)) return;
  refuse(claim.row,
         fmt::format("the claim is about {}, and the first one about {} is about {}; in a file of proofs, as --proofs "
                     "writes it, the queries of a file have one separation",
                     separation_for_person(separation), io::printable(inputs_[subject.first].name),
                     separation_for_person(file_separation_)));
}

/// A file that is none of the query files. A claim may name it by another path.
void ClaimStream::refuse_file(std::uint64_t row, std::string_view file) const {
  constexpr std::size_t kMost = 3;
  const std::string text = fmt::format(
      "file is {}, which is none of the query files; claims name them as the command "
      "line does: ",
      io::in_quotes(file));
  const auto quoted = [&](std::size_t i) { return fmt::format("'{}'", io::printable(inputs_[i].name)); };
  const auto file_name = [](std::string_view path) { return std::filesystem::path(path).filename(); };
  std::string names;
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    if (file_name(inputs_[i].name) == file_name(file)) refuse(row, text + quoted(i));
    if (i < kMost) names += (i == 0 ? std::string() : ", ") + quoted(i);
  }
  if (inputs_.size() > kMost) names += fmt::format(" and {} more", inputs_.size() - kMost);
  refuse(row, text + names);
}

/// The file that a row names; without a name the expected one.
std::size_t ClaimStream::file_of(const io::AnswerRow& row, std::size_t expected) {
  if (!row.file) return expected;
  if (known_file_ != *row.file) {
    known_file_ = *row.file;
    known_path_ = path_of(known_file_);
  }
  if (known_path_ == paths_[expected]) return expected;  // a file may be named twice
  const auto found = std::find(paths_.begin(), paths_.end(), known_path_);
  if (found == paths_.end()) refuse_file(row.row, *row.file);
  if (!row.query) {
    refuse(row.row, fmt::format("file is {} where a claim about {} comes next; without a column 'query' the claims are "
                                "in the order of the queries on the command line",
                                io::in_quotes(*row.file), name_of_query({expected, queries_[expected]})));
  }
  return static_cast<std::size_t>(found - paths_.begin());
}

}  // namespace touchstone::cli
