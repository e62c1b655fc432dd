// SPDX-License-Identifier: MIT
#include "cli/shared/proofs/proof_file.hpp"

#include <fmt/format.h>

#include <string_view>
#include <variant>

#include <touchstone/error.hpp>

#include "io/fail.hpp"
#include "io/queries/query_chunks.hpp"
#include "io/sha256.hpp"
#include "proofs/proof_text.hpp"

namespace touchstone::cli {
namespace {

/// The digest of a file's bytes; "-" for a pipe, which can be read only once.
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

std::string section_of(const Input& input, const Separation& separation) {
  std::string text;
  proofs::append_separation(text, separation);
  // Spaces before a word do not count, and a name of spaces alone would be no word.
  const char* const folder = input.name.rfind(' ', 0) == 0 ? "./" : "";
  return text +
         fmt::format("file {} {} {}{}\n", name_of(input.kind), digest_of(input), folder, io::printable(input.name));
}

}  // namespace

void ProvedQueries::add(const Input& input, const io::QueryRecord& record, const Answer& answer,
                        const Separation& separation) {
  if (record.text.empty()) {
    io::fail(input.name, "is a file of doubles, and touchstone-check reads CSV; touchstone convert writes it as CSV");
  }
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
  for (const Input& input : inputs) {
    if (!input.bundled) continue;
    io::fail(input.name,
             "is inside the program, where touchstone-check cannot read it: proofs go with files. The bundled queries "
             "are files in the source, in src/cli/queries");
  }
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
