// SPDX-License-Identifier: MIT
#include "cli/prove.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/shared/inputs.hpp"
#include "cli/shared/pipeline.hpp"
#include "cli/shared/query_progress.hpp"
#include "cli/shared/summary.hpp"
#include "cli/shared/words.hpp"
#include "io/fail.hpp"
#include "io/output_file.hpp"
#include "io/query_parser.hpp"
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

struct ProveItem : QueryItem {
  std::string text;
  Counts counts;
};

void prove_queries(ProveItem& item) {
  if (item.chunk.file == nullptr) return;  // reading failed
  io::QueryParser parser(item.chunk);
  io::QueryRecord record;
  while (parser.next(record)) {
    const Answer answer = answer_to(record.query, Method::fast, {});
    const proofs::Proof proof =
        std::visit([&](const auto& query) { return proofs::prove(query, answer); }, record.query);
    proofs::append_proof(item.text, record.number, answer, proof);
    item.counts.add(answer);
  }
}

}  // namespace

int run_prove(const ProveOptions& options) {
  const std::vector<Input> inputs = find_inputs(options.files, options.kind);
  refuse_to_overwrite(options.out, options.files);
  const bool to_standard_output = options.out == "-";
  io::OutputFile out = to_standard_output ? io::OutputFile::standard_output() : io::OutputFile(options.out);
  const int threads = thread_count(options.threads);

  QueryStream stream(inputs, io::kChunkBytes);
  Counts counts;
  QueryProgress progress(inputs);
  out.write(proofs::kFirstLine);
  std::size_t files = 0;  // whose proofs have begun
  const auto begin_files = [&](std::size_t count) {
    for (; files < count; ++files) {
      const Input& input = inputs[files];
      out.write(fmt::format("file {} {} {}\n", kind_name(input.kind), digest_of(input), io::printable(input.name)));
    }
  };
  run_in_order<ProveItem>(
      threads, [&](ProveItem& item) { return stream.next(item); }, [&](ProveItem& item) { prove_queries(item); },
      [&](ProveItem& item) {
        begin_files(item.input + 1);
        out.write(item.text);
        counts.merge(item.counts);
        progress.add(item.chunk.text().size(), item.counts.queries);
      });
  out.write(fmt::format("end {} {}\n", counts.queries, counts.queries - counts.natures[0]));
  out.commit();
  if (to_standard_output) return kAllHold;

  auto console = io::OutputFile::standard_output();
  console.write(fmt::format("{} in {} proved in {}\n", counted(counts.queries, "query"), counted(inputs.size(), "file"),
                            options.out));
  console.write(counts_for_person(counts));
  console.write(speed_for_person(counts.queries, progress.seconds(), threads));
  console.commit();
  return kAllHold;
}

void add_prove(CLI::App& program, Command& command) {
  const auto options = std::make_shared<ProveOptions>();
  CLI::App* const subcommand =
      program.add_subcommand("prove", "Answer the queries of files, with a proof of each answer");
  subcommand->add_option("FILE", options->files, "Query files")->required()->type_name("");
  add_kind_option(*subcommand, options->kind);
  subcommand->add_option("--out", options->out, "The file for the proofs (default: standard output)")
      ->type_name("FILE");
  subcommand->add_option("--threads", options->threads, "The number of threads (default: all that the machine has)")
      ->type_name("N")
      ->check([](const std::string& text) { return check_whole_number(text, 1, 1024); });
  subcommand->footer(
      "A proof has a line for each piece of time in which a plane keeps the elements apart, and for a contact the time "
      "as\n"
      "the root of a polynomial and the weights of the points that meet. The page docs/proofs.md defines the format. "
      "The\n"
      "proofs are in input order; the number of threads changes nothing. The file appears when it is complete. The "
      "program\n"
      "touchstone-check reads the proofs and the query files and checks them:\n\n"
      "  touchstone prove --out proofs.txt edge-edge/a.csv && touchstone-check proofs.txt edge-edge/a.csv\n\n"
      "Exit status: 0 done, 2 bad usage or bad input.");
  subcommand->callback([options, &command] { command = [options] { return run_prove(*options); }; });
}

}  // namespace touchstone::cli
