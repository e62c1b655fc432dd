// SPDX-License-Identifier: MIT
#include "cli/merge.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <utility>

#include "cli/shared/command_line/common_options.hpp"
#include "cli/shared/command_line/output_names.hpp"
#include "cli/shared/mesh_results.hpp"
#include "cli/shared/whole_file.hpp"
#include "io/output_file.hpp"
#include "sequence/merge.hpp"
#include "sequence/pairs_table.hpp"
#include "sequence/report_json.hpp"

namespace touchstone::cli {

int run_merge(const MergeOptions& options) {
  refuse_to_overwrite(options.out, options.reports);
  refuse_to_overwrite(options.pairs, options.reports);
  if (options.pairs == "-") throw Error("--pairs: name a file to write");
  if (options.pairs == options.out) throw Error("--out and --pairs name the same file");
  std::vector<sequence::ShardReport> shards;
  for (const auto& file : options.reports) {
    const std::string text = whole_file(file);
    shards.push_back({file, naming_file(file, [&] { return sequence::report_from(text); })});
  }
  const sequence::Report report = sequence::merged(std::move(shards));

  const bool to_standard_output = options.out == "-";
  io::OutputFile out = to_standard_output ? io::OutputFile::standard_output() : io::OutputFile(options.out);
  std::optional<io::OutputFile> pairs;
  if (!options.pairs.empty()) pairs.emplace(options.pairs).write(sequence::pairs_table(report, options.numbers));
  out.write(sequence::report_text(report));
  if (pairs) pairs->commit();
  out.commit();
  const sequence::ResultCounts counts = sequence::counts_of(report);
  if (!to_standard_output) {
    auto console = io::OutputFile::standard_output();
    console.write(counts_for_person(report.heading, report.frames, counts));
    console.commit();
  }
  return counts.all_free() ? kAllHold : kRefuted;
}

void add_merge(CLI::App& program, Command& command) {
  const auto options = std::make_shared<MergeOptions>();
  CLI::App* const subcommand =
      program.add_subcommand("merge", "Put the reports of all parts of a sequence together (see mesh --shard)");
  subcommand->add_option("REPORT", options->reports, "The reports of all parts, in any order")
      ->required()
      ->type_name("");
  subcommand->add_option("--out", options->out, "The report of the whole sequence; - writes it to standard output")
      ->required()
      ->type_name("FILE")
      ->check(named_as(Output::json));
  subcommand->add_option("--pairs", options->pairs, "Write a table (CSV) with a row for each pair in contact")
      ->type_name("FILE")
      ->check(named_as(Output::csv));
  add_numbers_option(*subcommand, options->numbers);
  subcommand->get_option("--numbers")->needs("--pairs");
  subcommand->footer(
      "The result is that of one run without --shard, byte for byte. Each report must be undamaged and of the same "
      "run:\n"
      "the same options, names and mesh. Each part must be there once, and neighbouring parts must have read the same\n"
      "frame where they meet.\n\n"
      "Exit status: 0 every step is free and the first frame does not intersect itself, 1 otherwise, 2 bad usage or\n"
      "reports that do not fit together.");
  subcommand->callback([options, &command] { command = [options] { return run_merge(*options); }; });
}

}  // namespace touchstone::cli
