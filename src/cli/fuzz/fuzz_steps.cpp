// SPDX-License-Identifier: MIT
#include "cli/fuzz/fuzz_steps.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <vector>

#include <touchstone/error.hpp>

#include "cli/fuzz/found_steps.hpp"
#include "cli/shared/new_folders.hpp"
#include "cli/shared/progress/interrupt.hpp"
#include "cli/shared/progress/pipeline.hpp"
#include "cli/shared/progress/progress_line.hpp"
#include "cli/shared/words.hpp"
#include "fuzz/bodies/fuzz_bodies.hpp"
#include "fuzz/steps/fuzz_steps.hpp"
#include "io/counted.hpp"
#include "io/fail.hpp"
#include "io/output_file.hpp"

namespace touchstone::cli {
namespace {

constexpr double kUsualStepSeconds = 10;

/// Where the files of a finding are, without their endings.
std::string path_in(const std::string& folder, const FoundStep& step) {
  return (std::filesystem::path(folder) / step.name).string();
}

void write_steps(const std::string& folder, const std::vector<FoundStep>& all) {
  NewFolders folders;
  folders.make(folder);
  std::vector<io::OutputFile> files;
  for (const FoundStep& step : all) {
    for (const auto& [ending, text] : step.files) files.emplace_back(path_in(folder, step) + ending).write(text);
  }
  for (io::OutputFile& file : files) file.commit();
  folders.keep();
}

/// The command that asks about the step before it was shrunk.
std::string repeat_command(const FuzzStepsOptions& options, const std::string& case_name) {
  std::string text = "  touchstone fuzz-steps";
  if (options.bodies) text += " --bodies";
  if (!options.command.empty()) text += " --solver-command " + shell_word(options.command);
  if (!options.plugin.empty()) text += " --solver " + shell_word(options.plugin);
  if (options.limit != FuzzStepsOptions().limit) text += fmt::format(" --limit {}", options.limit);
  if (!options.search.separations) text += " --no-separation";
  if (!options.search.groups) text += " --no-groups";
  if (options.search.may_end_in_contact) text += " --may-end-in-contact";
  if (!options.search.twice) text += " --once";
  if (options.search.early_fraction) text += fmt::format(" --early {}", *options.search.early_fraction);
  if (options.search.late_fraction > 0) text += fmt::format(" --late {}", options.search.late_fraction);
  return text + " --case " + shell_word(case_name) + "\n";
}

}  // namespace

int run_fuzz_steps(const FuzzStepsOptions& options) {
  StepFuzzOptions search = options.search;
  search.threads = thread_count(search.threads);
  if (options.cases) search.cases = *options.cases;
  if (!options.cases && !search.seconds) search.seconds = kUsualStepSeconds;
  if (options.bodies && !options.plugin.empty()) {
    throw Error("--solver is for steps of a mesh; --bodies asks a program: --solver-command");
  }
  if (options.cases && search.seconds) throw Error("--cases and --seconds both end the search: give one of them");
  FoundSteps outcome;
  {
    ProgressLine line;
    outcome = find_steps(options, search, [&](std::uint64_t steps) {
      line.draw([&] { return fmt::format("{} steps", grouped(steps)); });
      return !interrupted();
    });
  }
  if (outcome.steps == 0 && !interrupted()) throw Error("no step was asked in this time: more --seconds, or --cases");
  const std::vector<FoundStep>& findings = outcome.found;
  if (!options.out.empty() && !findings.empty()) write_steps(options.out, findings);
  const std::string who = io::printable(!options.command.empty()  ? options.command
                                        : !options.plugin.empty() ? options.plugin
                                                                  : "touchstone");
  std::string left_out;
  const std::vector<std::string> never_asked =
      options.bodies ? fuzz::left_out_of_bodies(search) : fuzz::left_out_by(search);
  for (const std::string& what : never_asked) left_out += "; " + what + " were left out";
  if (options.bodies) left_out += "; intersections at the start were not asked about";
  std::string summary =
      fmt::format("{}: {} asked, {} with a wrong reply{}{}\n", who, io::counted(outcome.steps, "step"),
                  grouped(outcome.failures), left_out, outcome.stopped ? "; interrupted" : "");
  const std::size_t kinds = outcome.kinds_of_failure;
  summary +=
      kinds == 0 ? "nothing found\n" : fmt::format("{} of failure", kinds == 1 ? "1 kind" : grouped(kinds) + " kinds");
  if (kinds > findings.size()) summary += fmt::format("; {} shown (--findings 0 shows all)", findings.size());
  if (kinds > 0) summary += "\n";
  auto console = io::OutputFile::standard_output();
  console.write(in_colour(summary, VerdictLine::last, kinds == 0));
  for (const FoundStep& step : findings) {
    console.write("\n" + step.text + repeat_command(options, step.case_name));
    if (!options.out.empty()) console.write(step.show(path_in(options.out, step)));
  }
  console.commit();
  return kinds == 0 ? kAllHold : kRefuted;
}

}  // namespace touchstone::cli
