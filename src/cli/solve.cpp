// SPDX-License-Identifier: MIT
#include "cli/solve.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <memory>

#include <touchstone/error.hpp>

#include "cli/shared/command_line/output_names.hpp"
#include "cli/shared/command_line/turns.hpp"
#include "cli/shared/inputs.hpp"
#include "cli/shared/progress/pipeline.hpp"
#include "cli/shared/progress/query_progress.hpp"
#include "cli/shared/progress/summary.hpp"
#include "cli/shared/words.hpp"
#include "io/fail.hpp"
#include "io/output_file.hpp"
#include "io/queries/query_parser.hpp"

namespace touchstone::cli {
namespace {

struct SolveItem : QueryItem {
  std::string rows;  ///< of answers.csv, or lines of JSON
  Counts counts;
};

void solve_queries(SolveItem& item, const std::vector<Input>& inputs, const SolveCommandOptions& options) {
  if (item.chunk.file == nullptr) return;  // reading failed
  const std::string& name = inputs[item.input].name;
  const std::string file = options.json ? io::json_string(name) : io::csv_field(name);
  io::QueryParser parser(item.chunk, options.turns);
  io::QueryRecord record;
  while (parser.next(record)) {
    item.longer_turns.merge(record.longer_turns);
    const Separation& separation = options.separation.separation;
    const Answer answer = answer_to(record.query, options.method, separation);
    if (options.json) {
      io::append_answer_line(item.rows, file, record.number, answer, options.separation.given ? &separation : nullptr);
    } else if (options.separation.given) {
      io::append_answer(item.rows, file, record.number, answer, separation, options.numbers);
    } else {
      io::append_answer(item.rows, file, record.number, answer, options.numbers);
    }
    item.counts.add(answer);
    item.counts.no_doubles += record.no_doubles;
  }
}

}  // namespace

int run_solve(const SolveCommandOptions& options) {
  const std::vector<Input> inputs = find_inputs(options.files, options.kind, options.decimals);
  refuse_to_overwrite(options.out, options.files);
  const std::string fault =
      options.json ? fault_of_name(options.out, Output::json_lines) : fault_of_name(options.out, Output::csv);
  if (!fault.empty()) throw Error("--out: " + fault + (options.json ? "" : "; --json writes lines of JSON"));
  const bool to_standard_output = options.out == "-";
  io::OutputFile out = to_standard_output ? io::OutputFile::standard_output() : io::OutputFile(options.out);

  QueryStream stream(inputs, options.chunk_bytes, io::Motions::any);
  Counts counts;
  TurnNotes turns(inputs, options.turns);
  QueryProgress progress(inputs);
  if (!options.json) out.write(options.separation.given ? io::kSeparationAnswerHeader : io::kAnswerHeader);
  const int threads = run_in_order<SolveItem>(
      thread_count(options.threads), [&](SolveItem& item) { return stream.next(item); },
      [&](SolveItem& item) { solve_queries(item, inputs, options); },
      [&](SolveItem& item) {
        out.write(item.rows);
        counts.merge(item.counts);
        turns.add(item.input, item.longer_turns);
        progress.add(item.chunk.size(), item.counts.queries);
      });
  out.commit();
  progress.wipe();
  turns.tell();
  if (to_standard_output) {
    if (counts.no_doubles > 0) print_error("touchstone: " + decimals_for_person(counts.no_doubles) + "\n");
    return kAllHold;
  }

  auto console = io::OutputFile::standard_output();
  const std::string about =
      options.separation.given ? " (" + separation_for_person(options.separation.separation) + ")" : std::string();
  console.write(fmt::format("{} in {} answered in {}{}\n", counted(counts.queries, "query"),
                            counted(inputs.size(), "file"), io::printable(options.out), about));
  console.write(counts_for_person(counts));
  console.write(speed_for_person(counts.queries, progress.seconds(), threads));
  console.commit();
  return kAllHold;
}

void add_solve(CLI::App& program, Command& command) {
  const auto options = std::make_shared<SolveCommandOptions>();
  CLI::App* const subcommand = program.add_subcommand("solve", "Answer the queries of files, exactly");
  subcommand->add_option("FILE", options->files, "Query files")->required()->type_name("");
  add_query_options(*subcommand, *options);
  add_separation_options(*subcommand, options->separation, "The distance at which two elements are in contact");
  subcommand
      ->add_option("--out", options->out,
                   "The file for the answers (default: standard output). It appears when all answers are complete; "
                   "after an error there is none")
      ->type_name("FILE");
  add_numbers_option(*subcommand, options->numbers);
  subcommand->add_flag("--json", options->json, "Write a JSON object a line, with decimals, in place of CSV")
      ->excludes("--numbers");
  subcommand->footer(
      "The answers are CSV with the columns file,query,contact,toi,toi_upper,nature,feature_a,feature_b,level. Each\n"
      "query has a row, in input order; the number of threads changes nothing. toi and toi_upper are the neighbouring\n"
      "doubles around the exact first time of contact. They are equal when the time is a double, and\n"
      "empty without contact.\n\n"
      "With --separation D a contact is a distance of at most D, and the columns "
      "starts_within,trend,separation,metric\n"
      "follow. starts_within is 1 when the elements are within D at t = 0 already. trend is what the distance does "
      "just\n"
      "after the time of contact: approaching, constant or leaving. The last two repeat the question in each row, and\n"
      "certify reads them.");
  subcommand->callback([options, &command] { command = [options] { return run_solve(*options); }; });
}

}  // namespace touchstone::cli
