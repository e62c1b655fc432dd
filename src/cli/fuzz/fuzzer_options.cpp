// SPDX-License-Identifier: MIT
#include "cli/fuzz/fuzzer_options.hpp"

#include "cli/shared/command_line/number_options.hpp"

namespace touchstone::cli {

CLI::Option* add_command_option(CLI::App& subcommand, std::string& command, const std::string& about) {
  return subcommand.add_option("--solver-command", command, about)
      ->type_name("COMMAND")
      ->check([](const std::string& text) {
        const bool blank = text.find_first_not_of(" \t\n") == std::string::npos;
        return blank ? std::string("the command is empty; it must name a program") : std::string();
      });
}

void add_limit_option(CLI::App& subcommand, double& seconds, const std::string& about) {
  add_number(subcommand, "--limit", seconds, about, "a number of seconds from 0.001 to 3600", [](double x) {
    return x >= 0.001 && x <= 3600;
  })->type_name("S");
}

std::vector<CLI::Option*> add_search_options(CLI::App& subcommand, std::uint64_t& seed,
                                             std::optional<std::uint64_t>& cases, std::optional<double>& seconds,
                                             const std::string& things) {
  CLI::Option* const of_seed =
      add_whole_number(subcommand, "--seed", seed, "The seed of the " + things + " (default: 1)");
  CLI::Option* const of_cases = add_whole_number(subcommand, "--cases", cases,
                                                 "The number of " + things +
                                                     " to start from; without --seconds the outcome does not depend "
                                                     "on the number of threads",
                                                 1);
  CLI::Option* const of_seconds =
      add_number(subcommand, "--seconds", seconds,
                 "The length of the search; shrinking may take as long again (default: 10, unless --cases is given)",
                 "a number of seconds above 0", [](double x) { return x > 0 && x <= 1e9; })
          ->type_name("S");
  return {of_seed, of_cases, of_seconds};
}

void add_finding_options(CLI::App& subcommand, std::string& out, const std::string& about_out, std::size_t& findings,
                         int& threads) {
  subcommand.add_option("--out", out, about_out + "; it is made when it is missing")->type_name("FOLDER");
  add_whole_number(subcommand, "--findings", findings, "The most findings to shrink and show; 0: all (default: 32)");
  add_threads_option(subcommand, threads);
}

std::string listed(std::string line, const std::vector<std::string_view>& names) {
  const std::string indent(line.size(), ' ');
  std::string text;
  for (const std::string_view name : names) {
    if (line.size() + name.size() > 108) {
      text += line + "\n";
      line = indent;
    }
    line.append(" ").append(name);
  }
  return text + line + "\n";
}

}  // namespace touchstone::cli
