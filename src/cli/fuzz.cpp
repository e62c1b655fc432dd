// SPDX-License-Identifier: MIT
#include "cli/fuzz.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>

#include <touchstone/error.hpp>

#include "cli/fuzz_given.hpp"
#include "cli/fuzz_report.hpp"
#include "cli/interrupt.hpp"
#include "cli/new_folders.hpp"
#include "cli/words.hpp"
#include "fuzz/climb.hpp"
#include "fuzz/named_solvers.hpp"
#include "io/kind_of_file.hpp"
#include "io/output_file.hpp"
#include "io/times.hpp"

namespace touchstone::cli {
namespace {

constexpr double kUsualSeconds = 10;

/// A line on standard error, only when that is a terminal.
class ProgressLine {
 public:
  ~ProgressLine() {
    if (drawn_) print_error("\r\033[K");
  }
  void draw(const fuzz::Progress& progress) {
    if (!visible_) return;
    drawn_ = true;
    print_error("\r\033[K" + progress_for_person(progress));
  }

 private:
  const bool visible_ = ::isatty(STDERR_FILENO) == 1;
  bool drawn_ = false;
};

/// That nothing can be written to the folder is found out before minutes are spent, not after.
void check_folder(const std::string& out) {
  if (out.empty()) return;
  NewFolders folders;
  folders.make(out);
  io::OutputFile((std::filesystem::path(out) / "findings.csv").string());
}

void print_findings(io::OutputFile& console, const std::vector<fuzz::Finding>& findings, const FuzzOptions& options) {
  std::vector<Place> places(findings.size());
  if (!options.out.empty()) places = write_findings(findings, options);
  for (std::size_t i = 0; i < findings.size(); ++i) {
    console.write(finding_for_person(i + 1, findings[i], options, places[i]));
  }
}

int run_one_case(const FuzzOptions& options, const fuzz::Settings& settings) {
  if (options.a_case->given != !options.from.empty()) {
    throw Error(options.a_case->given ? "--case: a given query needs the files that it was given in, with --from"
                                      : "--from goes with a case that is given, not with one of a family");
  }
  const auto solver = solver_factory(options.solver)();
  const auto finding = fuzz::run_case(*solver, *options.a_case, settings, interrupted);
  auto console = io::OutputFile::standard_output();
  if (finding) {
    print_findings(console, {*finding}, options);
  } else {
    console.write(fmt::format("{}: {} is right\n", fuzz::case_text(*options.a_case), solver->name()));
  }
  console.commit();
  return finding ? kRefuted : kAllHold;
}

}  // namespace

int run_fuzz(const FuzzOptions& options) {
  refuse_to_overwrite_given(options);
  check_folder(options.out);
  fuzz::Settings settings = options.settings;
  if (!options.from.empty()) settings.given = given_queries(options);
  if (options.a_case) return run_one_case(options, settings);
  settings.threads = thread_count(settings.threads);
  if (!settings.cases && !settings.seconds && options.from.empty()) settings.seconds = kUsualSeconds;
  if (settings.seconds) settings.shrink_seconds = std::max(kUsualSeconds, *settings.seconds);

  fuzz::Outcome outcome;
  {
    ProgressLine line;
    outcome = fuzz::run(solver_factory(options.solver), settings, [&](const fuzz::Progress& progress) {
      line.draw(progress);
      return !interrupted();
    });
  }
  if (outcome.queries == 0 && !interrupted())
    throw Error("no query was asked in this time: more --seconds, or --cases");
  auto console = io::OutputFile::standard_output();
  console.write(search_for_person(options, outcome, settings.threads));
  console.write(given_for_person(outcome));
  console.write(table_for_person(outcome.table));
  if (outcome.kinds_of_failure == 0) {
    console.write("nothing found\n");
  } else {
    const std::size_t shown = outcome.findings.size();
    console.write(fmt::format(
        "{} of failure{}\n", outcome.kinds_of_failure == 1 ? "1 kind" : grouped(outcome.kinds_of_failure) + " kinds",
        shown < outcome.kinds_of_failure ? fmt::format("; {} shown (--findings 0 shows all)", shown) : ""));
  }
  print_findings(console, outcome.findings, options);
  console.commit();
  return outcome.kinds_of_failure == 0 ? kAllHold : kRefuted;
}

namespace {

constexpr std::uint64_t kMostNumber = 999'999'999'999'999'999;

std::string check_whole_number(const std::string& text, std::uint64_t least, std::uint64_t most = kMostNumber) {
  const bool number = !text.empty() && text.size() < 19 && text.find_first_not_of("0123456789") == std::string::npos;
  if (number && std::stoull(text) >= least && std::stoull(text) <= most) return {};
  return fmt::format("{} must be a whole number from {} to {}", text, least, most);
}

std::string check_seconds(const std::string& text) {
  const auto value = io::parse_finite_double(text);
  return value && *value > 0 && *value <= 1e9 ? std::string() : text + " must be a number of seconds above 0";
}

/// "16ulps", or a share of the step.
std::optional<fuzz::EarlyLimit> early_limit(const std::string& text) {
  constexpr std::string_view kUlps = "ulps";
  fuzz::EarlyLimit limit;
  if (text.ends_with(kUlps)) {
    const std::string number = text.substr(0, text.size() - kUlps.size());
    if (!check_whole_number(number, 0).empty()) return std::nullopt;
    limit.ulps = std::stoull(number);
    return limit;
  }
  limit.share = io::parse_finite_double(text);
  if (!limit.share || *limit.share < 0 || *limit.share > 1) return std::nullopt;
  return limit;
}

std::optional<families::Family> family_from_name(const std::string& name) {
  for (const families::FamilyInfo& family : families::all_families()) {
    if (family.name == name) return family.family;
  }
  return std::nullopt;
}

std::string listed_families() {
  std::string text, line = "Families:";
  for (const families::FamilyInfo& family : families::all_families()) {
    if (line.size() + family.name.size() > 108) {
      text += line + "\n";
      line = "         ";
    }
    line.append(" ").append(family.name);
  }
  return text + line + "\n";
}

void add_solver_options(CLI::App& subcommand, FuzzOptions& options) {
  std::string names;
  for (const auto name : fuzz::solver_names()) names.append(names.empty() ? "" : ", ").append(name);
  auto* const solver = subcommand
                           .add_option("--solver", options.solver.solver,
                                       "Who is asked: " + names + ", or the path of a plugin (default: touchstone)")
                           ->type_name("NAME");
  subcommand
      .add_option("--solver-command", options.solver.command,
                  "A program that is asked over pipes, as the shell would be told to run it")
      ->type_name("COMMAND")
      ->check([](const std::string& text) {
        const bool blank = text.find_first_not_of(" \t\n") == std::string::npos;
        return blank ? std::string("the command is empty; it must name a program") : std::string();
      })
      ->excludes(solver);
  subcommand
      .add_option_function<std::string>(
          "--limit", [&options](const std::string& text) { options.solver.limit = *io::parse_finite_double(text); },
          "How long a plugin or program may take for an answer (default: 1); then it hangs")
      ->type_name("S")
      ->check([](const std::string& text) {
        const auto value = io::parse_finite_double(text);
        return value && *value >= 0.001 && *value <= 3600 ? std::string()
                                                          : text + " must be a number of seconds from 0.001 to 3600";
      });
  subcommand
      .add_option_function<std::string>(
          "--judge",
          [&options](const std::string& name) {
            for (const Method method : {Method::fast, Method::exact, Method::oracle}) {
              if (name == method_name(method)) options.settings.judge = method;
            }
          },
          "Whose answers are the true ones: exact, fast or oracle; see solve --level (default: exact)")
      ->type_name("LEVEL")
      ->check(CLI::IsMember({"fast", "exact", "oracle"}));
  subcommand
      .add_option_function<std::string>(
          "--early", [&options](const std::string& text) { options.settings.early = *early_limit(text); },
          "How far before the exact time a claimed time may lie: 16ulps, or 1e-6 of the step (default: any distance)")
      ->type_name("LIMIT")
      ->check([](const std::string& text) {
        return early_limit(text) ? std::string()
                                 : text + " must be a number of ulps, 16ulps, or a share of the step in [0, 1]";
      });
}

/// @returns that of the families
CLI::Option* add_source_options(CLI::App& subcommand, FuzzOptions& options, std::vector<CLI::Option*>& of_search) {
  fuzz::Settings& settings = options.settings;
  of_search.push_back(subcommand
                          .add_option_function<std::vector<std::string>>(
                              "--family",
                              [&settings](const std::vector<std::string>& names) {
                                for (const auto& name : names) settings.families.push_back(*family_from_name(name));
                              },
                              "Only queries of this family (default: all; may be given more than once)")
                          ->type_name("FAMILY")
                          ->check([](const std::string& name) {
                            return family_from_name(name) ? std::string()
                                                          : name + " is no family; see touchstone fuzz --help";
                          }));
  of_search.push_back(
      subcommand
          .add_option_function<std::vector<std::string>>(
              "--kind",
              [&settings](const std::vector<std::string>& names) {
                for (const auto& name : names) settings.kinds.push_back(*io::kind_from_name(name));
              },
              "Only queries of this kind: " + io::kind_names() + " (default: all; may be given more than once)")
          ->type_name("KIND")
          ->check([](const std::string& name) {
            return io::kind_from_name(name) ? std::string() : name + " is no kind; it must be " + io::kind_names();
          }));
  const auto number = [&](const std::string& name, auto& value, std::uint64_t least, const std::string& about,
                          std::uint64_t most = kMostNumber) {
    of_search.push_back(
        subcommand.add_option(name, value, about)->type_name("N")->check([least, most](const std::string& text) {
          return check_whole_number(text, least, most);
        }));
  };
  number("--seed", settings.seed, 0, "Another seed, other queries (default: 1)");
  number("--cases", settings.cases, 1,
         "Ends after so many; with it alone the outcome is the same for any number of threads");
  of_search.push_back(
      subcommand
          .add_option_function<std::string>(
              "--seconds", [&settings](const std::string& text) { settings.seconds = io::parse_finite_double(text); },
              "Ends the search after so long; shrinking may take as long again (default: 10, unless "
              "--cases is given)")
          ->type_name("S")
          ->check(check_seconds));
  number("--climb", settings.climb, 0,
         "So many steps from every case towards queries on which the filters are only just certain, each asked as well "
         "(default: 0)",
         fuzz::kMostClimbSteps);
  return of_search.front();
}

}  // namespace

void add_fuzz(CLI::App& program, Command& command) {
  const auto options = std::make_shared<FuzzOptions>();
  options->settings.threads = 0;
  options->settings.most_findings = 32;
  CLI::App* const subcommand =
      program.add_subcommand("fuzz", "Break a solver: the simplest queries on which it is wrong");
  add_solver_options(*subcommand, *options);
  std::vector<CLI::Option*> of_search;
  CLI::Option* const family = add_source_options(*subcommand, *options, of_search);
  auto* const a_case =
      subcommand
          ->add_option_function<std::string>(
              "--case", [options](const std::string& text) { options->a_case = fuzz::parse_case_text(text); },
              "Only this query, named as the findings name it: \"FAMILY KIND SEED INDEX\"")
          ->type_name("CASE")
          ->check([](const std::string& text) {
            return fuzz::parse_case_text(text) ? std::string()
                                               : text + " is no case; it must be \"FAMILY KIND SEED INDEX\"";
          });
  for (CLI::Option* const option : of_search) a_case->excludes(option);
  subcommand
      ->add_option("--from", options->from,
                   "Queries of these files instead of families': each as it is, and with --climb what lies around it "
                   "(their kind is the name of the folder just above each file, or else the one --kind)")
      ->type_name("FILE")
      ->excludes(family);
  subcommand->add_option("--out", options->out, "A folder for the shrunk failures; it is made when it is not there")
      ->type_name("FOLDER");
  subcommand
      ->add_option("--findings", options->settings.most_findings,
                   "How many findings to shrink and show; 0: all (default: 32)")
      ->type_name("N")
      ->check([](const std::string& text) { return check_whole_number(text, 0); });
  subcommand
      ->add_option("--threads", options->settings.threads,
                   "How many threads to use (default: all that the machine has)")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  subcommand->footer(
      "Makes seeded queries that are degenerate, nearly so, or extreme, asks the solver, and judges what it says:\n"
      "  missed   contact denied, but there is one          phantom    contact claimed, but there is none\n"
      "  late     its time lies after the exact one         early      its time lies farther before it than --early\n"
      "  nan      its time is no number                     malformed  no answer that can be understood\n"
      "  crash, hang                                        differs    a whole answer (ours) differs in anything\n"
      "Failures of one class and one kind of degeneracy are one finding: the simplest query is kept and shrunk, to\n"
      "FOLDER/KIND/CLASS.csv with --out, where certify and explain read it; files of earlier runs stay unless they\n"
      "are written anew. Ctrl-C ends the search with what it has found.\n\n" +
      listed_families() +
      "\nExamples\n"
      "  touchstone fuzz --solver paper --seconds 10 --out broken\n"
      "  touchstone fuzz --solver touchstone --cases 1000000 --judge oracle\n"
      "  touchstone fuzz --solver newton --case \"near_hit edge-edge 1 17\"\n"
      "  touchstone fuzz --solver newton --climb 20 --from candidates/edge-edge/candidates.csv\n"
      "  touchstone fuzz --solver ./theirs.so --out broken          a plugin: see touchstone/plugin.h\n"
      "  touchstone fuzz --solver-command \"python3 theirs.py\"      see share/touchstone/examples\n\n"
      "Exit status: 0 nothing was found, 1 something was, 2 bad usage or a file that cannot be written.");
  subcommand->callback([options, &command] { command = [options] { return run_fuzz(*options); }; });
}

}  // namespace touchstone::cli
