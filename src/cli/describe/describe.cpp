// SPDX-License-Identifier: MIT
#include "cli/describe/describe.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "cli/describe/tree.hpp"
#include "cli/shared/command_line/output_names.hpp"
#include "io/output_file.hpp"

namespace touchstone::cli {
namespace {

struct DescribeOptions {
  std::string as;
  std::string out = "-";
};

int run_describe(const ProgramFacts& program, const DescribeOptions& options) {
  const std::string text = options.as == "man"    ? man_page(program)
                           : options.as == "bash" ? bash_completion(program)
                                                  : zsh_completion(program);
  io::OutputFile out = options.out == "-" ? io::OutputFile::standard_output() : io::OutputFile(options.out);
  out.write(text);
  out.commit();
  return kAllHold;
}

}  // namespace

void add_describe(CLI::App& program, Command& command) {
  const auto options = std::make_shared<DescribeOptions>();
  CLI::App* const subcommand =
      program.add_subcommand("describe", "Write the man page, or the completion of a shell")->group("");
  subcommand->add_option("--as", options->as, "man, bash or zsh")
      ->required()
      ->check(CLI::IsMember({"man", "bash", "zsh"}));
  subcommand->add_option("--out", options->out, "The file to write (default: standard output)")
      ->type_name("FILE")
      ->check(named_as(Output::text));
  subcommand->callback([options, &command, &program] {
    command = [options, &program] { return run_describe(facts_of(program), *options); };
  });
}

}  // namespace touchstone::cli
