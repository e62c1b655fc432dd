// SPDX-License-Identifier: MIT
#include "cli/prove.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <variant>

#include <touchstone/error.hpp>

#include "cli/shared/command_line/common_options.hpp"
#include "cli/shared/command_line/output_names.hpp"
#include "cli/shared/command_line/turns.hpp"
#include "cli/shared/found_query.hpp"
#include "cli/shared/inputs.hpp"
#include "cli/shared/progress/pipeline.hpp"
#include "cli/shared/progress/query_progress.hpp"
#include "cli/shared/progress/summary.hpp"
#include "cli/shared/proofs/proof_file.hpp"
#include "cli/shared/words.hpp"
#include "io/fail.hpp"
#include "io/output_file.hpp"
#include "io/queries/query_parser.hpp"
#include "proofs/theorem.hpp"

namespace touchstone::cli {
namespace {

struct ProveItem : QueryItem {
  ProvedQueries proved;
  Counts counts;
};

void prove_queries(ProveItem& item, const std::vector<Input>& inputs, const ProveOptions& options) {
  if (item.chunk.file == nullptr) return;  // reading failed
  const Separation& separation = options.separation.separation;
  io::QueryParser parser(item.chunk);
  io::QueryRecord record;
  while (parser.next(record)) {
    item.longer_turns.merge(record.longer_turns);
    require_plain_rows(inputs[item.input], item.chunk, record);
    const Answer answer = answer_to(record.query, options.method, separation);
    item.proved.add(inputs[item.input], record, answer, separation);
    item.counts.add(answer);
  }
}

std::string shorter_turns() {
  return std::string("a proof is about the file's own queries: ") + kConvertForShorterTurns;
}

/// Writes the theorem about one query.
int write_theorem(const ProveOptions& options, const std::vector<Input>& inputs, std::uint64_t number) {
  if (inputs.size() != 1) throw Error("--theorem: a theorem is about one query: name one file");
  const Input& input = inputs[0];
  require_file(input);
  const Separation& separation = options.separation.separation;
  const std::string digest = digest_of(input);  // of the file before it is read
  const auto found = find_query(input, number, io::Turns::as_given, shorter_turns());
  const io::QueryRecord& record = found->record;
  require_plain_rows(input, found->chunk, record);
  const proofs::TheoremTitle title{
      fmt::format("query_{}", number),
      heading(input, record) + (input.bytes ? "; SHA-256 of the file " + digest : "; read from a pipe")};
  std::string text;
  try {
    const Answer answer = answer_to(record.query, options.method, separation);
    text = std::visit([&](const auto& query) { return proofs::theorem_of(title, query, answer, separation); },
                      record.query);
  } catch (const Error& error) {
    io::fail(input.name, record.first_row, fmt::format("query {}: {}", number, error.what()));
  }
  auto out = options.out == "-" ? io::OutputFile::standard_output() : io::OutputFile(options.out);
  out.write(text);
  out.commit();
  if (options.out == "-") return kAllHold;
  auto console = io::OutputFile::standard_output();
  console.write(fmt::format("{}: a theorem in {}\n", heading(input, record), io::printable(options.out)));
  console.commit();
  return kAllHold;
}

}  // namespace

int run_prove(const ProveOptions& options) {
  const std::vector<Input> inputs = find_inputs(options.files, options.kind);
  refuse_to_overwrite(options.out, options.files);
  const std::string fault = options.theorem
                                ? fault_of_module_name(options.out, fmt::format("query_{}.v", *options.theorem))
                                : fault_of_name(options.out, Output::text);
  if (!fault.empty()) throw Error("--out: " + fault);
  if (options.theorem) return write_theorem(options, inputs, *options.theorem);
  ProofFile out(options.out, inputs);

  QueryStream stream(inputs, options.chunk_bytes, io::Motions::any);
  Counts counts;
  TurnNotes turns(inputs, io::Turns::as_given, shorter_turns());
  QueryProgress progress(inputs);
  const int threads = run_in_order<ProveItem>(
      thread_count(options.threads), [&](ProveItem& item) { return stream.next(item); },
      [&](ProveItem& item) { prove_queries(item, inputs, options); },
      [&](ProveItem& item) {
        out.add(item.input, options.separation.separation, item.proved);
        counts.merge(item.counts);
        turns.add(item.input, item.longer_turns);
        progress.add(item.chunk.size(), item.counts.queries);
      });
  out.finish();
  progress.wipe();
  turns.tell();
  if (options.out == "-") return kAllHold;

  auto console = io::OutputFile::standard_output();
  const std::string about =
      options.separation.given ? " (" + separation_for_person(options.separation.separation) + ")" : std::string();
  console.write(fmt::format("{} in {} proved in {}{}\n", counted(counts.queries, "query"),
                            counted(inputs.size(), "file"), io::printable(options.out), about));
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
  add_separation_options(*subcommand, options->separation, "The distance at which two elements are in contact");
  subcommand->add_option("--out", options->out, "The file for the proofs (default: standard output)")
      ->type_name("FILE");
  subcommand
      ->add_option("--theorem", options->theorem,
                   "Write a theorem of Coq about this query of the file, counted from 0, in place of the proofs")
      ->type_name("N")
      ->check(check_query_number);
  add_threads_option(*subcommand, options->threads);
  subcommand->footer(
      "A proof has a line for each piece of time in which a plane keeps the elements apart, and for a contact the "
      "time\n"
      "as the root of a polynomial and the weights of the points that meet, or come as near as the separation. The\n"
      "page docs/proofs.md defines the format. The proofs are in input order; the number of threads changes nothing.\n"
      "The file appears when it is complete. The program touchstone-check reads the proofs and the query files and\n"
      "checks them:\n\n"
      "  touchstone prove --out proofs.txt edge-edge/a.csv && touchstone-check proofs.txt edge-edge/a.csv\n\n"
      "With --theorem N the file is for Coq's program coqc. Its last lines are a theorem about query N that a person "
      "can\n"
      "read. The page docs/proved.md says how it is checked:\n\n"
      "  touchstone prove --theorem 3 --out query_3.v edge-edge/a.csv\n\n"
      "Exit status: 0 done, 2 bad usage or bad input; a file without a query has nothing to prove, and is bad input.");
  subcommand->callback([options, &command] { command = [options] { return run_prove(*options); }; });
}

}  // namespace touchstone::cli
