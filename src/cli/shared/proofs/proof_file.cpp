// SPDX-License-Identifier: MIT
#include "cli/shared/proofs/proof_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <variant>

#include <touchstone/error.hpp>

#include "cli/shared/words.hpp"
#include "io/fail.hpp"
#include "io/queries/query_chunks.hpp"
#include "io/separators.hpp"
#include "io/sha256.hpp"
#include "proofs/proof_text.hpp"

namespace touchstone::cli {
namespace {

std::string section_of(const Input& input, const Separation& separation) {
  std::string text;
  proofs::append_separation(text, separation);
  // Spaces before a word do not count, and a name of spaces alone would be no word.
  const char* const folder = input.name.rfind(' ', 0) == 0 ? "./" : "";
  return text +
         fmt::format("file {} {} {}{}\n", name_of(input.kind), digest_of(input), folder, io::printable(input.name));
}

/// Whether the last field of each row of a straight query is what touchstone-check reads as a truth, or no truth.
bool has_plain_truth(std::string_view rows) {
  while (!rows.empty()) {
    std::string_view row = rows.substr(0, rows.find('\n'));
    rows.remove_prefix(std::min(row.size() + 1, rows.size()));
    if (!io::is_row(row)) continue;
    if (row.ends_with('\r')) row.remove_suffix(1);
    const auto fields = io::fields_of(row);
    if (fields.size() == 7 && fields[6] != "0" && fields[6] != "1") return false;
  }
  return true;
}

}  // namespace

std::string digest_of(const Input& input) {
  if (!input.bytes) return "-";
  io::InputFile file = input.open();
  io::Sha256 sum;
  std::string buffer(io::kChunkBytes, '\0');
  for (std::size_t size; (size = file.read(buffer.data(), buffer.size())) > 0;) {
    sum.add(std::string_view(buffer).substr(0, size));
  }
  return sum.digest();
}

void require_file(const Input& input) {
  if (!input.bundled) return;
  io::fail(input.name,
           "is inside the program, where touchstone-check cannot read it: proofs go with files. The bundled queries "
           "are files in the source, in src/cli/queries");
}

void require_plain_rows(const Input& input, const io::QueryChunk& chunk, const io::QueryRecord& record) {
  const bool is_curved = chunk.curved();
  const auto refuse = [&](std::uint64_t row, std::string_view what) {
    const std::string in = input.bytes ? shell_word(input.name) : "IN.csv";
    const std::string text = fmt::format(
        "{}; a proof is about {} with commas alone, as touchstone-check reads them. This writes the same queries "
        "so, exactly: touchstone convert --kind {}{} {} OUT.csv",
        what, is_curved ? "numbers" : "fractions", name_of(input.kind), is_curved ? " --to hexfloat" : "", in);
    row == 0 ? io::fail(input.name, text) : io::fail(input.name, row, text);
  };
  if (chunk.array != nullptr) refuse(0, "is a file of doubles");
  if (chunk.format != io::RowFormat::fractions) refuse(0, "has decimals");
  if (chunk.names_row != 0) refuse(chunk.names_row, "names columns");
  if (chunk.rewritten) refuse(0, "has quotes, separators that are no commas, or a byte order mark");
  if (!is_curved && !has_plain_truth(record.text)) refuse(record.first_row, "a truth is no plain 0 or 1");
}

void ProvedQueries::add(const Input& input, const io::QueryRecord& record, const Answer& answer,
                        const Separation& separation) {
  try {
    std::visit([&](const auto& query) { proofs::append_proof_of(text_, record.number, query, answer, separation); },
               record.query);
  } catch (const Error& error) {
    io::fail(input.name, record.first_row, fmt::format("query {}: {}", record.number, error.what()));
  }
  ++queries_;
  contacts_ += answer.contact;
}

ProofFile::ProofFile(const std::string& path, const std::vector<Input>& inputs)
    : out_(path == "-" ? io::OutputFile::standard_output() : io::OutputFile(path)),
      inputs_(inputs),
      proved_(inputs.size()) {
  std::for_each(inputs.begin(), inputs.end(), require_file);
  out_.write(proofs::kFirstLine);
}

void ProofFile::add(std::size_t input, const Separation& separation, const ProvedQueries& proved) {
  for (; begun_ <= input; ++begun_) out_.write(section_of(inputs_[begun_], separation));
  out_.write(proved.text_);
  proved_[input] += proved.queries_;
  queries_ += proved.queries_;
  contacts_ += proved.contacts_;
}

void ProofFile::finish() {
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    if (proved_[i] == 0) io::fail(inputs_[i].name, "has no query, so there is nothing to prove; leave it out");
  }
  out_.write(fmt::format("end {} {}\n", queries_, contacts_));
  out_.commit();
}

}  // namespace touchstone::cli
