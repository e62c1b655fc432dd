// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <memory>

#include "cli/fuzz/found_steps.hpp"
#include "cli/fuzz/fuzz_steps.hpp"
#include "cli/shared/command_line/common_options.hpp"
#include "cli/shared/words.hpp"
#include "io/times.hpp"

namespace touchstone::cli {
namespace {

using OptionCheck = std::function<std::string(const std::string&)>;

OptionCheck check_fraction() {
  return check_range("in [0, 1]", [](double x) { return x >= 0 && x <= 1; });
}

std::string family_lines(std::string line, bool bodies) {
  const std::string indent(line.size(), ' ');
  std::string text;
  for (const std::string_view name : families_of_steps(bodies)) {
    if (line.size() + name.size() > 108) text += line + "\n", line = indent;
    line.append(" ").append(name);
  }
  return text + line + "\n";
}

}  // namespace

void add_fuzz_steps(CLI::App& program, Command& command) {
  const auto options = std::make_shared<FuzzStepsOptions>();
  options->search.threads = 0;
  CLI::App* const subcommand = program.add_subcommand(
      "fuzz-steps", "Break a simulator's collision detection: the simplest steps of a mesh on which it is wrong");
  subcommand->add_flag("--bodies", options->bodies,
                       "Steps of whole rigid bodies that turn, in place of steps of a mesh");
  const auto number = [&](const std::string& name, auto& value, const std::string& about, const OptionCheck& check) {
    return subcommand
        ->add_option_function<std::string>(
            name, [&value](const std::string& text) { value = *io::parse_finite_double(text); }, about)
        ->check(check);
  };
  auto* const program_under_test =
      subcommand
          ->add_option(
              "--solver-command", options->command,
              "The command line of the program under test, which gets a line of JSON for each step and answers "
              "with one (default: the library itself)")
          ->type_name("COMMAND")
          ->check([](const std::string& text) {
            const bool blank = text.find_first_not_of(" \t\n") == std::string::npos;
            return blank ? std::string("the command is empty; it must name a program") : std::string();
          });
  subcommand
      ->add_option("--solver", options->plugin,
                   "The shared library under test in place of a program, with the function touchstone_ask_step of "
                   "touchstone/plugin.h; for steps of a mesh")
      ->type_name("FILE")
      ->check([](const std::string& text) { return text.empty() ? std::string("the file is empty") : std::string(); })
      ->excludes(program_under_test);
  number("--limit", options->limit,
         "Seconds that the program or plugin may take for a reply (default: 10); after that it counts as hanging. The "
         "first "
         "reply of a process may take longer: 20 seconds, and 2 when it was started again",
         check_range("a number of seconds from 0.001 to 3600", [](double x) { return x >= 0.001 && x <= 3600; }))
      ->type_name("S");
  std::vector<CLI::Option*> of_search;
  of_search.push_back(subcommand
                          ->add_option("--family", options->search.families,
                                       "Only steps of this family (default: all; may be given more than once)")
                          ->type_name("FAMILY")
                          ->allow_extra_args(false));
  of_search.push_back(subcommand->add_option("--seed", options->search.seed, "The seed of the steps (default: 1)")
                          ->type_name("N")
                          ->check([](const std::string& text) { return check_whole_number(text); }));
  of_search.push_back(subcommand
                          ->add_option("--cases", options->cases,
                                       "The number of steps, in place of --seconds; the outcome does not depend on the "
                                       "number of threads")
                          ->type_name("N")
                          ->check([](const std::string& text) { return check_whole_number(text, 1); }));
  of_search.push_back(number("--seconds", options->search.seconds,
                             "The length of the search; shrinking may take as long again (default: 10, unless --cases "
                             "is given)",
                             check_range("a number of seconds above 0", [](double x) { return x > 0 && x <= 1e9; }))
                          ->type_name("S"));
  auto* const a_case =
      subcommand
          ->add_option("--case", options->a_case, "Only this step, with its name from a finding: \"FAMILY SEED INDEX\"")
          ->type_name("CASE")
          ->check(
              [](const std::string& text) { return text.empty() ? std::string("the case is empty") : std::string(); });
  for (CLI::Option* const option : of_search) a_case->excludes(option);
  subcommand->add_flag_callback(
      "--no-separation", [options] { options->search.separations = false; },
      "Ask about touching alone, for a program that knows no separation; bodies have no radii either");
  subcommand->add_flag_callback(
      "--no-groups", [options] { options->search.groups = false; },
      "No groups of vertices that do not collide, and no such pairs of bodies, for a program that knows none");
  subcommand->add_flag("--may-end-in-contact", options->search.may_end_in_contact,
                       "A free step may end in its first contact (default: it must end before)");
  subcommand->add_flag_callback(
      "--once", [options] { options->search.twice = false; }, "Do not ask twice whether the program says the same");
  number("--early", options->search.early_fraction,
         "The greatest part of the step between a reply's time and a later first contact (default: any, but a free "
         "step of less than a thousandth of the way to it is a stall)",
         check_fraction())
      ->type_name("F");
  number("--late", options->search.late_fraction,
         "The greatest part of the step by which a first contact may be told late (default: 0)", check_fraction())
      ->type_name("F");
  subcommand
      ->add_option("--out", options->out,
                   "The folder for the shrunk steps, as files that touchstone mesh or touchstone bodies reads; it is "
                   "made when it is missing")
      ->type_name("FOLDER");
  subcommand
      ->add_option("--findings", options->search.findings, "The most findings to shrink and show; 0: all (default: 32)")
      ->type_name("N")
      ->check([](const std::string& text) { return check_whole_number(text, 0); });
  subcommand
      ->add_option("--threads", options->search.threads, "The number of threads (default: all that the machine has)")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  subcommand->footer(
      "Makes seeded steps of small meshes or bodies that are hard, asks the program, and judges its replies by the "
      "exact answers\n"
      "to all pairs of elements:\n"
      "  free           missed, late: the step goes on to a contact   early: a stall, or farther before it than "
      "--early\n"
      "  first contact  missed, late, early, phantom                 candidates  missed: a pair in contact is not "
      "there\n"
      "  all            crash, hang, malformed; differs: asked again, it says something else\n"
      "Failures of one class and one question are one finding. Its simplest step is shrunk: fewest elements "
      "first.\n\n" +
      family_lines("Families:", false) + family_lines("Families of --bodies:", true) +
      "\nExamples\n"
      "  touchstone fuzz-steps --solver-command \"python3 theirs.py\" --out broken     see share/touchstone/examples\n"
      "  touchstone fuzz-steps --solver ./theirs.so                                  a plugin: touchstone/plugin.h\n"
      "  touchstone fuzz-steps --solver-command ./theirs --case \"steps_stack 1 17\"\n"
      "  touchstone fuzz-steps --bodies --solver-command \"python3 theirs.py\" --no-separation\n"
      "  touchstone fuzz-steps --cases 100000                                        the library itself\n\n"
      "Exit status: 0 no failure, 1 some failure, 2 bad usage or a file that cannot be written.");
  subcommand->callback([options, &command] { command = [options] { return run_fuzz_steps(*options); }; });
}

}  // namespace touchstone::cli
