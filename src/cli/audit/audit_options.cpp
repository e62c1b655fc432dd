// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <memory>

#include "cli/audit/audit.hpp"
#include "cli/shared/command_line/kind_check.hpp"
#include "cli/shared/command_line/number_options.hpp"
#include "cli/shared/command_line/output_names.hpp"
#include "cli/shared/words.hpp"
#include "families/families.hpp"
#include "geometry/kind_aliases.hpp"
#include "io/queries/kind_of_file.hpp"

namespace touchstone::cli {

void add_audit(CLI::App& program, Command& command) {
  const auto options = std::make_shared<AuditOptions>();
  options->settings.threads = 0;
  options->settings.most_findings = 4;
  CLI::App* const subcommand =
      program.add_subcommand("audit", "Ask the collision engines that people use, and judge their answers");
  subcommand
      ->add_option("engines", options->engines,
                   "The engines to ask, such as fcl, or questions of them, such as fcl/linear (default: all)")
      ->type_name("ENGINE");
  subcommand->add_option("--out", options->out, "The folder for the table and the shrunk failures")
      ->type_name("FOLDER")
      ->required();
  subcommand->add_option("--html", options->html, "A page with the table and a moving picture of each finding")
      ->type_name("PAGE.html")
      ->check(named_as(Output::page));
  subcommand
      ->add_option("--engine", options->commands,
                   "One more engine, whose program describes itself; without other names it alone is asked")
      ->type_name("NAME=COMMAND")
      ->allow_extra_args(false);
  CLI::Option* const cases = add_whole_number(*subcommand, "--cases", options->cases,
                                              "The number of cases of each question and kind (default: 100000)", 1);
  subcommand
      ->add_option_function<std::vector<std::string>>(
          "--kind",
          [options](const std::vector<std::string>& names) {
            for (const auto& name : names) options->settings.kinds.push_back(*geometry::kind_named(name));
          },
          "Only queries of this kind: " + io::kind_names() + " (default: all; may be given more than once)")
      ->type_name("KIND")
      ->check(kind_check())
      ->allow_extra_args(false);
  subcommand
      ->add_option_function<std::vector<std::string>>(
          "--family",
          [options](const std::vector<std::string>& names) {
            for (const auto& name : names) options->settings.families.push_back(families::find_family(name)->family);
          },
          "Only queries of this family; touchstone fuzz --help lists them (default: all)")
      ->type_name("FAMILY")
      ->check([](const std::string& name) {
        const auto* const family = families::find_family(name);
        const bool straight = family != nullptr && !families::is_curved(family->family);
        return straight ? std::string() : name + " is no family of straight queries; see touchstone fuzz --help";
      })
      ->allow_extra_args(false);
  subcommand
      ->add_option("--from", options->from, "Ask the queries of these files instead of families, as audit wrote them")
      ->type_name("FILE")
      ->excludes(cases)
      ->allow_extra_args(false);
  add_whole_number(*subcommand, "--seed", options->settings.seed, "The seed of the queries (default: 1)");
  add_whole_number(*subcommand, "--findings", options->settings.most_findings,
                   "The most findings to shrink and show of each question and kind; 0: all (default: 4)");
  add_threads_option(*subcommand, options->settings.threads);
  subcommand->footer(
      "Each engine describes the questions that it answers: the kinds, the motions, the sizes and its own tolerance. "
      "It\n"
      "is asked nothing else. The queries are those of touchstone fuzz, each changed to the nearest that is claimed.\n"
      "An answer that is right for a query within the tolerance is tolerated, and counted apart.\n\n"
      "Examples\n"
      "  touchstone audit --out audit --html audit.html\n"
      "  touchstone audit --out audit fcl bullet/cast --cases 10000\n"
      "  touchstone audit --out audit --engine \"mine=python3 mine.py\"     docs/audit.md says what it must print\n\n"
      "Exit status: 0 no failure, 1 some failure, 2 bad usage or a file that cannot be written.");
  subcommand->callback([options, &command] { command = [options] { return run_audit(*options); }; });
}

}  // namespace touchstone::cli
