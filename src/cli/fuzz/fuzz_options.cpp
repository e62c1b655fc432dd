// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "baselines/curved_baseline.hpp"
#include "baselines/separation_baseline.hpp"
#include "cli/fuzz/fuzz.hpp"
#include "cli/fuzz/fuzzer_options.hpp"
#include "cli/shared/command_line/common_options.hpp"
#include "cli/shared/command_line/judging_options.hpp"
#include "cli/shared/command_line/kind_check.hpp"
#include "cli/shared/command_line/number_options.hpp"
#include "cli/shared/command_line/output_names.hpp"
#include "cli/shared/words.hpp"
#include "fuzz/climb.hpp"
#include "fuzz/named_solvers.hpp"
#include "geometry/kind_aliases.hpp"
#include "io/queries/kind_of_file.hpp"
#include "io/times.hpp"

namespace touchstone::cli {
namespace {

std::optional<families::Family> family_from_name(const std::string& name) {
  const families::FamilyInfo* const family = families::find_family(name);
  return family != nullptr ? std::optional(family->family) : std::nullopt;
}

std::string curved_baselines() {
  std::string names;
  for (const auto& method : baselines::curved_methods()) {
    names.append(names.empty() ? "" : ", ").append(method.name);
  }
  return names;
}

std::string listed_families() {
  const auto names = [](const std::vector<families::FamilyInfo>& families) {
    std::vector<std::string_view> all;
    for (const families::FamilyInfo& family : families) all.push_back(family.name);
    return all;
  };
  return listed("Families:", names(families::all_families())) + listed("Curved:", names(families::curved_families()));
}

void add_solver_options(CLI::App& subcommand, FuzzCommandOptions& options) {
  std::string names;
  for (const auto name : fuzz::solver_names()) names.append(names.empty() ? "" : ", ").append(name);
  auto* const solver =
      subcommand
          .add_option("--solver", options.solver.solver,
                      "The solver under test: " + names + ", or the path of a plugin (default: touchstone)")
          ->type_name("NAME");
  add_command_option(subcommand, options.solver.command,
                     "The command line of a program under test, which is asked over pipes")
      ->excludes(solver);
  add_limit_option(subcommand, options.solver.limit,
                   "Seconds that a plugin or program may take for an answer (default: 1); after that it counts as "
                   "hanging");
  subcommand
      .add_option_function<std::string>(
          "--judge",
          [&options](const std::string& name) {
            options.settings.judge = from_name<Method>(name).value_or(options.settings.judge);
          },
          "The code whose answers count as true: exact, fast, oracle or fast-cgal; see solve --level (default: exact)")
      ->type_name("LEVEL")
      ->check(CLI::IsMember(all_names<Method>()));
  fuzz::Allowance& allowance = options.settings.allowance;
  add_time_limit(subcommand, "--early",
                 "The greatest distance of a claimed time before the exact time (default: any distance)",
                 [&allowance](const certify::TimeLimit& limit) { allowance.early = limit; });
  add_time_limit(subcommand, "--late",
                 "The greatest distance of a claimed time after the exact time that is no failure (default: none)",
                 [&allowance](const certify::TimeLimit& limit) { allowance.late = limit; });
  add_number(subcommand, "--near", allowance.near,
             "A contact that does not exist is no failure where the elements come within this part of the query's "
             "greatest coordinate of being in contact (default: 0)",
             "in [0, 1]", [](double x) { return x >= 0 && x <= 1; })
      ->type_name("F");
  add_class_option(
      subcommand, all_names<FuzzFailure>(),
      "Look for failures of these classes only, such as missed,late (default: all)",
      [&allowance](const std::string& name) { allowance.classes.push_back(*from_name<FuzzFailure>(name)); });
}

/// @returns the options that choose among the families
std::vector<CLI::Option*> add_source_options(CLI::App& subcommand, FuzzCommandOptions& options,
                                             std::vector<CLI::Option*>& of_search) {
  fuzz::Settings& settings = options.settings;
  CLI::Option* const family =
      subcommand
          .add_option_function<std::vector<std::string>>(
              "--family",
              [&settings](const std::vector<std::string>& names) {
                for (const auto& name : names) settings.families.push_back(*family_from_name(name));
              },
              "Only queries of this family (default: all; may be given more than once). Those of the curved families "
              "turn or move on curves")
          ->type_name("FAMILY")
          ->check([](const std::string& name) {
            return family_from_name(name) ? std::string() : name + " is no family; see touchstone fuzz --help";
          });
  of_search.push_back(family);
  of_search.push_back(
      subcommand
          .add_option_function<std::vector<std::string>>(
              "--kind",
              [&settings](const std::vector<std::string>& names) {
                for (const auto& name : names) settings.kinds.push_back(*geometry::kind_named(name));
              },
              "Only queries of this kind: " + io::kind_names() + " (default: all; may be given more than once)")
          ->type_name("KIND")
          ->check(kind_check()));
  CLI::Option* const curved =
      subcommand
          .add_flag("--curved", settings.curved,
                    "Queries of all curved families: corners of bodies that turn, and on curves. The "
                    "solvers for them are touchstone, exact, oracle, fast-cgal, batch, " +
                        curved_baselines())
          ->excludes(family);
  of_search.push_back(curved);
  for (CLI::Option* const option :
       add_search_options(subcommand, settings.seed, settings.cases, settings.seconds, "queries")) {
    of_search.push_back(option);
  }
  of_search.push_back(
      add_whole_number(subcommand, "--climb", settings.climb,
                       "The number of steps from every case towards queries on which the filters are only just "
                       "certain; each step is asked as well (default: 0)",
                       0, fuzz::kMostClimbSteps));
  return {family, curved};
}

}  // namespace

void add_fuzz(CLI::App& program, Command& command) {
  const auto options = std::make_shared<FuzzCommandOptions>();
  options->settings.threads = 0;
  options->settings.most_findings = 32;
  CLI::App* const subcommand =
      program.add_subcommand("fuzz", "Break a solver: the simplest queries on which it is wrong");
  add_solver_options(*subcommand, *options);
  std::vector<CLI::Option*> of_search;
  const std::vector<CLI::Option*> of_families = add_source_options(*subcommand, *options, of_search);
  auto* const a_case =
      subcommand
          ->add_option_function<std::string>(
              "--case", [options](const std::string& text) { options->a_case = fuzz::parse_case_text(text); },
              "Only this query, with its name from a finding: \"FAMILY KIND SEED INDEX\"")
          ->type_name("CASE")
          ->check([](const std::string& text) {
            return fuzz::parse_case_text(text) ? std::string()
                                               : text + " is no case; it must be \"FAMILY KIND SEED INDEX\"";
          });
  for (CLI::Option* const option : of_search) a_case->excludes(option);
  CLI::Option* const from =
      subcommand
          ->add_option(
              "--from", options->from,
              "Queries of these files, straight or curved, instead of families: each as it is, and with --climb also "
              "queries around it. The name of each file's folder is their kind, or that of a file such as 227ee.csv, "
              "or "
              "else the one --kind is")
          ->type_name("FILE");
  for (CLI::Option* const option : of_families) from->excludes(option);
  std::string with_separation;
  for (const auto& method : baselines::separation_methods()) {
    with_separation.append(with_separation.empty() ? "" : ", ").append(method.name);
  }
  add_separation_options(*subcommand, options->separation,
                         "The distance at which two elements are in contact. The solvers are then touchstone, exact, "
                         "oracle, fast-cgal, batch and, in the Euclidean metric, " +
                             with_separation + "; a plugin or program is told",
                         EachQuery::allowed);
  add_finding_options(*subcommand, options->out, "The folder for the shrunk failures", options->settings.most_findings,
                      options->settings.threads);
  subcommand->add_option("--html", options->html, "A page with a moving picture of each finding")
      ->type_name("PAGE.html")
      ->check(named_as(Output::page));
  subcommand->footer(
      "Makes seeded queries that are degenerate, nearly so, or extreme, asks the solver, and judges its replies:\n"
      "  missed   contact denied, but there is one          phantom    contact claimed, but there is none\n"
      "  late     its time lies after the exact one         early      its time lies farther before it than --early\n"
      "  nan      its time is no number                     malformed  an answer that cannot be read\n"
      "  crash, hang                                        differs    a whole answer (ours) differs in anything\n"
      "Failures of one class and one kind of degeneracy are one finding. Its simplest query is shrunk, and --out "
      "writes\n"
      "it to FOLDER/KIND/CLASS.csv (curved_CLASS.csv for a curved query), which certify and explain read. Files of\n"
      "earlier runs stay unless this run writes the same file. Ctrl-C ends the search and shows the findings so "
      "far.\n\n" +
      listed_families() +
      "\nExamples\n"
      "  touchstone fuzz --solver paper --seconds 10 --out broken\n"
      "  touchstone fuzz --solver touchstone --cases 1000000 --judge oracle\n"
      "  touchstone fuzz --solver touchstone --curved --cases 10000 --judge oracle\n"
      "  touchstone fuzz --solver redon --curved --cases 1000 --out broken\n"
      "  touchstone fuzz --solver newton --case \"near_hit edge-edge 1 17\"\n"
      "  touchstone fuzz --solver newton --climb 20 --from candidates/edge-edge/candidates.csv\n"
      "  touchstone fuzz --solver ./theirs.so --out broken          a plugin: see touchstone/plugin.h\n"
      "  touchstone fuzz --solver-command \"python3 theirs.py\"      see share/touchstone/examples\n\n"
      "Exit status: 0 no failure, 1 some failure, 2 bad usage or a file that cannot be written.");
  subcommand->callback([options, &command] { command = [options] { return run_fuzz(*options); }; });
}

}  // namespace touchstone::cli
