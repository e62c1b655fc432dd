// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <memory>

#include "cli/fuzz/found_steps.hpp"
#include "cli/fuzz/fuzz_steps.hpp"
#include "cli/fuzz/fuzzer_options.hpp"
#include "cli/shared/command_line/number_options.hpp"

namespace touchstone::cli {
namespace {

template <class Number>
void add_fraction(CLI::App& subcommand, const std::string& name, Number& value, const std::string& about) {
  add_number(subcommand, name, value, about, "in [0, 1]", [](double x) { return x >= 0 && x <= 1; })->type_name("F");
}

}  // namespace

void add_fuzz_steps(CLI::App& program, Command& command) {
  const auto options = std::make_shared<FuzzStepsOptions>();
  options->search.threads = 0;
  CLI::App* const subcommand = program.add_subcommand(
      "fuzz-steps", "Break a simulator's collision detection: the simplest steps of a mesh on which it is wrong");
  subcommand->add_flag("--bodies", options->bodies,
                       "Steps of whole rigid bodies that turn, in place of steps of a mesh");
  CLI::Option* const program_under_test =
      add_command_option(*subcommand, options->command,
                         "The command line of the program under test, which gets a line of JSON for each step and "
                         "answers with one (default: the library itself)");
  subcommand
      ->add_option("--solver", options->plugin,
                   "The shared library under test in place of a program, with the function touchstone_ask_step of "
                   "touchstone/plugin.h; for steps of a mesh")
      ->type_name("FILE")
      ->check([](const std::string& text) { return text.empty() ? std::string("the file is empty") : std::string(); })
      ->excludes(program_under_test);
  add_limit_option(*subcommand, options->limit,
                   "Seconds that the program or plugin may take for a reply (default: 10); after that it counts as "
                   "hanging. The first reply of a process may take longer: 20 seconds, and 2 when it was started "
                   "again");
  std::vector<CLI::Option*> of_search =
      add_search_options(*subcommand, options->search.seed, options->cases, options->search.seconds, "steps");
  of_search.push_back(subcommand
                          ->add_option("--family", options->search.families,
                                       "Only steps of this family (default: all; may be given more than once)")
                          ->type_name("FAMILY")
                          ->allow_extra_args(false));
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
  add_fraction(*subcommand, "--early", options->search.early_fraction,
               "The greatest part of the step between a reply's time and a later first contact (default: any, but a "
               "free step of less than a thousandth of the way to it is a stall)");
  add_fraction(*subcommand, "--late", options->search.late_fraction,
               "The greatest part of the step by which a first contact may be told late (default: 0)");
  add_finding_options(*subcommand, options->out,
                      "The folder for the shrunk steps, as files that touchstone mesh or touchstone bodies reads",
                      options->search.findings, options->search.threads);
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
      listed("Families:", families_of_steps(false)) + listed("Families of --bodies:", families_of_steps(true)) +
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
