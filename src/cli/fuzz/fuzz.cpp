// SPDX-License-Identifier: MIT
#include "cli/fuzz/fuzz.hpp"

#include <fmt/format.h>

#include <algorithm>

#include <touchstone/error.hpp>

#include "cli/shared/findings/findings_report.hpp"
#include "cli/shared/findings/given.hpp"
#include "cli/shared/progress/interrupt.hpp"
#include "cli/shared/progress/pipeline.hpp"
#include "cli/shared/progress/progress_line.hpp"
#include "cli/shared/words.hpp"
#include "fuzz/run_case.hpp"
#include "io/output_file.hpp"

namespace touchstone::cli {
namespace {

constexpr double kUsualSeconds = 10;

/// @param summary  lines for the page
void print_findings(io::OutputFile& console, const std::string& summary, const std::vector<fuzz::Finding>& findings,
                    const FuzzCommandOptions& options) {
  std::vector<WrittenQuery> written(findings.size());
  if (!options.out.empty()) written = write_findings(findings, options);
  for (std::size_t i = 0; i < findings.size(); ++i) {
    console.write(finding_for_person(i + 1, findings[i], options, written[i]));
  }
  if (options.html.empty()) return;
  std::vector<view::FindingToShow> shown;
  for (std::size_t i = 0; i < findings.size(); ++i) shown.push_back(finding_to_show(findings[i], options, written[i]));
  const std::string solver = options.solver.command.empty() ? options.solver.solver : options.solver.command;
  write_findings_page(options.html, "findings about the solver " + solver, summary, shown);
}

int run_one_case(const FuzzCommandOptions& options, const fuzz::Settings& settings) {
  if (options.a_case->given != !options.from.empty()) {
    throw Error(options.a_case->given ? "--case: a given query needs the files that it was given in, with --from"
                                      : "--from goes with a case that is given, not with one of a family");
  }
  const auto solver = solver_factory(options.solver, options.separation)();
  const auto [finding, allowed] = fuzz::run_case(*solver, *options.a_case, settings, interrupted);
  auto console = io::OutputFile::standard_output();
  const std::string name = fuzz::case_text(*options.a_case);
  const std::string right = finding ? std::string()
                                    : fmt::format("{}: {} is {}\n", name, solver->name(),
                                                  allowed ? "wrong, which the options allow" : "right");
  console.write(right);
  std::vector<fuzz::Finding> findings;
  if (finding) findings.push_back(*finding);
  print_findings(console, finding ? name + '\n' : right, findings, options);
  console.commit();
  return finding ? kRefuted : kAllHold;
}

}  // namespace

int run_fuzz(const FuzzCommandOptions& options) {
  refuse_to_overwrite_given(options);
  check_outputs(options.out, options.html);
  fuzz::Settings settings = options.settings;
  settings.separation = options.separation.separation;
  settings.own_separations = options.separation.each;
  if (options.separation.each && !options.from.empty()) {
    throw Error(
        "--separation each goes with families, not with --from: the queries of files have no distance of their own");
  }
  if (!options.from.empty()) settings.given = given_queries(options);
  if (options.a_case) return run_one_case(options, settings);
  settings.threads = thread_count(settings.threads);
  if (!settings.cases && !settings.seconds && options.from.empty()) settings.seconds = kUsualSeconds;
  if (settings.seconds) settings.shrink_seconds = std::max(kUsualSeconds, *settings.seconds);

  fuzz::SearchOutcome outcome;
  {
    ProgressLine line;
    outcome =
        fuzz::run(solver_factory(options.solver, options.separation), settings, [&](const fuzz::Progress& progress) {
          line.draw([&] { return progress_for_person(progress); });
          return !interrupted();
        });
  }
  if (outcome.queries == 0 && !interrupted())
    throw Error("no query was asked in this time: more --seconds, or --cases");
  auto console = io::OutputFile::standard_output();
  std::string summary = search_for_person(options, outcome, settings.threads) + given_for_person(outcome) +
                        table_for_person(outcome.table);
  if (outcome.kinds_of_failure == 0) {
    summary += "nothing found";
  } else {
    const std::size_t shown = outcome.findings.size();
    summary += fmt::format(
        "{} of failure{}", outcome.kinds_of_failure == 1 ? "1 kind" : grouped(outcome.kinds_of_failure) + " kinds",
        shown < outcome.kinds_of_failure ? fmt::format("; {} shown (--findings 0 shows all)", shown) : "");
  }
  summary += allowed_for_person(options, outcome) + "\n";
  console.write(in_colour(summary, VerdictLine::last, outcome.kinds_of_failure == 0));
  print_findings(console, summary, outcome.findings, options);
  console.commit();
  return outcome.kinds_of_failure == 0 ? kAllHold : kRefuted;
}

}  // namespace touchstone::cli
